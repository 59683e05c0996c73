// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "guides.h"

#include "Assembly_guide.h"

void write_guides(const File_writer& write, const CGAL::Multiplanar::Model& model, const Preview_view& view,
                  const Part_pictures& pictures)
{
  const Assembly_guide guide = make_assembly_guide(model, view.up, view.towards_viewer, pictures);
  write("assembly.html", [&](std::ostream& out) { write_assembly_html(out, guide); });
  write("assembly.pdf", [&](std::ostream& out) { write_assembly_pdf(out, guide, view.threads); });
  write("assembly.glb", [&](std::ostream& out) { write_glb(out, guide); });
}
