#!/usr/bin/env bash
# Measures which lines, regions and branches of the oracle and of the engine the tests reach, and condenses
# that into evidence/coverage.json. Needs cargo-llvm-cov, and the LLVM tools: either the component
# `llvm-tools`, or those of a distribution with the LLVM version of the compiler (`rustc -vV`; on Debian
# the package llvm-22), which LLVM_COV and LLVM_PROFDATA name.
# Branches need a nightly compiler; without one they are left out, and the audit says so.
set -euo pipefail
cd "$(dirname "$0")/.."
exec </dev/null

for tool in cov profdata; do
    variable=LLVM_${tool^^}
    if [ -z "${!variable:-}" ] && command -v "llvm-$tool-22" >/dev/null; then
        export "$variable=$(command -v "llvm-$tool-22")"
    fi
done

toolchain=()
branches=()
if cargo +nightly --version >/dev/null 2>&1; then
    toolchain=(+nightly)
    branches=(--branch)
fi

report=$(mktemp)
before=$(mktemp)
trap 'rm -f "$report" "$before"' EXIT
cargo run --locked --quiet --example condense_evidence -- state coverage >"$before"

measure() { cargo "${toolchain[@]}" llvm-cov "${branches[@]}" --locked --no-report "$@"; }
cargo "${toolchain[@]}" llvm-cov clean --workspace
measure -p turnspec-oracle
measure -p turnspec-conformance
measure -p turnspec --lib --test rules --test tables --test differential
cargo "${toolchain[@]}" llvm-cov report "${branches[@]}" -p turnspec-oracle -p turnspec --json --output-path "$report"

mkdir -p evidence
tools=(--tool "$(cargo llvm-cov --version)" --tool "$(rustc "${toolchain[@]}" --version)")
if [ -n "${LLVM_COV:-}" ]; then
    tools+=(--tool "llvm-cov $("$LLVM_COV" --version | grep -o '[0-9][0-9.]*' | head -n 1)")
fi
cargo run --locked --quiet --example condense_evidence -- coverage "$report" --state "$before" "${tools[@]}" \
    >evidence/coverage.json.new
mv evidence/coverage.json.new evidence/coverage.json
