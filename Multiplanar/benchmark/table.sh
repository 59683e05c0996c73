#!/usr/bin/env bash
# Copyright (c) 2026 The Multiplanar authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The table of README: seconds of each stage by faces and by k, memory, exponents of growth, CGAL's methods beside it.
# Usage: table.sh [MESH ...]     the same surface at several sizes, small ones first; the second is used for the table by k
# Without meshes: the bunny of Debian's libcgal-demo, brought to 2,000, 10,000 and 50,000 faces.
# BUILD: the build directory (build); it is configured for benchmarks, and the benchmark is built. EFFORT (fast).
set -euo pipefail
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=${BUILD:-$top/build} effort=${EFFORT:-fast}
cmake -G Ninja -S "$top" -B "$build" -DCMAKE_BUILD_TYPE=Release -DMULTIPLANAR_BENCHMARKS=ON > /dev/null
cmake --build "$build" --target stage_benchmark > /dev/null
run=("$build/bin/stage_benchmark" --effort "$effort")
if [ $# -gt 0 ]; then
  "${run[@]}" --k 50 "$@"
  "${run[@]}" --k 10,30,50,70,90 "${2:-$1}"
else
  work=$(mktemp -d)
  trap 'rm -rf "$work"' EXIT
  tar -xzf /usr/share/doc/libcgal-dev/data.tar.gz -C "$work" data/meshes/bunny00.off
  "${run[@]}" --k 50 --sizes 2000,10000,50000 "$work/data/meshes/bunny00.off"
  "${run[@]}" --k 10,30,50,70,90 --sizes 10000 "$work/data/meshes/bunny00.off"
fi
