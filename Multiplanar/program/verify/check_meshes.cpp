// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks.h"
#include "loops.h"
#include "mesh_files.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace CGAL {
namespace Multiplanar {
namespace verification {
namespace {

using Side = std::pair<int, int>;

double length(const Vector_3& v) { return std::sqrt(v.squared_length()); }

/// The directed sides of closed walks, without those that are walked there and back.
std::set<Side> boundary_of(const std::vector<std::vector<int>>& loops)
{
  std::set<Side> sides;
  for (const auto& loop : loops)
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const int a = loop[i], b = loop[(i + 1) % loop.size()];
      if (sides.erase({b, a}) == 0) sides.insert({a, b});
    }
  return sides;
}

void check_polygon(const Written_model& model, const Written_mesh& mesh, std::size_t face, Report& report)
{
  const int panel = model.panel_index(mesh.groups[face]);
  if (panel < 0)
    return report.violation("panels.obj: a polygon is in the group \"" + mesh.groups[face] + "\", which is no panel");
  if (boundary_of({mesh.faces[face]}) != boundary_of(model.panels[panel].loops))
    report.violation("panels.obj: the polygon of " + mesh.groups[face] + " is not that of model.json");
}

} // namespace

void check_panels_obj(const Written_model& model, const std::filesystem::path& directory, Report& report)
{
  report.begin("panels.obj");
  if (!std::filesystem::exists(directory / "panels.obj")) return report.not_claimed("there is no such file");
  Written_mesh mesh;
  try {
    mesh = read_obj(directory / "panels.obj");
  } catch (const Unreadable& e) {
    return report.unreadable(e.what());
  }
  if (mesh.vertices.size() != model.corners.size())
    return report.violation("panels.obj has " + counted(mesh.vertices.size(), "vertex") + " for " +
                            counted(model.corners.size(), "corner"));
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
    if (length(mesh.vertices[i] - model.corners[i]) > 1e-9 * model.diagonal())
      return report.violation("panels.obj: vertex " + std::to_string(i + 1) + " is not corner " + std::to_string(i));
  if (mesh.faces.size() != model.panels.size())
    report.violation("panels.obj has " + counted(mesh.faces.size(), "polygon") + " for " +
                     counted(model.panels.size(), "panel"));
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) check_polygon(model, mesh, f, report);
  report.checked(counted(mesh.faces.size(), "polygon") + ", the same as in model.json");
}

namespace {

/// The triangles of the shell beside the panels of the model.
class Shell_check
{
public:
  Shell_check(const Written_model& model, const Written_mesh& mesh, Report& report)
      : model(model), mesh(mesh), report(report), tolerance(1e-9 * model.diagonal())
  {
    for (const Point_3& p : mesh.vertices)
      points.emplace_back(p.x() * model.scale, p.y() * model.scale, p.z() * model.scale);
  }

  void run()
  {
    if (!check_panel_numbers()) return;
    check_closed();
    check_pieces();
    check_planes();
    check_corners();
  }

private:
  void say(const std::string& what) { report.violation("shell.ply: " + what); }

  bool check_panel_numbers()
  {
    std::set<int> seen;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      if (mesh.faces[f].size() != 3) return say("face " + std::to_string(f) + " is no triangle"), false;
      if (mesh.panels[f] < 0 || mesh.panels[f] >= int(model.panels.size()))
        return say("face " + std::to_string(f) + " has no panel"), false;
      seen.insert(mesh.panels[f]);
    }
    for (std::size_t p = 0; p < model.panels.size(); ++p)
      if (!seen.count(int(p))) say("panel " + model.panels[p].id + " has no face");
    return true;
  }

  void check_closed()
  {
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
      for (int i = 0; i < 3; ++i) {
        const Side side = {mesh.faces[f][i], mesh.faces[f][(i + 1) % 3]};
        if (!face_of.emplace(side, int(f)).second) say("two faces run the same way along the edge " + shown(side));
      }
    for (const auto& entry : face_of)
      if (!face_of.count({entry.first.second, entry.first.first}))
        return say("the mesh is open at the edge " + shown(entry.first));
  }

  static std::string shown(const Side& side) { return std::to_string(side.first) + "-" + std::to_string(side.second); }

  void check_pieces()
  {
    std::vector<bool> visited(mesh.faces.size(), false);
    std::map<int, int> pieces;
    for (std::size_t start = 0; start < mesh.faces.size(); ++start) {
      if (visited[start]) continue;
      if (++pieces[mesh.panels[start]] == 2) say("panel " + model.panels[mesh.panels[start]].id + " is not connected");
      std::vector<int> stack = {int(start)};
      visited[start] = true;
      while (!stack.empty()) {
        const int f = stack.back();
        stack.pop_back();
        for (int i = 0; i < 3; ++i) {
          const auto found = face_of.find({mesh.faces[f][(i + 1) % 3], mesh.faces[f][i]});
          if (found == face_of.end() || visited[found->second] || mesh.panels[found->second] != mesh.panels[f])
            continue;
          visited[found->second] = true;
          stack.push_back(found->second);
        }
      }
    }
  }

  /// The triangles of a panel lie in its plane, none is turned over, and together they have its area.
  void check_planes()
  {
    std::vector<double> off(model.panels.size(), 0), area(model.panels.size(), 0);
    std::vector<int> turned(model.panels.size(), 0);
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      const int p = mesh.panels[f];
      const Written_panel& panel = model.panels[p];
      const Point_3 &a = points[mesh.faces[f][0]], &b = points[mesh.faces[f][1]], &c = points[mesh.faces[f][2]];
      for (const Point_3* x : {&a, &b, &c})
        off[p] = (std::max)(off[p], std::abs((*x - CGAL::ORIGIN) * panel.normal - panel.offset));
      const double twice = CGAL::cross_product(b - a, c - a) * panel.normal;
      turned[p] += twice < 0;
      area[p] += twice / 2;
    }
    for (std::size_t p = 0; p < model.panels.size(); ++p) {
      const std::string name = "panel " + model.panels[p].id;
      const double polygon = polygon_area(model.panels[p]);
      if (off[p] > 1.01 * tolerance) say(name + " has faces " + verification::shown(off[p]) + " mm off its plane");
      else if (turned[p] > 0) say(name + " has " + counted(turned[p], "face") + " turned over");
      else if (std::abs(area[p] - polygon) > 1e-6 * polygon + tolerance * perimeter(model.panels[p]))
        say(name + " has an area of " + verification::shown(area[p]) + " mm2, its polygon one of " +
            verification::shown(polygon));
    }
  }

  double polygon_area(const Written_panel& panel) const
  {
    double twice = 0;
    for (const auto& loop : panel.loops)
      for (std::size_t i = 1; i + 1 < loop.size(); ++i)
        twice += CGAL::cross_product(model.corners[loop[i]] - model.corners[loop[0]],
                                     model.corners[loop[i + 1]] - model.corners[loop[0]]) *
                 panel.normal;
    return twice / 2;
  }

  double perimeter(const Written_panel& panel) const
  {
    double sum = 0;
    for (const auto& loop : panel.loops)
      for (std::size_t i = 0; i < loop.size(); ++i)
        sum += length(model.corners[loop[(i + 1) % loop.size()]] - model.corners[loop[i]]);
    return sum;
  }

  void check_corners()
  {
    std::vector<Point_3> sorted = points;
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t c = 0; c < model.corners.size(); ++c) {
      const Point_3& p = model.corners[c];
      bool found = false;
      auto at = std::lower_bound(sorted.begin(), sorted.end(), p.x() - tolerance,
                                 [](const Point_3& q, double x) { return q.x() < x; });
      for (; at != sorted.end() && at->x() <= p.x() + tolerance && !found; ++at) found = length(*at - p) <= tolerance;
      if (!found) say("corner " + std::to_string(c) + " of model.json is no vertex of the mesh");
    }
  }

  const Written_model& model;
  const Written_mesh& mesh;
  Report& report;
  const double tolerance;
  std::vector<Point_3> points; ///< in mm
  std::map<Side, int> face_of;
};

} // namespace

void check_shell(const Written_model& model, const std::filesystem::path& directory, Report& report)
{
  report.begin("shell.ply");
  if (!std::filesystem::exists(directory / "shell.ply")) return report.not_claimed("there is no such file");
  try {
    const Written_mesh mesh = read_ply(directory / "shell.ply");
    Shell_check(model, mesh, report).run();
    report.checked(counted(mesh.faces.size(), "triangle") +
                   ": closed, each panel in one piece, in its plane, not folded");
  } catch (const Unreadable& e) {
    report.unreadable(e.what());
  }
}

} // namespace verification
} // namespace Multiplanar
} // namespace CGAL
