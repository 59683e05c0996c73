// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Assembly_guide.h"
#include "Pdf_document.h"
#include "Pdf_painter.h"
#include "guide_text.h"
#include "part_map.h"
#include "render.h"
#include "step_pictures.h"

#include <algorithm>
#include <cstdio>
#include <ostream>

using namespace CGAL::Multiplanar;

namespace {

constexpr double page_width = 210, page_height = 297, margin = 16; // mm
constexpr double inner_width = page_width - 2 * margin;

class Guide_document
{
public:
  Guide_document(std::ostream& out, const Assembly_guide& guide, int threads)
      : guide(guide), threads(threads), document(out)
  {
    document.set_title(guide.title + ": assembly");
  }

  void write()
  {
    add_cover();
    add_preparation();
    for (int s = 0; s < int(guide.model.assembly.size()); s += per_page) add_steps(s);
    for (int s = 0; s < int(guide.model.sheets.size()); ++s) {
      Pdf_painter page(document.begin_page(page_height, page_width));
      draw_part_map(page, guide, s, page_height, page_width, margin);
      add_number(page, page_height, page_width);
    }
    document.finish();
  }

private:
  static constexpr int columns = 2, rows = 3, per_page = columns * rows;

  Pdf_painter new_page() { return Pdf_painter(document.begin_page(page_width, page_height)); }

  void add_number(const Pdf_painter& page, double width, double height)
  {
    page.text(width - margin, height - 8, guide.title + " · " + std::to_string(++pages),
              {2.8, false, Pdf_painter::soft}, 1);
  }

  Image picture(const Scene& scene, const Camera& camera) const { return render(scene, camera, 2, threads); }

  void add_cover()
  {
    const Pdf_painter page = new_page();
    page.text(margin, 34, guide.title, {13, true, Pdf_painter::ink});
    page.text(margin, 44, facts_in_words(guide), {4, false, Pdf_painter::soft});
    const Scene scene = assembled_scene(guide.model, guide.up, guide.pictures);
    const double height = 190;
    const int w = 1240, h = int(w * height / inner_width);
    page.picture(margin, 54, inner_width, height,
                 picture(scene, fit_camera(points_of(scene), guide.towards_viewer, guide.up, w, h)));
    char text[160];
    std::snprintf(text, sizeof text, "%d panels", guide.count_panels());
    page.text(margin, 264, text, {9, true, Pdf_painter::accent});
    const std::string steps = guide.model.assembly.empty() ? std::string("no order of assembly is known")
                                                           : std::to_string(guide.model.assembly.size()) + " steps";
    page.text(margin, 273, std::to_string(guide.count_connectors()) + " connectors, " + steps,
              {4.4, false, Pdf_painter::ink});
    page.text(page_width - margin, 273, "assembly.html shows every step in 3D", {3.4, false, Pdf_painter::soft}, 1);
    ++pages;
  }

  double list(const Pdf_painter& page, double y, const std::string& title, const std::vector<std::string>& lines) const
  {
    page.text(margin, y, title, {6, true, Pdf_painter::ink});
    page.rule(margin, y + 2.5, page_width - margin);
    y += 10;
    for (const std::string& line : lines) {
      page.text(margin, y, "•", {4, true, Pdf_painter::accent});
      y = page.paragraph(margin + 6, y, inner_width - 6, line, {4, false, Pdf_painter::ink}) + 1.6;
    }
    return y + 8;
  }

  void add_preparation()
  {
    const Pdf_painter page = new_page();
    double y = list(page, 30, "Material", materials_in_words(guide));
    y = list(page, y, "Tools", tools_in_words(guide));
    list(page, y, "How to read the steps", hints_in_words(guide));
    add_number(page, page_width, page_height);
  }

  void add_steps(int first)
  {
    const Pdf_painter page = new_page();
    const double gap = 8, w = (inner_width - gap) / columns, h = 88;
    const int last = (std::min)(first + per_page, int(guide.model.assembly.size()));
    for (int s = first; s < last; ++s)
      add_step(page, s, margin + (s - first) % columns * (w + gap), 14 + (s - first) / columns * h, w);
    add_number(page, page_width, page_height);
  }

  void add_step(const Pdf_painter& page, int s, double x, double y, double width)
  {
    page.text(x, y + 6.5, std::to_string(s + 1), {8, true, Pdf_painter::accent});
    const double number = page.width(std::to_string(s + 1), {8, true, Pdf_painter::accent});
    const Assembly_step& step = guide.model.assembly[s];
    page.text(x + number + 3, y + 6.5, guide.model.parts[step.parts[0]].id, {5, true, Pdf_painter::ink});
    const double top = y + 9, height = width * picture_height / picture_width, scale = width / picture_width;
    const Step_picture drawn = pictures.picture(s);
    page.picture(x, top, width, height, picture(drawn.scene, drawn.camera));
    if (drawn.marks.has_arrow) {
      const auto& a = drawn.marks.arrow;
      page.arrow(x + a[0] * scale, top + a[1] * scale, x + a[2] * scale, top + a[3] * scale);
    }
    for (const Picture_label& label : drawn.marks.labels) add_label(page, label, x, top, scale);
    page.fitted_paragraph(x, top + height + 4.2, width, 16.5, step_text(guide, s), {2.9, false, Pdf_painter::ink});
  }

  static void add_label(const Pdf_painter& page, const Picture_label& label, double x, double y, double scale)
  {
    const double px = x + label.x * scale, py = y + label.y * scale;
    switch (label.kind) {
    case Picture_label::Kind::new_panel:
      return page.badge(px, py, label.text, {3, true, Pdf_painter::white}, Pdf_painter::accent);
    case Picture_label::Kind::new_connector:
      return page.caption(px, py, label.text, {2, true, Pdf_painter::ink});
    case Picture_label::Kind::placed:
      return page.caption(px, py, label.text, {2.3, false, Pdf_painter::soft});
    }
  }

  static constexpr int picture_width = 580, picture_height = 404;

  const Assembly_guide& guide;
  int threads;
  Pdf_document document;
  Step_pictures pictures{guide, picture_width, picture_height};
  int pages = 0;
};

} // namespace

void write_assembly_pdf(std::ostream& out, const Assembly_guide& guide, int threads)
{
  Guide_document(out, guide, threads).write();
}
