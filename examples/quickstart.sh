#!/usr/bin/env bash
# From a bare Debian 12 to a plywood bunny: installs what is missing, builds the program, and turns the Stanford bunny
# that Debian's libcgal-demo ships into 45 flat panels and the sheets to cut them from.
# Usage: examples/quickstart.sh [OUTPUT_DIRECTORY]     (default: out/bunny)
set -euo pipefail
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
out=${1:-$top/out/bunny}
"$top/package_info/Multiplanar/install_packages.sh"

build=$top/build
cmake -G Ninja -S "$top" -B "$build" -DCMAKE_BUILD_TYPE=Release -DMULTIPLANAR_TESTS=OFF -DMULTIPLANAR_EXAMPLES=OFF \
      -DCMAKE_CXX_COMPILER_LAUNCHER=ccache > /dev/null
cmake --build "$build" --target multiplanar

model=$build/data/meshes/bunny00.off
[ -f "$model" ] || { mkdir -p "$build/data"; tar -xzf /usr/share/doc/libcgal-dev/data.tar.gz -C "$build"; }
mkdir -p "$(dirname "$out")"
"$build/bin/multiplanar" make "$model" -o "$out" -k 45
