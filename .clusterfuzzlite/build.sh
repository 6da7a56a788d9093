#!/bin/bash -eu
# Builds the fuzz targets as OSS-Fuzz does.
exec bash -eu "$SRC/turnspec/fuzz/oss-fuzz/build.sh"
