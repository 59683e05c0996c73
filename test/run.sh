#!/usr/bin/env bash
# Passes the tests, from a bare Debian 12 if need be: installs what is missing, builds everything, runs CTest.
# Usage: test/run.sh [CTest options, such as -R complex]
set -euo pipefail
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
"$top/package_info/Multiplanar/install_packages.sh" --for-tests

build=$top/build-test
cmake -G Ninja -S "$top" -B "$build" -DCMAKE_BUILD_TYPE=Release \
      -DCMAKE_CXX_COMPILER_LAUNCHER=ccache > /dev/null
cmake --build "$build"

[ -d "$build/data" ] || tar -xzf /usr/share/doc/libcgal-dev/data.tar.gz -C "$build"
export MULTIPLANAR_CGAL_DATA=$build/data
ctest --test-dir "$build" --output-on-failure -j "$(nproc)" "$@"
