#!/usr/bin/env bash
# Writes evidence/licences.json: the licence that each package of Cargo.lock states in its manifest. The lock
# file has none, and the audit reads nothing but the tree.
set -euo pipefail
cd "$(dirname "$0")/.."
exec </dev/null

metadata=$(mktemp)
trap 'rm -f "$metadata"' EXIT
cargo metadata --format-version 1 --locked >"$metadata"
mkdir -p evidence
cargo run --locked --quiet --example condense_evidence -- licences "$metadata" >evidence/licences.json.new
mv evidence/licences.json.new evidence/licences.json
