#!/usr/bin/env python3
# Copyright (c) 2026 The Multiplanar authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Puts the table of the robustness suite into a chapter of the manual.

    robustness_chapter.py TABLE.tsv CHAPTER.txt

What stands between the lines TABLE BEGIN and TABLE END is replaced.
"""
import csv
import re
import sys


def cell(text):
    """A file name or message as a cell: nothing in it is markup."""
    return re.sub(r"([\\@&$#<>%*_|`~])", r"\\\1", text) if text else " "


def rows(lines):
    """Meshes that were made into parts first, those refused after them, each in the order of their names."""
    return sorted(lines, key=lambda line: (line["result"] == "refused", line["mesh"].lower()))


def count(lines, result):
    return sum(line["result"] == result for line in lines)


def main(table, chapter):
    with open(table, newline="") as file:
        lines = list(csv.DictReader(file, delimiter="\t", quoting=csv.QUOTE_NONE))
    kept, refused, not_found = (count(lines, result) for result in ("kept", "refused", "not found"))
    text = ["%d meshes: %d kept all promises, %d were refused with the right message, for %d no flat panels were found "
            "and a message says so, %d broke a promise.\n"
            % (len(lines), kept, refused, not_found, len(lines) - kept - refused - not_found)]
    heads = ["mesh", "faces", "genus", "k", "panels", "Hausdorff %", "seconds", "MB", "result", "remark"]
    text.append("| " + " | ".join(heads).replace("%", "\\%") + " |")
    text.append("|" + "|".join(["---"] + ["---:"] * 7 + ["---"] * 2) + "|")
    text += ["| " + " | ".join(cell(line[head] or "") for head in heads) + " |" for line in rows(lines)]
    with open(chapter) as file:
        old = file.read()
    begin, end = old.index("TABLE BEGIN -->") + len("TABLE BEGIN -->"), old.index("<!-- TABLE END")
    with open(chapter, "w") as file:
        file.write(old[:begin] + "\n\n" + "\n".join(text) + "\n\n" + old[end:])


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2])
