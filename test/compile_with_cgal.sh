#!/usr/bin/env bash
# Do the headers compile with another version of CGAL? Compiles every public header, the whole approximation for
# Surface_mesh and Polyhedron_3, and the comparison with CGAL's own methods, against the CGAL headers at PATH.
# Usage: test/compile_with_cgal.sh PATH
#   PATH: the folder that has CGAL/version.h or include/CGAL/version.h (a release), or a clone of CGAL's repository.
# CXX: the compiler (c++). Nothing is linked or run.
set -euo pipefail
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
[ $# -eq 1 ] || { sed -n '2,6s/^# \{0,1\}//p' "$0" >&2; exit 2; }
includes=()
if [ -f "$1/CGAL/version.h" ]; then includes=(-I "$1")
elif [ -f "$1/include/CGAL/version.h" ]; then includes=(-I "$1/include")
else for folder in "$1"/*/include; do [ -d "$folder/CGAL" ] && includes+=(-I "$folder"); done; fi
[ ${#includes[@]} -gt 0 ] || { echo "$1: no CGAL headers there (CGAL/version.h)" >&2; exit 3; }

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
{
  (cd "$top/Multiplanar/include" && find CGAL -name '*.h' -not -path '*/internal/*' | sort | sed 's/.*/#include <&>/')
  echo "#include \"$top/Multiplanar/comparison/other_methods.h\""
  echo "#include \"$top/Multiplanar/comparison/surface_quality.h\""
  echo '#include <cstdio>'
  echo 'int main() { std::puts(CGAL_VERSION_STR); }'
} > "$work/all_headers.cpp"
for source in "$work/all_headers.cpp" "$top"/examples/Multiplanar/{approximate,polyhedron}.cpp; do
  echo "$(basename "$source")"
  "${CXX:-c++}" -std=c++17 -fsyntax-only -DNDEBUG -DCGAL_USE_GMPXX=1 "${includes[@]}" -I "$top/Multiplanar/include" \
    -I /usr/include/eigen3 -isystem /usr/include/suitesparse "$source"
done
echo "compiles with CGAL $(sed -n 's/^#define CGAL_VERSION \([0-9].*\)/\1/p' "${includes[1]}"/CGAL/version.h 2>/dev/null || echo "at $1")"
