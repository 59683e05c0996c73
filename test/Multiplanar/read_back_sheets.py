#!/usr/bin/env python3
# Copyright (c) 2026 The Multiplanar authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads sheets back with programs that others wrote.

Usage: read_back_sheets.py MULTIPLANAR WORK_DIRECTORY frame|pear

Makes parts of a frame with known panels, or of a pear of triangles, and looks at every sheet with librsvg, GDAL, ezdxf, poppler and
svgelements: sizes, layers, closed and simple cuts, text off the cuts, and the area of what is cut, which has to be the
parts' area and half a kerf around it to 0.1 %.
"""
import csv
import json
import math
import os
import subprocess
import sys

import ezdxf
import svgelements

failures = 0


def check(holds, what):
    global failures
    print(("ok    " if holds else "WRONG ") + what)
    failures += not holds


def near(a, b, share):
    return abs(a - b) <= share * abs(b)


def output_of(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


# --- Something to cut -------------------------------------------------------------------------------------------------

def frame_shell(path):
    """A square frame, 3 x 3 x 1 with a tunnel of 1 x 1: ten panels, two of them with a hole."""
    ring = lambda a, b: [(a, a), (b, a), (b, b), (a, b)]
    points = [(x, y, z) for z in (0, 1) for r in (ring(0, 3), ring(1, 2)) for x, y in r]
    faces = []

    def quad(a, b, c, d, panel):
        faces.append((a, b, c, panel))
        faces.append((a, c, d, panel))

    for i in range(4):
        k = (i + 1) % 4
        quad(k, i, 4 + i, 4 + k, 0)  # below
        quad(8 + i, 8 + k, 12 + k, 12 + i, 1)  # above
        quad(i, k, 8 + k, 8 + i, 2 + i)
        quad(4 + k, 4 + i, 12 + i, 12 + k, 6 + i)
    with open(path, "w") as out:
        out.write("ply\nformat ascii 1.0\nelement vertex %d\n" % len(points))
        out.write("property double x\nproperty double y\nproperty double z\n")
        out.write("element face %d\nproperty list uchar int vertex_indices\nproperty int panel\nend_header\n" % len(faces))
        for p in points:
            out.write("%g %g %g\n" % p)
        for a, b, c, panel in faces:
            out.write("3 %d %d %d %d\n" % (a, b, c, panel))


def pear(path, rows=24, columns=32):
    """A closed surface of 1472 triangles, narrower above than below."""
    points = [(0.0, 0.0, -1.0), (0.0, 0.0, 1.6)]
    for i in range(1, rows):
        a = math.pi * i / rows
        for k in range(columns):
            b = 2 * math.pi * k / columns
            r = math.sin(a) * (1 + 0.3 * math.cos(a)) * (1 + 0.05 * math.cos(3 * b))
            points.append((r * math.cos(b), 0.8 * r * math.sin(b), 0.3 - 1.3 * math.cos(a)))
    at = lambda i, k: 2 + (i - 1) * columns + k % columns
    faces = []
    for k in range(columns):
        faces += [(0, at(1, k + 1), at(1, k)), (1, at(rows - 1, k), at(rows - 1, k + 1))]
        for i in range(1, rows - 1):
            faces += [(at(i, k), at(i, k + 1), at(i + 1, k + 1)), (at(i, k), at(i + 1, k + 1), at(i + 1, k))]
    with open(path, "w") as out:
        out.write("OFF\n%d %d 0\n" % (len(points), len(faces)))
        out.writelines("%.17g %.17g %.17g\n" % p for p in points)
        out.writelines("3 %d %d %d\n" % f for f in faces)


# --- What is to be expected -------------------------------------------------------------------------------------------

def signed_area(loop):
    return sum(loop[i - 1][0] * loop[i][1] - loop[i][0] * loop[i - 1][1] for i in range(len(loop))) / 2


def band(loop, r):
    """Area within r to the right of a loop with the part on its left: strips, sectors, less what overlaps."""
    total = 0
    for i in range(len(loop)):
        a, b, c = loop[i - 2], loop[i - 1], loop[i]
        u, v = (b[0] - a[0], b[1] - a[1]), (c[0] - b[0], c[1] - b[1])
        turn = math.atan2(u[0] * v[1] - u[1] * v[0], u[0] * v[0] + u[1] * v[1])
        total += r * math.hypot(*v) + (r * r * turn / 2 if turn > 0 else r * r * math.tan(turn / 2))
    return total


def expected_area(part, kerf, fit):
    """The part, its tabs wider by the fit, and half a kerf around it all."""
    area = signed_area(part["outline"]) + band(part["outline"], kerf / 2)
    for hole in part["holes"]:
        hole = hole if signed_area(hole) < 0 else hole[::-1]
        area += signed_area(hole) + band(hole, kerf / 2)
    n = len(part["outline"])
    for first, last in part["tabs"]:
        for i in (first, last - 1):
            area += fit / 2 * math.dist(part["outline"][i % n], part["outline"][(i + 1) % n])
    return area


# --- The readers ------------------------------------------------------------------------------------------------------

def look_with_svgelements(path, sheet, parts):
    svg = svgelements.SVG.parse(path, ppi=25.4)  # a unit is a millimetre
    check(near(svg.width, sheet["width"], 1e-6) and near(svg.height, sheet["height"], 1e-6), path + ": size in mm")
    layers = {"engrave": [], "inner": [], "outer": []}

    def visit(group, layer, owner):
        layer = group.values.get("attributes", {}).get("{http://www.inkscape.org/namespaces/inkscape}label", layer)
        for e in group:
            if isinstance(e, svgelements.Group):
                name = e.id or owner
                visit(e, name[6:] if name and name.startswith("layer-") else layer, name)
            elif isinstance(e, svgelements.Path):
                closed = any(isinstance(s, svgelements.Close) for s in e)
                points = [(s.end.x, sheet["height"] - s.end.y) for s in e if not isinstance(s, svgelements.Close)]
                layers[layer].append((owner, closed, points))
            else:
                check(False, "%s has a %s" % (path, type(e).__name__))

    visit(svg, None, None)
    check(all(closed for name in ("inner", "outer") for _, closed, _ in layers[name]), path + ": all cuts closed")
    check(not any(closed for _, closed, _ in layers["engrave"]), path + ": engraving is open lines")
    check(sorted(o for o, _, _ in layers["outer"]) == sorted(p["part"] for p in sheet["placements"]),
          path + ": one outer cut a part, in a group with its id")
    area = sum(abs(signed_area(p)) for _, _, p in layers["outer"]) - sum(abs(signed_area(p)) for _, _, p in layers["inner"])
    return layers, area


def cuts_by_part(path):
    """The path data of every part's cuts, as they stand in the file."""
    cuts, part = {}, None
    layer = ""
    for line in open(path):
        if line.startswith("<g "):
            name = line.split('id="')[1].split('"')[0] if 'id="' in line else ""
            layer = name if name.startswith("layer-") else layer
            part = name.rsplit("-", 1)[0] if layer == "layer-inner" else name
        elif line.startswith("<path") and layer in ("layer-inner", "layer-outer"):
            cuts.setdefault(part, []).append(line.split('d="')[1].split('"')[0])
    return cuts


def look_with_rsvg(path, sheet, work, area):
    """Coverage: every part filled, without its holes; the sum of what is dark."""
    page = os.path.join(work, "page.png")
    subprocess.run(["rsvg-convert", "-d", "25.4", "-p", "25.4", "-z", "1", "-o", page, path], check=True)
    size = output_of("gdalinfo", page)
    check("Size is %d, %d" % (round(sheet["width"]), round(sheet["height"])) in size, path + ": librsvg: a pixel a mm")
    filled = os.path.join(work, "filled.svg")
    with open(filled, "w") as out:
        out.write('<svg xmlns="http://www.w3.org/2000/svg" width="%gmm" height="%gmm" viewBox="0 0 %g %g">\n' %
                  (2 * (sheet["width"], sheet["height"])))
        for part, paths in cuts_by_part(path).items():
            out.write('<path fill-rule="evenodd" d="%s"/>\n' % " ".join(paths))
        out.write("</svg>\n")
    scale = 4
    subprocess.run(["rsvg-convert", "-d", "25.4", "-p", "25.4", "-z", str(scale), "-b", "white", "-o", page, filled],
                   check=True)
    grey = os.path.join(work, "page.pgm")
    subprocess.run(["gdal_translate", "-q", "-b", "1", "-of", "PNM", page, grey], check=True)
    pixels = open(grey, "rb").read()[-round(sheet["width"] * scale) * round(sheet["height"] * scale):]
    covered = (255 * len(pixels) - sum(pixels)) / 255 / scale ** 2
    check(near(covered, area, 1e-3), "%s: librsvg covers %.1f mm2 of %.1f" % (path, covered, area))


def look_with_gdal(path, area, layers):
    sql = ("SELECT Layer AS l, count(*) AS n, min(ST_IsClosed(geometry)) AS closed, min(ST_IsSimple(geometry)) AS simple, "
           "sum(ST_Area(ST_MakePolygon(geometry))) AS area FROM entities GROUP BY Layer")
    found, name = {}, None
    for line in output_of("ogrinfo", "-q", "-dialect", "SQLite", "-sql", sql, path).splitlines():
        if " = " not in line:
            continue
        key, value = line.strip().split(" (")[0], line.split(" = ")[1]
        if key == "l":
            name = value
            found[name] = {}
        else:
            found[name][key] = float(value)
    cuts = {k: v for k, v in found.items() if k.startswith("CUT")}
    check(set(found) <= {"CUT_INNER", "CUT_OUTER", "ENGRAVE"} and "CUT_OUTER" in cuts, path + ": GDAL sees the layers")
    check(all(c["closed"] == 1 and c["simple"] == 1 for c in cuts.values()), path + ": GDAL: closed and simple")
    counts = [found.get(k, {"n": 0})["n"] for k in ("ENGRAVE", "CUT_INNER", "CUT_OUTER")]
    check(counts == [len(layers[k]) for k in ("engrave", "inner", "outer")], path + ": as many lines as in the SVG")
    cut = cuts["CUT_OUTER"]["area"] - cuts.get("CUT_INNER", {"area": 0})["area"]
    check(near(cut, area, 1e-3), "%s: GDAL: %.1f mm2 of %.1f" % (path, cut, area))


def look_with_ezdxf(path, sheet):
    drawing = ezdxf.readfile(path)
    audit = drawing.audit()
    check(not audit.errors and not audit.fixes, "%s: ezdxf finds %d errors, mends %d" %
          (path, len(audit.errors), len(audit.fixes)))
    check(drawing.dxfversion == "AC1015" and drawing.units == 4, path + ": R2000 in mm")
    entities = list(drawing.modelspace())
    check(all(e.dxftype() == "LWPOLYLINE" for e in entities), path + ": LWPOLYLINE only")
    check(all(e.closed == e.dxf.layer.startswith("CUT") for e in entities), path + ": ezdxf: cuts closed, text open")
    ranks = [["ENGRAVE", "CUT_INNER", "CUT_OUTER"].index(e.dxf.layer) for e in entities]
    check(ranks == sorted(ranks), path + ": engraving, inner cuts, outer cuts, in this order")
    inside = all(-1e-6 <= x <= sheet["width"] and -1e-6 <= y <= sheet["height"]
                 for e in entities for x, y in e.get_points("xy"))
    check(inside, path + ": on the sheet, y upward")


def look_with_poppler(path, sheet):
    line = [l for l in output_of("pdfinfo", path).splitlines() if l.startswith(("Page size", "Pages"))]
    width, height = (float(x) for x in line[1].split(":")[1].replace("pts", "x").split("x")[:2])
    check(line[0].split()[-1] == "1", path + ": one page")
    check(abs(width * 25.4 / 72 - sheet["width"]) < 0.02 and abs(height * 25.4 / 72 - sheet["height"]) < 0.02,
          "%s: %.2f x %.2f mm" % (path, width * 25.4 / 72, height * 25.4 / 72))


# --- Text and cuts ----------------------------------------------------------------------------------------------------

def distance(p, a, b):
    dx, dy = b[0] - a[0], b[1] - a[1]
    d = dx * dx + dy * dy
    t = 0 if d == 0 else max(0, min(1, ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / d))
    return math.hypot(p[0] - a[0] - t * dx, p[1] - a[1] - t * dy)


def inside(loop, p):
    odd = False
    for i in range(len(loop)):
        a, b = loop[i - 1], loop[i]
        if (a[1] > p[1]) != (b[1] > p[1]) and p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]):
            odd = not odd
    return odd


def check_text(path, layers):
    """Every stroke lies in its part, 0.2 mm or more from any cut of it."""
    outer = {owner: points for owner, _, points in layers["outer"]}
    inner = {}
    for owner, _, points in layers["inner"]:
        inner.setdefault(owner.rsplit("-", 1)[0], []).append(points)
    wrong = set()
    for owner, _, stroke in layers["engrave"]:
        part = owner.rsplit("-", 1)[0]
        samples = [((a[0] * (4 - k) + b[0] * k) / 4, (a[1] * (4 - k) + b[1] * k) / 4)
                   for a, b in zip(stroke, stroke[1:]) for k in range(5)]
        low, high = [min(c) - 1 for c in zip(*stroke)], [max(c) + 1 for c in zip(*stroke)]
        if not inside(outer[part], stroke[0]):
            wrong.add(part)
        for loop in [outer[part]] + inner.get(part, []):
            for i in range(len(loop)):
                a, b = loop[i - 1], loop[i]
                if max(a[0], b[0]) < low[0] or min(a[0], b[0]) > high[0] or max(a[1], b[1]) < low[1] or min(a[1], b[1]) > high[1]:
                    continue
                if min(distance(p, a, b) for p in samples) < 0.2:
                    wrong.add(part)
    check(not wrong, "%s: text keeps off the cuts%s" % (path, "" if not wrong else ": not on " + " ".join(sorted(wrong))))


def main():
    program, work = sys.argv[1:3]
    os.makedirs(work, exist_ok=True)
    out = os.path.join(work, "out")
    if sys.argv[3] == "pear":
        pear(os.path.join(work, "pear.off"))
        command = [program, "make", os.path.join(work, "pear.off"), "-k", "20", "--effort", "fast", "--kerf", "0.25"]
    else:
        frame_shell(os.path.join(work, "frame.ply"))
        command = [program, "fabricate", os.path.join(work, "frame.ply"), "--sheet", "330x320", "--kerf", "0.2"]
    subprocess.run(command + ["-o", out, "--quiet"], check=True)
    model = json.load(open(os.path.join(out, "model.json")))
    report = json.load(open(os.path.join(out, "report.json")))
    settings = model["settings"]
    parts = {p["id"]: p for p in model["parts"]}
    for sheet in model["sheets"]:
        svg = os.path.join(out, sheet["file"])
        area = sum(expected_area(parts[p["part"]], settings["kerf"], settings["fit"]) for p in sheet["placements"])
        layers, cut = look_with_svgelements(svg, sheet, parts)
        check(near(cut, area, 1e-3), "%s: svgelements: %.1f mm2 of %.1f" % (svg, cut, area))
        look_with_rsvg(svg, sheet, work, area)
        look_with_gdal(svg[:-3] + "dxf", area, layers)
        look_with_ezdxf(svg[:-3] + "dxf", sheet)
        look_with_poppler(svg[:-3] + "pdf", sheet)
        check_text(svg, layers)
    rows = list(csv.DictReader(open(os.path.join(out, "parts.csv"), newline="")))
    check([r["id"] for r in rows] == [p["id"] for p in model["parts"]], "parts.csv has a line a part")
    check(all(near(float(r["area_mm2"]), parts[r["id"]]["area"], 1e-2) for r in rows), "parts.csv: areas")
    total = sum(float(r["cut_length_mm"]) for r in rows)
    check(near(total, report["cut_length"], 1e-4), "parts.csv and report.json agree: %.0f mm are cut" % total)
    fit_test = svgelements.SVG.parse(os.path.join(out, "fit-test.svg"), ppi=25.4)
    bars = [g for g in fit_test.select(lambda e: isinstance(e, svgelements.Group) and e.id == "bar")]
    box = bars[0].bbox()
    check(abs(box[2] - box[0] - 100 - settings["kerf"]) < 1e-3, "fit-test.svg: the bar is 100 mm and a kerf long")
    sys.exit(1 if failures else 0)


main()
