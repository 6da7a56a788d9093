#!/usr/bin/env bash
# Installs LinuxCNC's stand-alone interpreter `rs274` (Debian package linuxcnc-uspace), which the throughput
# benchmark times beside ours, and which conformance/adapters/rs274 compares with ours, when it is there.
set -euo pipefail

if command -v rs274 >/dev/null; then
    echo "rs274 is installed: $(command -v rs274)"
    exit 0
fi

as_root=()
[ "$(id -u)" -eq 0 ] || as_root=(sudo)
"${as_root[@]}" apt-get update
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install --yes --no-install-recommends linuxcnc-uspace
command -v rs274
