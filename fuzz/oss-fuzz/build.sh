#!/bin/bash -eu
# Builds every fuzz target into $OUT, each with its first inputs and the dictionary. Runs in the image of OSS-Fuzz and in
# that of ClusterFuzzLite; $SRC/turnspec is the repository.
cd "$SRC/turnspec"

# Assertions on: an overflow is a finding.
cargo fuzz build -O --debug-assertions

# The flags of fuzzed code are not for a tool that runs here.
env -u RUSTFLAGS -u CFLAGS -u CXXFLAGS cargo run --locked -p turnspec-properties --example seed_corpus

for target in $(cargo fuzz list); do
    cp "fuzz/target/x86_64-unknown-linux-gnu/release/$target" "$OUT/"
    cp fuzz/dictionary.txt "$OUT/$target.dict"
    zip -q -j -r "$OUT/${target}_seed_corpus.zip" "fuzz/corpus/$target"
done
