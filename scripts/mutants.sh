#!/usr/bin/env bash
# Changes one place of the oracle, or of the engine's arithmetic, at a time, runs the tests, and adds the outcomes to
# evidence/mutants.json. cargo-mutants says which mutants there are, mutation/ tries them in one build, and cargo-mutants
# those that do not go into it. Tried are the sources that have changed since their mutants were tried; rm
# evidence/mutants.json tries all. With `--only TEXT` only the mutants with this in their names are tried, as after an
# example that should catch a survivor; other arguments go to mutation/ (--jobs 2).
set -euo pipefail
cd "$(dirname "$0")/.."
exec </dev/null

work=${CARGO_TARGET_DIR:-target}/mutation
output=$(mktemp -d)
trap 'rm -rf "$output"' EXIT
condense() { cargo run --locked --quiet --example condense_evidence -- "$@"; }
condense state mutants >"$output/state.json"

only=()
case " $* " in
*" --only "*) ;;
*)
    while read -r file; do only+=(--only "$file"); done < <(condense untried)
    [ ${#only[@]} -gt 0 ] || { echo "every source has been tried" >&2; exit 0; }
    ;;
esac

outcomes=()
lists=()
declare -A first=([turnspec-oracle]=book [turnspec]=rules)
declare -A thorough=(
    [turnspec-oracle]='--lib --tests'
    [turnspec]='--lib --test rules --test differential --test tables'
)
declare -A also=([turnspec-oracle]='' [turnspec]='--test-package turnspec,turnspec-proofs')
declare -A sources=([turnspec-oracle]='spec/src/**/*.rs' [turnspec]='src/engine/arithmetic/*.rs')

# Tries the mutants that a file names, by cargo-mutants: by file too, since version 27 does not look at the names of mutants
# that delete a field. With a CARGO_TARGET_DIR its jobs would wait for each other. Status 2 is a survivor, 3 a time-out:
# outcomes both.
round() {
    local output=$1 file=$2 names=() name status=0
    shift 2
    [ -s "$file" ] || return 0
    while read -r name; do
        names+=(--file "${name%%:*}" --re "^$(sed 's/[][\\.*^$(){}?+|]/\\&/g' <<<"$name")\$")
    done <"$file"
    mkdir -p "$output"
    env -u CARGO_TARGET_DIR cargo mutants --jobs 2 --output "$output" "${names[@]}" "$@" || status=$?
    case $status in 0 | 2 | 3) ;; *) exit "$status" ;; esac
    outcomes+=("$output/mutants.out/outcomes.json")
}

for package in turnspec-oracle turnspec; do
    of=$output/$package
    mkdir "$of"
    cargo mutants -p "$package" --file "${sources[$package]}" --list --json >"$of/list.json"
    lists+=(--list "$of/list.json")
    cargo run --locked --quiet -p turnspec-mutation -- --package "$package" --list "$of/list.json" \
        --work "$work/$package" --version "$(cargo mutants --version | cut -d' ' -f2)" \
        --outcomes "$of/built.json" "${only[@]}" "$@" >"$of/left.txt"
    outcomes+=("$of/built.json")
    # What is left: the tests that catch most, and what they let live with all of them.
    round "$of/examples" "$of/left.txt" -p "$package" "--cargo-arg=--test" "--cargo-arg=${first[$package]}"
    # shellcheck disable=SC2086
    round "$of/all" "$of/examples/mutants.out/missed.txt" -p "$package" ${also[$package]} -- ${thorough[$package]}
done

mkdir -p evidence
condense mutants "${outcomes[@]}" --state "$output/state.json" "${lists[@]}" >evidence/mutants.json.new
mv evidence/mutants.json.new evidence/mutants.json
