#!/usr/bin/env python3
# Copyright (c) 2026 The Multiplanar authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads the guides to the assembly back with programs that others wrote.

Usage: read_back_guides.py make PROGRAM WORK_DIRECTORY    makes the parts of a house with a texture
       read_back_guides.py html|pdf|glb WORK_DIRECTORY    looks at what was made

assembly.html is driven in Chromium by keys and mouse, assembly.pdf is read by poppler, assembly.glb by Khronos'
gltf-validator, which npm puts into the work directory. Screenshots and pages stay in the work directory. Exit code 77: a
program that is needed is not to be had.
"""
import json
import os
import re
import shutil
import struct
import subprocess
import sys

import headless_chromium
import textured_house

failures = 0


def check(holds, what):
    global failures
    print(("ok    " if holds else "WRONG ") + what, flush=True)
    failures += not holds


def skip(why):
    print("skipped: " + why)
    sys.exit(1 if failures else 77)


def model_of(out):
    with open(os.path.join(out, "model.json")) as file:
        return json.load(file)


def count_images(pdf):
    images = subprocess.run(["pdfimages", "-list", pdf], check=True, capture_output=True, text=True).stdout
    return len(re.findall(r"^ *\d+ +\d+ image", images, re.M))


# --- assembly.html ----------------------------------------------------------------------------------------------------

class Guide:
    """The guide as a reader has it before him."""

    def __init__(self, page, address):
        self.page = page
        self.value = page.value
        page.open(address)
        page.wait_for("window.guide && guide.ready() && !guide.moving()")
        self.steps, self.parts = self.value("guide.model.steps.length"), self.value("guide.model.parts.length")

    def settle(self):
        self.page.wait_for("!guide.moving()")

    def picture(self):
        """The 3D view alone."""
        self.settle()
        return self.value("guide.picture(400, 300)")

    def press(self, key):
        self.page.press(key)
        self.settle()

    def set_slider(self, name, share):
        """Clicks on a slider at this share of its length."""
        box = self.value("(b => [b.x, b.y, b.width, b.height])(document.getElementById('%s').getBoundingClientRect())" % name)
        thumb = 16  # pixels that the slider's handle is wide
        self.page.click(box[0] + thumb / 2 + share * (box[2] - thumb), box[1] + box[3] / 2)
        self.settle()

    def text(self, name):
        return self.value("document.getElementById('%s').textContent" % name)

    def shown(self, name):
        return self.value("getComputedStyle(document.getElementById('%s')).display !== 'none'" % name)


def check_steps(guide):
    check(len(guide.value("guide.shown()")) == guide.parts, "at first all parts are shown")
    whole = guide.picture()
    guide.set_slider("step", 0.5)
    middle = guide.value("guide.state.step")
    check(0 < middle < guide.steps, "the step slider goes to a step in the middle: %d" % middle)
    some = len(guide.value("guide.shown()"))
    check(0 < some < guide.parts, "%d of %d parts are placed by then" % (some, guide.parts))
    half = guide.picture()
    check(half != whole, "the picture is another")
    words = guide.value("guide.model.steps[guide.state.step - 1].text")
    check(len(words) > 10 and guide.text("step-text") == words, "the step says what to do: " + words)
    guide.press("ArrowRight")
    check(guide.value("guide.state.step") == middle + 1, "the right arrow key is the next step")
    check(len(guide.value("guide.shown()")) > some and guide.picture() != half, "which shows more")
    guide.press("ArrowLeft")
    check(len(guide.value("guide.shown()")) == some and guide.value("guide.state.step") == middle,
          "the left arrow key leads back")
    guide.press("End")
    check(guide.value("guide.state.step") == guide.steps and len(guide.value("guide.shown()")) == guide.parts,
          "End shows everything in place")
    guide.press("Home")
    guide.press("f")
    check(guide.value("guide.state.step") == 0 and guide.picture() == whole, "Home and F lead to the first picture")


def check_explosion(guide):
    whole, first = guide.picture(), guide.value("guide.model.parts[0].id")
    guide.set_slider("explode", 0.7)
    check(guide.value("Math.hypot(...guide.position('%s'))" % first) > 1, "the explode slider moves parts")
    check(guide.picture() != whole, "the picture is another")
    guide.set_slider("explode", 0)
    check(guide.value("Math.hypot(...guide.position('%s'))" % first) < 1e-9, "and back")
    check(guide.picture() == whole, "the picture is the old one")


def check_view(guide):
    whole = guide.picture()
    guide.page.drag(700, 400, 850, 450)
    check(guide.picture() != whole, "dragging turns the model")
    guide.press("f")
    check(guide.shown("textures-button"), "there are textures")
    whole = guide.picture()
    guide.press("t")
    check(guide.picture() != whole, "without textures the picture is another")
    guide.press("t")
    check(guide.picture() == whole, "with textures it is the old one")
    guide.press("d")
    check(guide.value("document.documentElement.classList.contains('dark')"), "dark")
    guide.press("d")


def check_card(guide):
    page = guide.page
    guide.press("/")
    page.type("p03")
    page.wait_for("document.getElementById('results').children.length > 0")
    check(guide.text("results").startswith("P03"), "the search finds a part")
    guide.press("Enter")
    card = guide.text("card")
    check(guide.shown("card") and all(word in card for word in ("P03", "Neighbours", "sheet 1", "P01")),
          "its card tells its id, neighbours, sheet")
    check(guide.value("document.querySelectorAll('#card svg path').length") >= 5, "and shows where it lies on the sheet")
    guide.press("Escape")
    check(not guide.shown("card"), "Escape closes it")
    x, y = guide.value("(b => [b.x + b.width / 2, b.y + b.height / 2])(document.getElementById('view')"
                       ".getBoundingClientRect())")
    page.click(x, y)
    guide.settle()
    clicked = guide.value("guide.state.selected")
    check(clicked >= 0 and guide.shown("card") and guide.value("guide.model.parts[%d].id" % clicked) in guide.text("card"),
          "a click on the model opens the card of the part that is there")
    guide.press("Escape")


def check_print(guide, work):
    whole = guide.picture()
    pdf = os.path.join(work, "guide-printed.pdf")
    guide.page.print_to(pdf)
    text = subprocess.run(["pdftotext", "-layout", pdf, "-"], check=True, capture_output=True, text=True).stdout
    placed = guide.value("guide.model.steps.map(step => guide.model.parts[step.parts[0]].id)")
    check(all(part in text for part in placed), "the print names the part of every step")
    check(guide.value("document.querySelectorAll('#print figure').length") == guide.steps + 1, "a picture for every step")
    check(count_images(pdf) == guide.steps + 1, "which are in the print")
    different = guide.value("new Set([...document.querySelectorAll('#print img')].map(i => i.src)).size")
    check(different == guide.steps + 1, "each another")
    check(guide.picture() == whole, "printing leaves the page as it was")
    subprocess.run(["pdftoppm", "-r", "60", "-png", pdf, os.path.join(work, "guide-printed")], check=True)


def keep_screenshots(page, address, work):
    shots = {}
    for name, wish in (("finished", ""), ("step", "#step=5"), ("exploded", "#explode=60"), ("part", "#part=P03&dark=1")):
        page.open("about:blank")
        Guide(page, address + wish)
        shots[name] = page.screenshot(os.path.join(work, "guide-" + name + ".png"))
    check(len(set(shots.values())) == len(shots), "screenshots, each another: " + " ".join(
        os.path.join(work, "guide-" + name + ".png") for name in shots))


def check_html(out, work):
    chromium = headless_chromium.find_chromium()
    if not chromium:
        skip("no chromium")
    address = "file://" + os.path.join(out, "assembly.html")
    with headless_chromium.Page(chromium, work, 1400, 900) as page:
        guide = Guide(page, address)
        check(guide.steps == len(model_of(out)["assembly"]) >= 7, "%d steps" % guide.steps)
        check_steps(guide)
        check_explosion(guide)
        check_view(guide)
        check_card(guide)
        check_print(guide, work)
        keep_screenshots(page, address, work)
        check(page.complaints() == [], "no errors or warnings in the console: " + str(page.complaints())[:1000])
        elsewhere = [a for a in page.requests() if not a.startswith(("data:", "blob:", "about:", address))]
        check(elsewhere == [], "the page loads nothing but itself: " + str(elsewhere)[:300])


# --- assembly.pdf -----------------------------------------------------------------------------------------------------

def check_pdf(out, work):
    pdf, model = os.path.join(out, "assembly.pdf"), model_of(out)
    info = subprocess.run(["pdfinfo", pdf], check=True, capture_output=True, text=True).stdout
    pages = int(re.search(r"Pages:\s*(\d+)", info).group(1))
    steps = len(model["assembly"])
    check(pages == 2 + -(-steps // 6) + len(model["sheets"]), "%d pages: cover, material, steps, sheets" % pages)
    check(re.search(r"Page size:\s*595\.\d+ x 841\.\d+ pts \(A4\)", info) is not None, "A4")
    each = subprocess.run(["pdftotext", "-layout", pdf, "-"], check=True, capture_output=True, text=True).stdout.split("\f")
    check("%d panels" % sum(part["kind"] == "panel" for part in model["parts"]) in each[0], "the cover counts panels")
    check("Material" in each[1] and "Tools" in each[1], "what one needs")
    step_pages = each[2:pages - len(model["sheets"])]
    for step in model["assembly"]:
        page = step_pages[(step["step"] - 1) // 6]
        check(all(part in page for part in step["parts"]), "step %d names %s" % (step["step"], " ".join(step["parts"])))
    for page, sheet in zip(each[pages - len(model["sheets"]):], model["sheets"]):
        check(sheet["file"] in page and all(p["part"] in page for p in sheet["placements"]), "a map of " + sheet["file"])
    check(count_images(pdf) == steps + 1, "a picture of the model, and one for every step")
    subprocess.run(["pdftoppm", "-r", "60", "-png", pdf, os.path.join(work, "guide-page")], check=True)


# --- assembly.glb -----------------------------------------------------------------------------------------------------

VALIDATOR = "gltf-validator@2.0.0-dev.3.10"
VALIDATE = """require('gltf-validator').validateBytes(new Uint8Array(require('fs').readFileSync(process.argv[2])))
  .then(report => console.log(JSON.stringify(report)));
"""


def validator(work):
    npm, node = shutil.which("npm"), shutil.which("node")
    if not npm or not node:
        skip("no npm")
    if not os.path.isdir(os.path.join(work, "node_modules", "gltf-validator")):
        got = subprocess.run([npm, "install", "--prefix", work, "--no-audit", "--no-fund", "--fetch-retries=1", VALIDATOR],
                             capture_output=True, text=True)
        if got.returncode != 0:
            skip("npm cannot fetch gltf-validator: " + got.stderr[-300:])
    script = os.path.join(work, "validate.js")
    with open(script, "w") as file:
        file.write(VALIDATE)
    return [node, script]


def check_nodes(glb, model):
    with open(glb, "rb") as file:
        data = file.read()
    document = json.loads(data[20:20 + struct.unpack("<I", data[12:16])[0]])
    nodes = {node["name"]: node for node in document["nodes"]}
    check(all("mesh" in nodes.get(part["id"], {}) for part in model["parts"]), "a node with a mesh for every part")
    for step in model["assembly"]:
        check(all(nodes[part]["extras"]["step"] == step["step"] for part in step["parts"]), "step %d" % step["step"])
    check(len(document["images"]) == sum("texture" in part for part in model["parts"]) > 0, "textures")


def check_glb(out, work):
    glb = os.path.join(out, "assembly.glb")
    check_nodes(glb, model_of(out))
    command = validator(work) + [glb]
    report = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
    issues = report["issues"]
    check(issues["numErrors"] == 0 and issues["numWarnings"] == 0, "no errors, no warnings: " + str(issues["messages"]))
    check(report["info"]["totalTriangleCount"] > 100, "%d triangles" % report["info"]["totalTriangleCount"])


def main():
    what, work = sys.argv[1], os.path.abspath(sys.argv[-1])
    if what == "make":
        shutil.rmtree(os.path.join(work, "house"), ignore_errors=True)
        textured_house.make_parts(sys.argv[2], work)
        return
    {"html": check_html, "pdf": check_pdf, "glb": check_glb}[what](os.path.join(work, "house"), work)
    sys.exit(1 if failures else 0)


main()
