// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks.h"
#include "cut_paths.h"
#include "drawing.h"
#include "loops.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace CGAL {
namespace Multiplanar {
namespace verification {
namespace {

/// The cuts of one part of a drawing.
struct Part_cuts
{
  std::vector<const Loop*> outer, inner;
};

/// A drawing beside what model.json says about the sheet.
class Drawing_check
{
public:
  Drawing_check(const Written_model& model, const Written_sheet& sheet, const Drawing& drawing, std::string file,
                Report& report)
      : model(model), drawing(drawing), file(std::move(file)), report(report), sheet(sheet)
  {
    for (const Written_placement& placement : sheet.placements) {
      const int index = model.part_index(placement.part);
      if (index < 0) continue;
      const Written_part& part = model.parts[index];
      if (problem_of_region(part.outline, part.holes).empty()) parts.push_back(place(part, placement));
    }
    cuts.resize(parts.size());
  }

  void run()
  {
    for (const std::string& complaint : drawing.complaints) report.violation(complaint);
    if (drawing.width != 0 &&
        (std::abs(drawing.width - sheet.width) > 1e-4 || std::abs(drawing.height - sheet.height) > 1e-4))
      say("is " + shown(drawing.width) + " x " + shown(drawing.height) + " mm, the sheet in model.json is not");
    for (const Path& path : drawing.paths)
      if (path.layer != Layer::engrave) check_path(path);
    for (std::size_t i = 0; i < parts.size(); ++i)
      for (const std::string& said : problems_of_cuts(parts[i], cuts[i].outer, cuts[i].inner, model.kerf, model.fit))
        say("part " + parts[i].id + ": " + said);
    check_no_side_twice();
    check_apart();
    for (const Path& path : drawing.paths)
      if (path.layer == Layer::engrave) check_engraving(path.points);
  }

private:
  void say(const std::string& what) { report.violation(file + ": " + what); }

  void check_path(const Path& path)
  {
    const std::string name = std::string("a path among the ") + name_of(path.layer);
    if (path.points.size() < 3) return say(name + " has fewer than three points");
    if (!path.closed) return say(name + " at " + shown(path.points[0]) + " is not closed");
    for (const Point_2& p : path.points)
      if ((std::max)({-p.x(), -p.y(), p.x() - sheet.width, p.y() - sheet.height}) > 1e-3)
        return say(name + " leaves the sheet at " + shown(p));
    const int part = path.group.empty() ? nearest_part(path) : part_of_group(path.group);
    if (part < 0)
      return say(name + " at " + shown(path.points[0]) + " belongs to no part of the sheet" +
                 (path.group.empty() ? "" : ": its group is " + path.group));
    (path.layer == Layer::outer ? cuts[part].outer : cuts[part].inner).push_back(&path.points);
  }

  /// Groups have the id of a part, maybe followed by "-" and more.
  int part_of_group(const std::string& group) const
  {
    int best = -1;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const std::string& id = parts[i].id;
      if (group.compare(0, id.size(), id) != 0 || (group.size() > id.size() && group[id.size()] != '-')) continue;
      if (best < 0 || id.size() > parts[best].id.size()) best = int(i);
    }
    return best;
  }

  /// For formats without groups. An outer cut belongs to the part whose box is most like its own, an inner cut to the
  /// part around it whose boundary is nearest to kerf / 2 away.
  int nearest_part(const Path& path) const
  {
    int best = -1;
    double least = 1e300;
    const CGAL::Bbox_2 box = box_of(path.points);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const CGAL::Bbox_2 other = box_of(parts[i].outline);
      if (!CGAL::do_overlap(box, other)) continue;
      double off = 0;
      if (path.layer == Layer::outer)
        for (int k = 0; k < 2; ++k)
          off += std::abs(other.min(k) - model.kerf / 2 - box.min(k)) +
                 std::abs(other.max(k) + model.kerf / 2 - box.max(k));
      else off = std::abs(parts[i].distance_to_boundary(path.points[0]) - model.kerf / 2);
      if (off < least) least = off, best = int(i);
    }
    return best;
  }

  /// An engraved line crosses no cut, and lies in what one outer cut frees.
  void check_engraving(const Loop& line)
  {
    if (line.size() < 2) return say("an engraved line at " + shown(line[0]) + " has no length");
    const CGAL::Bbox_2 box = box_of(line);
    bool on_a_part = false;
    for (const Part_cuts& part : cuts) {
      if (part.outer.size() != 1 || !CGAL::do_overlap(box, box_of(*part.outer[0]))) continue;
      for (const Loop* cut : all(part))
        if (CGAL::do_overlap(box, box_of(*cut)) && crosses(line, *cut))
          return say("engraving at " + shown(line[0]) + " crosses a cut");
      on_a_part = on_a_part || frees(part, line[0]);
    }
    if (!on_a_part) say("engraving at " + shown(line[0]) + " is on no part");
  }

  static bool crosses(const Loop& line, const Loop& cut)
  {
    using Segment = Kernel::Segment_2;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const Segment stroke(line[i], line[i + 1]);
      for (std::size_t k = 0; k < cut.size(); ++k) {
        const Segment side(cut[k], cut[(k + 1) % cut.size()]);
        if (CGAL::do_overlap(stroke.bbox(), side.bbox()) && CGAL::do_intersect(stroke, side)) return true;
      }
    }
    return false;
  }

  void check_no_side_twice()
  {
    std::set<std::array<long long, 4>> seen;
    const auto grid = [](double x) { return std::llround(x * 1e6); };
    for (const Path& path : drawing.paths) {
      if (path.layer == Layer::engrave) continue;
      for (std::size_t i = 0; i < path.points.size(); ++i) {
        std::array<Point_2, 2> s = {path.points[i], path.points[(i + 1) % path.points.size()]};
        if (s[1] < s[0]) std::swap(s[0], s[1]);
        if (!seen.insert({grid(s[0].x()), grid(s[0].y()), grid(s[1].x()), grid(s[1].y())}).second)
          return say("the side from " + shown(s[0]) + " to " + shown(s[1]) + " is drawn twice");
      }
    }
  }

  /// What the outer cut frees, less what the inner cuts take away.
  static bool frees(const Part_cuts& part, const Point_2& p)
  {
    return side_of(*part.outer[0], p) > 0 &&
           std::none_of(part.inner.begin(), part.inner.end(), [&](const Loop* l) { return side_of(*l, p) >= 0; });
  }

  bool overlap(const Part_cuts& a, const Part_cuts& b) const
  {
    if (!CGAL::do_overlap(box_of(*a.outer[0]), box_of(*b.outer[0]))) return false;
    for (const Loop* l : all(a))
      for (const Loop* m : all(b))
        if (boundaries_meet(*l, *m)) return true;
    return frees(a, b.outer[0]->front()) || frees(b, a.outer[0]->front());
  }

  static std::vector<const Loop*> all(const Part_cuts& part)
  {
    std::vector<const Loop*> loops = part.inner;
    loops.push_back(part.outer[0]);
    return loops;
  }

  void check_apart()
  {
    const auto usable = [](const Part_cuts& part) {
      return part.outer.size() == 1 &&
             std::all_of(part.inner.begin(), part.inner.end(), [](const Loop* l) { return is_simple(*l); }) &&
             is_simple(*part.outer[0]);
    };
    std::vector<bool> use;
    for (const Part_cuts& part : cuts) use.push_back(usable(part));
    for (std::size_t i = 0; i < parts.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (use[i] && use[j] && overlap(cuts[i], cuts[j]))
          say("the cuts of the parts " + parts[j].id + " and " + parts[i].id + " overlap");
  }

  const Written_model& model;
  const Drawing& drawing;
  const std::string file;
  Report& report;
  const Written_sheet& sheet;
  std::vector<Placed_part> parts;
  std::vector<Part_cuts> cuts; ///< by part
};

/// \return the number of paths compared
template <class Reader>
std::size_t check_drawing(const Written_model& model, const Written_sheet& sheet,
                          const std::filesystem::path& directory, const std::filesystem::path& file, Reader read,
                          Report& report)
{
  try {
    const Drawing drawing = read(directory / file);
    Drawing_check(model, sheet, drawing, file.generic_string(), report).run();
    return drawing.paths.size();
  } catch (const Unreadable& e) {
    report.unreadable((file.parent_path() / e.what()).generic_string());
    return 0;
  }
}

void check_svg(const Written_model& model, const std::filesystem::path& directory, Report& report)
{
  report.begin("svg");
  if (model.sheets.empty()) return report.not_claimed("model.json lists no sheets");
  std::size_t paths = 0;
  for (const Written_sheet& sheet : model.sheets)
    if (!std::filesystem::exists(directory / sheet.file))
      report.violation(sheet.file + " is named in model.json but does not exist");
    else paths += check_drawing(model, sheet, directory, sheet.file, read_svg, report);
  report.checked(counted(model.sheets.size(), "file") + " with " + counted(paths, "path") +
                 ": cuts at half the kerf from the parts, closed, simple, disjoint");
}

void check_dxf(const Written_model& model, const std::filesystem::path& directory, Report& report)
{
  report.begin("dxf");
  std::vector<const Written_sheet*> with, without;
  for (const Written_sheet& sheet : model.sheets) {
    const auto file = std::filesystem::path(sheet.file).replace_extension(".dxf");
    (std::filesystem::exists(directory / file) ? with : without).push_back(&sheet);
  }
  if (with.empty()) return report.not_claimed("there is no DXF file");
  for (const Written_sheet* sheet : without)
    report.violation(sheet->file + " has no DXF file beside it, other sheets have");
  std::size_t paths = 0;
  for (const Written_sheet* sheet : with)
    paths += check_drawing(model, *sheet, directory, std::filesystem::path(sheet->file).replace_extension(".dxf"),
                           read_dxf, report);
  report.checked(counted(with.size(), "file") + " with " + counted(paths, "path") + ": the same cuts as the parts");
}

} // namespace

void check_drawings(const Written_model& model, const std::filesystem::path& directory, Report& report)
{
  check_svg(model, directory, report);
  check_dxf(model, directory, report);
}

} // namespace verification
} // namespace Multiplanar
} // namespace CGAL
