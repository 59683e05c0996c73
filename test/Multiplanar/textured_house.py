# Copyright (c) 2026 The Multiplanar authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""A house with a texture: a prism over a pentagon, with obtuse angles at the ridge and right ones at the gables."""
import os
import struct
import subprocess
import zlib


def write_png(path, size):
    """A chequered picture."""
    rows = b""
    for y in range(size):
        row = b"".join(bytes((220, 60, 40) if (x // 8 + y // 8) % 2 else (240, 230, 200)) for x in range(size))
        rows += b"\0" + row

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    with open(path, "wb") as out:
        out.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", size, size, 8, 2, 0, 0, 0)))
        out.write(chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def write_house(directory):
    """house.obj with house.png, and house.ply with a panel for every face of the prism."""
    gable = [(0, 0), (100, 0), (100, 60), (50, 100), (0, 60)]
    points = [(x, y, z) for z in (0, 120) for x, y in gable]
    faces = []
    for i in (1, 2, 3):
        faces += [(0, i + 1, i, 0), (5, 5 + i, 6 + i, 1)]
    for a in range(5):
        b = (a + 1) % 5
        faces += [(a, b, 5 + b, 2 + a), (a, 5 + b, 5 + a, 2 + a)]
    write_png(os.path.join(directory, "house.png"), 64)
    with open(os.path.join(directory, "house.mtl"), "w") as out:
        out.write("newmtl paint\nmap_Kd house.png\n")
    with open(os.path.join(directory, "house.obj"), "w") as out:
        out.write("mtllib house.mtl\nusemtl paint\n")
        for p in points:
            out.write("v %g %g %g\nvt %g %g\n" % (*p, (p[0] + p[2] / 3) / 140, (p[1] + p[2] / 5) / 140))
        for f in faces:
            out.write("f " + " ".join("%d/%d" % (v + 1, v + 1) for v in f[:3]) + "\n")
    with open(os.path.join(directory, "house.ply"), "w") as out:
        out.write("ply\nformat ascii 1.0\nelement vertex %d\n" % len(points))
        out.write("property double x\nproperty double y\nproperty double z\nelement face %d\n" % len(faces))
        out.write("property list uchar int vertex_indices\nproperty int panel\nend_header\n")
        for p in points:
            out.write("%g %g %g\n" % p)
        for f in faces:
            out.write("3 %d %d %d %d\n" % f)


def make_parts(program, work):
    """\\return the folder with all that the program makes of the house"""
    os.makedirs(work, exist_ok=True)
    write_house(work)
    out = os.path.join(work, "house")
    subprocess.run([program, "fabricate", os.path.join(work, "house.ply"), "--source", os.path.join(work, "house.obj"),
                    "-o", out, "--size", "200", "--dpi", "40", "--no-preview", "--quiet"], check=True)
    return out
