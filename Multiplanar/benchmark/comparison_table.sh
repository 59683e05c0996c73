#!/usr/bin/env bash
# Copyright (c) 2026 The Multiplanar authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# `multiplanar compare` over many meshes, with a summary: this method, CGAL's VSA and CGAL's QEM.
#
#   comparison_table.sh [FOLDER or MESH ...]
#
# Without arguments: all meshes of Debian's libcgal-demo. A mesh qualifies if the program takes it (closed, embedded,
# connected) and a k if the genus allows it; what does not qualify is listed with the reason.
#
# MULTIPLANAR: the program (build/bin/multiplanar); KS ("30 50 70 90"); EFFORT (normal); SEED (0); THREADS (0: all);
# LIMIT: seconds after which a run is given up, and said to be (3600); ROWS: file for the rows as TSV. Runs whose rows
# stand there already are not repeated.
set -uo pipefail
program=${MULTIPLANAR:-build/bin/multiplanar}
ks=${KS:-30 50 70 90} effort=${EFFORT:-normal} seed=${SEED:-0} threads=${THREADS:-0} limit=${LIMIT:-3600}
work=$(mktemp -d) || exit 4
trap 'rm -rf "$work"' EXIT
rows=${ROWS:-$work/rows.tsv}
command -v "$program" > /dev/null || { echo "$program: not found: build it, or set MULTIPLANAR" >&2; exit 2; }

if [ $# -eq 0 ]; then
  tar -xzf /usr/share/doc/libcgal-dev/data.tar.gz -C "$work" || exit 3
  set -- "$work/data/meshes"
fi
meshes=()
for argument; do
  if [ -d "$argument" ]; then
    while IFS= read -r mesh; do meshes+=("$mesh"); done < <(
      find "$argument" -maxdepth 1 -type f \( -name '*.off' -o -name '*.ply' -o -name '*.obj' -o -name '*.stl' \) | sort)
  else meshes+=("$argument"); fi
done

refused=0 failed=0
[ -s "$rows" ] || : > "$rows"
for mesh in "${meshes[@]}"; do
  name=$(basename "$mesh")
  for k in $ks; do
    awk -F'\t' -v n="$name" -v k="$k" '$1 == n && $4 == k {found = 1} END {exit !found}' "$rows" && continue
    timeout "$limit" "$program" compare "$mesh" -k "$k" --effort "$effort" --seed "$seed" --threads "$threads" --tsv \
      > "$work/out" 2> "$work/error"
    code=$?
    case $code in
      0) [ -s "$rows" ] || head -1 "$work/out" > "$rows"
         tail -n +2 "$work/out" >> "$rows"
         tail -n +2 "$work/out" | awk -F'\t' '{printf "%s%s %s %.2f", (NR == 1 ? sprintf("%-34s k=%-3d", $1, $4) : ";"),
           $5, ($12 == "yes" && $13 == "yes" && $14 == 0 ? "ok" : "--"), $7} END {print ""}' ;;
      3) echo "$name k=$k: does not qualify: $(sed "s#^.*$name: ##" "$work/error")"
         refused=$((refused + 1))
         grep -q 'panels are' "$work/error" || break ;; # the mesh, not this k
      124) echo "$name k=$k: given up after $limit s"
           failed=$((failed + 1)) ;;
      *) failed=$((failed + 1))
         echo "$name k=$k: exit $code: $(cat "$work/error")" ;;
    esac
  done
done

echo
awk -F'\t' -v effort="$effort" -v refused="$refused" -v failed="$failed" '
  NR == 1 { next }
  { run[$1, $4]; mesh[$1]; method[$5]; n[$5]++
    closed[$5] += $12 == "yes"; flat[$5] += $13 == "yes"; free[$5] += $14 == "0"
    all[$5] += $12 == "yes" && $13 == "yes" && $14 == "0"
    if ($7 != "") { h[$1, $4, $5] = $7 > 0.01 ? $7 : 0.01; ks[$4] } }
  function mean(other, k,   key, part, sum, count) {
    for (key in h) { split(key, part, SUBSEP)
      if (part[3] == "Multiplanar" && (k == "" || part[2] == k) && ((part[1], part[2], other) in h)) {
        sum += log(h[key] / h[part[1], part[2], other]); count++ } }
    return count ? sprintf("%.3f (%d)", exp(sum / count), count) : "-" }
  END {
    for (m in mesh) meshes++
    for (r in run) runs++
    printf "%d meshes, %d runs, effort %s; Multiplanar gave up in %d more; %d did not qualify\n", meshes, runs, effort, failed, refused
    printf "%-12s %6s %8s %6s %22s %6s\n", "method", "runs", "closed", "flat", "without intersections", "all"
    split("Multiplanar,CGAL VSA,CGAL QEM", order, ",")
    for (i = 1; i <= 3; i++) { m = order[i]
      printf "%-12s %6d %8d %6d %22d %6d\n", m, n[m], closed[m], flat[m], free[m], all[m] }
    printf "\nHausdorff distance, geometric means of Multiplanar / other (runs); less than 0.01 %% of the diagonal counts as that\n%-10s %16s %16s\n", "k", order[2], order[3]
    count = 0
    for (k in ks) sorted[++count] = k + 0
    for (i = 1; i <= count; i++) for (j = i + 1; j <= count; j++)
      if (sorted[j] < sorted[i]) { t = sorted[i]; sorted[i] = sorted[j]; sorted[j] = t }
    for (i = 1; i <= count; i++) printf "%-10d %16s %16s\n", sorted[i], mean(order[2], sorted[i]), mean(order[3], sorted[i])
    printf "%-10s %16s %16s\n", "all", mean(order[2], ""), mean(order[3], "") }' "$rows"
