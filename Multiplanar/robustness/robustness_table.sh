#!/bin/sh
# Copyright (c) 2026 The Multiplanar authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The robustness suite over a folder of meshes: a table of what became of each.
#
#   robustness_table.sh FOLDER TABLE.tsv [CHAPTER.txt]
#
# Every .off, .obj, .stl, .ply and .glb file of FOLDER goes through `multiplanar_robustness`, the small ones first. The
# table is written as TSV while the suite runs; meshes that stand in it already are left out, so that an interrupted run
# can be repeated. With CHAPTER, the table takes the place of what stands there between the lines `TABLE BEGIN` and
# `TABLE END`.
#
# SUITE: the binary (build/bin/multiplanar_robustness); OPTIONS: more options for it, such as "-k 40 --seconds 600";
# JOBS: how many at a time (1).
#
# Exit code 0 only if every mesh kept all promises or was rightly refused.
set -u
[ $# -ge 2 ] || { sed -n '4,19s/^# \{0,1\}//p' "$0" >&2; exit 2; }
folder=$1 table=$2 chapter=${3:-}
suite=${SUITE:-build/bin/multiplanar_robustness}
[ -s "$table" ] || "$suite" --header > "$table" || exit 2

find "$folder" -maxdepth 1 -type f \( -name '*.off' -o -name '*.obj' -o -name '*.stl' -o -name '*.ply' -o -name '*.glb' \) \
  -printf '%s\t%p\n' | sort -n | cut -f2 |
while IFS= read -r mesh; do
  cut -f1 "$table" | grep -Fqx "$(basename "$mesh")" || printf '%s\0' "$mesh"
done | SUITE=$suite TABLE=$table xargs -0 -r -n 1 -P "${JOBS:-1}" sh -c '
  line=$("$SUITE" "$1" '"${OPTIONS:-}"' 2>/dev/null)
  code=$?
  [ -n "$line" ] || line="$(basename "$1")	-	-	-	-	-	-	-	suite failed	exit code $code"
  printf "%s\n" "$line" >> "$TABLE"' sh

[ -z "$chapter" ] || python3 "$(dirname "$0")/robustness_chapter.py" "$table" "$chapter" || exit 4
tail -n +2 "$table" | cut -f9 | grep -vqx -e kept -e refused && exit 1
exit 0
