#!/usr/bin/env bash
# Builds the program and tests with AddressSanitizer and UndefinedBehaviorSanitizer and runs them.
# Usage: test/sanitize.sh [TARGETS...]    (tests; default: those of readers, fuzzing and repair, and one `make`)
# BUILD: the build folder (build-sanitize beside test/); JOBS: files compiled at a time (1). Any report of a
# sanitizer ends the run with an error.
set -euo pipefail
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${BUILD:-$top/build-sanitize}
[ $# -gt 0 ] || set -- test_program_input test_program_fuzz test_program_repair
# -O1 and no debug information: the templates take too much memory and time otherwise.
cmake -G Ninja -S "$top" -B "$build" -DCMAKE_BUILD_TYPE=None -DMULTIPLANAR_EXAMPLES=OFF \
      -DCMAKE_CXX_COMPILER_LAUNCHER=ccache \
      -DCMAKE_CXX_FLAGS="-O1 -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer" > /dev/null
cmake --build "$build" -j "${JOBS:-1}" --target multiplanar "$@" # a file takes up to 3 GB

export ASAN_OPTIONS=allocator_may_return_null=0:detect_leaks=0:exitcode=99
export UBSAN_OPTIONS=print_stacktrace=1:exitcode=99:suppressions=$top/test/ubsan_suppressions.txt
for test; do
  "$build/bin/$test"
done
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
printf 'OFF\n4 4 0\n1 1 1\n1 -1 -1\n-1 1 -1\n-1 -1 1\n3 0 1 2\n3 0 3 1\n3 0 2 3\n3 1 3 2\n' > "$folder/m.off"
"$build/bin/multiplanar" make "$folder/m.off" -o "$folder/out" -k 4 --effort fast --quiet
"$build/bin/multiplanar" verify "$folder/out" > /dev/null
echo "sanitizers: nothing found"
