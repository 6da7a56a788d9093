#!/usr/bin/env bash
# Changes one place of the oracle at a time and runs its tests, and adds the outcomes to evidence/mutants.json.
# cargo-mutants says which mutants there are, mutation/ tries them in one build, and cargo-mutants what does not go into it.
# Tried are the sources that have changed since their mutants were tried; rm evidence/mutants.json tries all. With
# `--only TEXT` only the mutants with this in their names are tried, as after an example that should catch a survivor.
set -euo pipefail
cd "$(dirname "$0")/.."
exec </dev/null

work=${MUTATION_WORK:-${CARGO_TARGET_DIR:-target}/mutation}
output=$(mktemp -d)
trap 'rm -rf "$output"' EXIT
condense() { cargo run --locked --quiet --example condense_evidence -- "$@"; }
condense state mutants >"$output/state.json"
cargo mutants -p turnspec-oracle --list --json >"$output/list.json"

only=()
case " $* " in
*" --only "*) ;;
*)
    while read -r file; do only+=(--only "$file"); done < <(condense untried)
    [ ${#only[@]} -gt 0 ] || { echo "every source has been tried" >&2; exit 0; }
    ;;
esac
cargo run --locked --quiet -p turnspec-mutation -- --list "$output/list.json" --work "$work" \
    --version "$(cargo mutants --version | cut -d' ' -f2)" --outcomes "$output/built.json" "${only[@]}" "$@" >"$output/left.txt"
outcomes=("$output/built.json")

# What is left, by name (by file too: cargo-mutants 27 does not look at the names of mutants that delete a field). With a
# CARGO_TARGET_DIR its jobs would wait for each other. Status 2 is a survivor, 3 a time-out: outcomes both.
names=()
while read -r name; do
    names+=(--file "${name%%:*}" --re "^$(sed 's/[][\\.*^$(){}?+|]/\\&/g' <<<"$name")\$")
done <"$output/left.txt"
if [ ${#names[@]} -gt 0 ]; then
    status=0
    env -u CARGO_TARGET_DIR cargo mutants -p turnspec-oracle --jobs 2 --output "$output" "${names[@]}" || status=$?
    case $status in 0 | 2 | 3) ;; *) exit "$status" ;; esac
    outcomes+=("$output/mutants.out/outcomes.json")
fi

mkdir -p evidence
condense mutants "${outcomes[@]}" --state "$output/state.json" --list "$output/list.json" >evidence/mutants.json.new
mv evidence/mutants.json.new evidence/mutants.json
