#!/usr/bin/env bash
# Copyright (c) 2026 The Multiplanar authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# How densely the parts of a folder of meshes lie on sheets: approximates each at 50 panels, fast, and prints the table
# of nesting_benchmark. Usage: nesting_table.sh BUILD_DIRECTORY FOLDER_OF_MESHES [OUTPUT_DIRECTORY]
set -euo pipefail
bin=$1/bin meshes=$2 out=${3:-$(mktemp -d)}
models=()
for mesh in "$meshes"/*_10k.off; do
  name=$(basename "$mesh" .off)
  "$bin/multiplanar" make "$mesh" -o "$out/$name" -k 50 --effort fast --nest-seconds 0 --quiet || continue
  models+=("$out/$name/model.json")
done
"$bin/nesting_benchmark" "${models[@]}"
