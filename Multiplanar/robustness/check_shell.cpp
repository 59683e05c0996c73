// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "check_shell.h"

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/shape_predicates.h>
#include <CGAL/Surface_mesh/IO/PLY.h>

#include <Eigen/SVD>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstdint>
#include <fstream>
#include <map>

namespace PMP = CGAL::Polygon_mesh_processing;

namespace {

using Edges = std::set<std::pair<std::size_t, std::size_t>>; ///< directed

constexpr double flatness = 1e-9; ///< of the diagonal

/// The directed edges of some polygons that no other of them takes back.
class Outline
{
public:
  template <class Range>
  void add(const Range& polygon)
  {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const std::size_t from = polygon[i], to = polygon[(i + 1) % polygon.size()];
      if (edges.erase({to, from}) == 0) edges.emplace(from, to);
    }
  }
  Edges edges;
};

Edges turned(const Edges& edges)
{
  Edges result;
  for (const auto& e : edges) result.emplace(e.second, e.first);
  return result;
}

std::array<std::size_t, 3> vertices_of(const Surface_mesh& shell, Surface_mesh::Face_index f)
{
  std::array<std::size_t, 3> result{};
  std::size_t i = 0;
  for (auto v : shell.vertices_around_face(shell.halfedge(f))) result[i++ % 3] = std::size_t(v);
  return result;
}

/// Every polygon of the input is the outline of its triangles, in the order of the file; all of them may be turned.
void check_connectivity(const Surface_mesh& shell, const Input& input, Broken_promises& broken)
{
  if (shell.number_of_vertices() != input.points.size() || int(shell.number_of_faces()) != input.faces) {
    broken.emplace_back(Verdict::connectivity, "the shell has other numbers of vertices and faces than the input");
    return;
  }
  auto face = shell.faces_begin();
  std::size_t same = 0, reversed = 0;
  for (const auto& polygon : input.polygons) {
    Outline wanted, found;
    wanted.add(polygon);
    for (std::size_t i = 2; i < polygon.size(); ++i) found.add(vertices_of(shell, *face++));
    same += found.edges == wanted.edges;
    reversed += found.edges == turned(wanted.edges);
  }
  if (same != input.polygons.size() && reversed != input.polygons.size())
    broken.emplace_back(Verdict::connectivity, "the triangles of the shell are not those of the input");
}

void check_surface(const Surface_mesh& shell, Broken_promises& broken)
{
  std::map<Surface_mesh::Face_index, std::size_t> pieces;
  if (!CGAL::is_closed(shell)) broken.emplace_back(Verdict::closed, "the shell is not closed");
  else if (PMP::connected_components(shell, boost::make_assoc_property_map(pieces)) != 1)
    broken.emplace_back(Verdict::closed, "the shell has several components");
  for (auto f : faces(shell))
    if (PMP::is_degenerate_triangle_face(f, shell)) {
      broken.emplace_back(Verdict::embedded, "face " + std::to_string(std::size_t(f)) + " is degenerate");
      return;
    }
  if (PMP::does_self_intersect(shell)) broken.emplace_back(Verdict::embedded, "the shell intersects itself");
}

/// The largest distance of some vertices to their plane of least squares.
double bend(const Surface_mesh& shell, const std::set<Surface_mesh::Vertex_index>& vertices)
{
  Eigen::MatrixXd points(vertices.size(), 3);
  Eigen::Index row = 0;
  for (auto v : vertices) {
    const Point_3& p = shell.point(v);
    points.row(row++) << p.x(), p.y(), p.z();
  }
  points.rowwise() -= points.colwise().mean().eval();
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(points, Eigen::ComputeThinV);
  return (points * svd.matrixV().col(2)).cwiseAbs().maxCoeff();
}

double diagonal_of(const Surface_mesh& shell)
{
  CGAL::Bbox_3 box;
  for (auto v : shell.vertices()) box += shell.point(v).bbox();
  return std::hypot(box.x_span(), box.y_span(), box.z_span());
}

using Panel_map = Surface_mesh::Property_map<Surface_mesh::Face_index, std::int32_t>;

/// Every panel is one connected piece, and flat. \return the number of panels
int check_panels(const Surface_mesh& shell, const Panel_map& panel, Broken_promises& broken)
{
  std::map<std::int32_t, std::set<Surface_mesh::Vertex_index>> vertices;
  std::map<std::int32_t, int> pieces;
  std::vector<char> seen(num_faces(shell), 0);
  for (auto start : shell.faces()) {
    if (seen[start]) continue;
    ++pieces[panel[start]];
    std::vector<Surface_mesh::Face_index> stack{start};
    seen[start] = 1;
    while (!stack.empty()) {
      const auto f = stack.back();
      stack.pop_back();
      for (auto h : shell.halfedges_around_face(shell.halfedge(f))) {
        vertices[panel[f]].insert(shell.target(h));
        const auto g = shell.face(shell.opposite(h));
        if (g == Surface_mesh::null_face() || seen[g] || panel[g] != panel[f]) continue;
        seen[g] = 1;
        stack.push_back(g);
      }
    }
  }
  const double most = flatness * diagonal_of(shell);
  for (const auto& p : vertices) {
    const std::string name = "panel " + std::to_string(p.first);
    if (pieces[p.first] > 1) broken.emplace_back(Verdict::connectivity, name + " is in several pieces");
    const double off = bend(shell, p.second);
    if (!(off <= most)) broken.emplace_back(Verdict::flat, name + " is bent by " + std::to_string(off / most) + "e-9");
  }
  if (vertices.begin()->first != 0 || vertices.rbegin()->first + 1 != int(vertices.size()))
    broken.emplace_back(Verdict::unreadable, "the panels of the shell are not numbered from 0");
  return int(vertices.size());
}

} // namespace

int check_shell(const std::string& file, const Input& input, int most_panels, Broken_promises& broken)
{
  Surface_mesh shell;
  std::string comments;
  std::ifstream in(file, std::ios::binary);
  if (!in || !CGAL::IO::read_PLY(in, shell, comments) || is_empty(shell) || !is_triangle_mesh(shell)) {
    broken.emplace_back(Verdict::unreadable, "shell.ply cannot be read as a triangle mesh");
    return -1;
  }
  check_surface(shell, broken);
  check_connectivity(shell, input, broken);
  const auto panel = shell.property_map<Surface_mesh::Face_index, std::int32_t>("f:panel");
  if (!panel.second) {
    broken.emplace_back(Verdict::unreadable, "shell.ply says no panels");
    return -1;
  }
  const int panels = check_panels(shell, panel.first, broken);
  if (panels > most_panels)
    broken.emplace_back(Verdict::k_exceeded,
                        std::to_string(panels) + " panels, asked for: " + std::to_string(most_panels));
  return panels;
}
