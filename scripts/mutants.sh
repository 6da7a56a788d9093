#!/usr/bin/env bash
# Changes one place of the oracle at a time and runs its tests (cargo-mutants; .cargo/mutants.toml says which
# tests), then condenses the outcomes into evidence/mutants.json. Arguments go to cargo-mutants (`--jobs 2`).
# Takes an hour or two. With OUTCOMES="FILE…" the outcomes of shards are condensed and nothing is run.
set -euo pipefail
cd "$(dirname "$0")/.."
exec </dev/null

state=$(mktemp)
output=$(mktemp -d)
trap 'rm -rf "$state" "$output"' EXIT
condense() { cargo run --locked --quiet --example condense_evidence -- "$@"; }
condense state mutants >"$state"

if [ -n "${OUTCOMES:-}" ]; then
    read -ra outcomes <<<"$OUTCOMES"
else
    # Status 2 is a survivor, 3 a time-out: outcomes both.
    status=0
    cargo mutants -p turnspec-oracle --output "$output" "$@" || status=$?
    case $status in 0 | 2 | 3) ;; *) exit "$status" ;; esac
    outcomes=("$output/mutants.out/outcomes.json")
fi

mkdir -p evidence
condense mutants "${outcomes[@]}" --state "$state" >evidence/mutants.json.new
mv evidence/mutants.json.new evidence/mutants.json
