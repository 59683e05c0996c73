#!/bin/sh
# Copyright (c) 2026 The Multiplanar authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# From meshes to parts that are verified: a line a mesh.
#
#   fabrication_table.sh FOLDER [SHELLS]
#
# For every *_10k.off in FOLDER (all *.off if there is none): the approximation by 50 panels, parts 300 mm long of 3 mm
# sheet, their digital assembly. Shells that stand in the folder SHELLS already are used again; new ones are put there.
#
# MULTIPLANAR: the program (build/bin/multiplanar); K, SIZE, THICKNESS, EFFORT, JOINTS: what to ask for; THREADS.
#
# Columns: panels; edges with connectors, with teeth, with nothing; the share of the length of the edges longer than 5
# thicknesses that is joined, and of all edges; parts; warnings; processor seconds of `fabricate`; what `verify` says.
set -u
[ $# -ge 1 ] || { sed -n '4,16s/^# \{0,1\}//p' "$0" >&2; exit 2; }
folder=$1
program=${MULTIPLANAR:-build/bin/multiplanar}
k=${K:-50} size=${SIZE:-300} thickness=${THICKNESS:-3} effort=${EFFORT:-normal} joints=${JOINTS:-auto} threads=${THREADS:-0}
work=$(mktemp -d) || exit 4
trap 'rm -rf "$work"' EXIT
shells=${2:-$work}
mkdir -p "$shells" || exit 4
set -- "$folder"/*_10k.off
[ -e "$1" ] || set -- "$folder"/*.off
[ -e "$1" ] || { echo "$folder: no OFF files" >&2; exit 3; }

printf '%-18s %6s %5s %5s %5s %6s %6s %5s %5s %6s  %s\n' mesh panels conn. teeth none '>5t' all parts warn. s verify
failed=0
for mesh; do
  name=$(basename "$mesh" .off)
  shell=$shells/$name-$k.ply
  if [ ! -e "$shell" ] &&
     ! "$program" approximate "$mesh" -o "$shell" -k "$k" --effort "$effort" --threads "$threads" --quiet 2>"$work/error"
  then
    printf '%-18s %s\n' "$name" "$(cat "$work/error")"
    failed=1
    continue
  fi
  # The shell's `times` prints minutes and seconds: the last line is that of the children.
  ( "$program" fabricate "$shell" -o "$work/out" --size "$size" --thickness "$thickness" --joints "$joints" \
      --quiet 2>"$work/error"; echo $? >"$work/code"; times >"$work/times" )
  if [ "$(cat "$work/code")" != 0 ]; then
    printf '%-18s %s\n' "$name" "$(cat "$work/error")"
    failed=1
    continue
  fi
  "$program" verify "$work/out" >"$work/verify" 2>/dev/null && verdict=ok ||
    { verdict="$(grep -c '^violation' "$work/verify") violations"; failed=1; }
  python3 - "$work" "$name" "$verdict" <<'PYTHON'
import json, math, re, sys
work, name, verdict = sys.argv[1:]
model, report = json.load(open(work + "/out/model.json")), json.load(open(work + "/out/report.json"))
corners, least = model["corners"], 5 * model["settings"]["thickness"]
count, total, joined = {"connector": 0, "teeth": 0, "none": 0}, [0, 0], [0, 0]
for edge in model["edges"]:
    length = math.dist(*(corners[c] for c in edge["corners"]))
    count[edge["joint"]] += 1
    for i, counts in enumerate((length > least, True)):
        total[i] += length * counts
        joined[i] += length * (counts and edge["joint"] != "none")
times = re.findall(r"(\d+)m([\d.]+)s", open(work + "/times").read())[-2:]
seconds = sum(60 * int(m) + float(s) for m, s in times)
print("%-18s %6d %5d %5d %5d %6.1f %6.1f %5d %5d %6.1f  %s" % (
    name, len(model["panels"]), count["connector"], count["teeth"], count["none"], 100 * joined[0] / total[0],
    100 * joined[1] / total[1], len(model["parts"]), len(report["warnings"]), seconds, verdict))
PYTHON
  grep '^violation' "$work/verify"
done
exit $failed
