#!/usr/bin/env bash
# Changes one place of the oracle at a time and runs its tests (cargo-mutants), and adds the outcomes to
# evidence/mutants.json. A first round runs the examples of the rule texts (.cargo/mutants-examples.toml), a second
# one all tests on what survived (.cargo/mutants.toml). Tried are the sources that have changed since their
# mutants were tried, two or three seconds a mutant; rm evidence/mutants.json tries all. Arguments go to
# cargo-mutants (`--jobs 2`; `--shard 0/16 --sharding round-robin` for a sample, what is left is said); with `--file`
# or `--re` among them only these mutants are tried, as after an example that should catch a survivor. With
# OUTCOMES="FILE…" the outcomes of shards are added and nothing is run.
set -euo pipefail
cd "$(dirname "$0")/.."
exec </dev/null

state=$(mktemp)
output=$(mktemp -d)
trap 'rm -rf "$state" "$output"' EXIT
condense() { cargo run --locked --quiet --example condense_evidence -- "$@"; }
condense state mutants >"$state"
cargo mutants -p turnspec-oracle --list --json >"$output/list.json"

if [ -n "${OUTCOMES:-}" ]; then
    read -ra outcomes <<<"$OUTCOMES"
else
    files=()
    case " $* " in
    *" --file "* | *" --re "*) ;;
    *)
        while read -r file; do files+=(--file "$file"); done < <(condense untried)
        [ ${#files[@]} -gt 0 ] || { echo "every source has been tried" >&2; exit 0; }
        ;;
    esac
    # Status 2 is a survivor, 3 a time-out: outcomes both. Sources without a mutant leave no outcomes.
    outcomes=()
    round() {
        local status=0 outcome="$output/${#outcomes[@]}.json"
        cargo mutants -p turnspec-oracle --output "$output" "$@" || status=$?
        case $status in 0 | 2 | 3) ;; *) exit "$status" ;; esac
        cp "$output/mutants.out/outcomes.json" "$outcome" 2>/dev/null || echo '{"outcomes": []}' >"$outcome"
        outcomes+=("$outcome")
    }
    round --config .cargo/mutants-examples.toml "${files[@]}" "$@"
    # By name: a shard of what is left would be of other mutants. (By file too: cargo-mutants 27 does not look at the names
    # of mutants that delete a field.)
    others=()
    while [ $# -gt 0 ]; do
        case $1 in
        --shard | --sharding | --re | --file) shift 2 ;;
        *) others+=("$1") && shift ;;
        esac
    done
    names=()
    while read -r name; do
        names+=(--file "${name%%:*}" --re "^$(sed 's/[][\\.*^$(){}?+|]/\\&/g' <<<"$name")\$")
    done < <(cat "$output/mutants.out/missed.txt" 2>/dev/null)
    [ ${#names[@]} -eq 0 ] || round "${names[@]}" "${others[@]}"
fi

mkdir -p evidence
condense mutants "${outcomes[@]}" --state "$state" --list "$output/list.json" >evidence/mutants.json.new
mv evidence/mutants.json.new evidence/mutants.json
