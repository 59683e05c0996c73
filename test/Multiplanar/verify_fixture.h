// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_TEST_VERIFY_FIXTURE_H
#define MULTIPLANAR_TEST_VERIFY_FIXTURE_H

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

/// A box of six panels, truncated, joined and laid out by hand, written as the program writes its models. Nothing of
/// the package is used, so that the verifier is tried on numbers that neither it nor what it verifies has made.
namespace verify_fixture {

using Json = nlohmann::ordered_json;
using Vec = std::array<double, 3>;
using Flat = std::array<double, 2>;
using Ring = std::vector<Flat>;

inline Vec operator+(const Vec& a, const Vec& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Vec operator-(const Vec& a, const Vec& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Vec operator*(double s, const Vec& a) { return {s * a[0], s * a[1], s * a[2]}; }
inline double dot(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Vec cross(const Vec& a, const Vec& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Vec axis(int i) { return {i == 0 ? 1. : 0., i == 1 ? 1. : 0., i == 2 ? 1. : 0.}; }

inline double area(const Ring& r)
{
  double sum = 0;
  for (std::size_t i = 0; i < r.size(); ++i) {
    const Flat &a = r[i], &b = r[(i + 1) % r.size()];
    sum += a[0] * b[1] - a[1] * b[0];
  }
  return sum / 2;
}

constexpr double thickness = 3, kerf = 0.15, fit = 0.05;
constexpr Vec size = {100, 80, 60};
const double pi = std::acos(-1.0);

struct Part
{
  std::string id;
  bool panel = true;
  Vec origin, u, v, normal;
  Ring outline;            ///< counter-clockwise
  std::vector<Ring> holes; ///< clockwise
  std::vector<std::array<int, 2>> tabs;

  Flat flat(const Vec& p) const { return {dot(p - origin, u), dot(p - origin, v)}; }
};

/// Panels 0..5 face -z +z -y +y -x +x; panel 2i+1 faces along +.
inline int axis_of_panel(int p) { return 2 - p / 2; }
inline double sign_of_panel(int p) { return p % 2 ? 1 : -1; }
inline std::string panel_id(int p) { return "P0" + std::to_string(p + 1); }

inline Part panel_frame(int p)
{
  Part part;
  part.id = panel_id(p);
  const int a = axis_of_panel(p);
  const double s = sign_of_panel(p);
  part.normal = s * axis(a);
  part.u = axis((a + (s > 0 ? 1 : 2)) % 3);
  part.v = axis((a + (s > 0 ? 2 : 1)) % 3);
  part.origin = s > 0 ? size[a] * axis(a) : Vec{0, 0, 0};
  return part;
}

inline int corner(const Vec& p) { return (p[0] > 0 ? 1 : 0) + (p[1] > 0 ? 2 : 0) + (p[2] > 0 ? 4 : 0); }

/// The panel as a rectangle: -z and +z are whole, -y and +y give way to them, -x and +x to all others.
inline Part rectangular_panel(int p)
{
  Part part = panel_frame(p);
  const int a = axis_of_panel(p);
  const auto margin = [&](const Vec& direction) {
    const int along = direction[0] != 0 ? 0 : direction[1] != 0 ? 1 : 2;
    return along > a ? thickness : 0.0;
  };
  const double w = dot(size, part.u), h = dot(size, part.v), x = margin(part.u), y = margin(part.v);
  part.outline = {{x, y}, {w - x, y}, {w - x, h - y}, {x, h - y}};
  return part;
}

/// The edge between panels a < b: from, to, in the direction of the remaining axis.
struct Edge
{
  int a, b;
  Vec from, to;
};

inline std::vector<Edge> edges()
{
  std::vector<Edge> result;
  for (int a = 0; a < 6; ++a)
    for (int b = a + 1; b < 6; ++b) {
      if (a / 2 == b / 2) continue;
      const int i = axis_of_panel(a), j = axis_of_panel(b), k = 3 - i - j;
      Vec from = {0, 0, 0};
      if (sign_of_panel(a) > 0) from = from + size[i] * axis(i);
      if (sign_of_panel(b) > 0) from = from + size[j] * axis(j);
      result.push_back({a, b, from, from + size[k] * axis(k)});
    }
  return result;
}

inline std::string connector_id(int e)
{
  std::string n = std::to_string(e + 1);
  return "C" + std::string(3 - n.size(), '0') + n;
}

/// A connector in the middle of an edge, whose tabs pass through both panels; cuts their slots.
inline Part add_connector(int e, std::vector<Part>& panels)
{
  const double t = thickness, m = 8, w = 10;
  const Edge edge = edges()[e];
  Part c;
  c.id = connector_id(e);
  c.panel = false;
  c.u = -1 * panels[edge.b].normal;
  c.v = -1 * panels[edge.a].normal;
  c.normal = cross(c.u, c.v);
  c.origin = 0.5 * (edge.from + edge.to) + (t / 2) * c.normal;
  c.outline = {{t, t},         {m, t},     {m, 0},     {m + w, 0}, {m + w, t}, {m + w + 2, t},
               {t, m + w + 2}, {t, m + w}, {0, m + w}, {0, m},     {t, m}};
  c.tabs = {{1, 4}, {7, 10}};
  const auto cut_slot = [&](Part& panel, const Vec& along) {
    Ring slot;
    for (const Flat& q : Ring{{m, 0}, {m + w, 0}, {m + w, t}, {m, t}})
      slot.push_back(panel.flat(c.origin + q[0] * along - q[1] * c.normal));
    if (area(slot) > 0) std::reverse(slot.begin(), slot.end());
    panel.holes.push_back(slot);
  };
  cut_slot(panels[edge.a], c.u);
  cut_slot(panels[edge.b], c.v);
  return c;
}

/// Gives the four upright edges teeth, 6 mm wide: -y and +y are notched where -x and +x have teeth.
inline void add_teeth(std::vector<Part>& panels)
{
  const double t = thickness, top = size[2] - t;
  for (int p = 2; p < 6; ++p) {
    Part& part = panels[p];
    const bool teeth = p >= 4, z_is_v = part.v[2] != 0;
    const double w = z_is_v ? dot(size, part.u) : dot(size, part.v);
    const double in = teeth ? t : 0, out = teeth ? 0 : t; // at even intervals, at odd intervals
    Ring right, left;
    std::vector<std::array<int, 2>> tabs;
    for (int i = 0; i < 9; ++i) {
      const double from = t + 6 * i, to = from + 6, x = i % 2 ? out : in;
      right.push_back({w - x, from}), right.push_back({w - x, to});
      left.push_back({x, from}), left.push_back({x, to});
    }
    (void)top;
    std::reverse(left.begin(), left.end());
    Ring outline = right;
    outline.insert(outline.end(), left.begin(), left.end());
    // A tooth is the odd interval i with the corners before and behind it.
    for (int side = 0; side < 2 && teeth; ++side)
      for (int i = 1; i < 9; i += 2) tabs.push_back({18 * side + 2 * i - 1, 18 * side + 2 * i + 2});
    if (!z_is_v) {
      for (Flat& q : outline) std::swap(q[0], q[1]);
      std::reverse(outline.begin(), outline.end());
      for (auto& tab : tabs) tab = {35 - tab[1], 35 - tab[0]};
    }
    part.outline = outline;
    part.tabs = tabs;
  }
}

inline Json json_of(const Part& p)
{
  double a = area(p.outline);
  for (const Ring& hole : p.holes) a -= std::abs(area(hole));
  return {{"id", p.id},
          {"kind", p.panel ? "panel" : "connector"},
          {"frame", {{"origin", p.origin}, {"u", p.u}, {"v", p.v}, {"normal", p.normal}}},
          {"outline", p.outline},
          {"holes", p.holes},
          {"area", a},
          {"tabs", p.tabs},
          {"engraving", Json::array()}};
}

enum class Joints
{
  none,
  connectors,
  teeth
};

/// The whole of model.json but for its sheets.
inline Json make_box(Joints joints)
{
  Json model = {{"format", "multiplanar-model"}, {"version", 1}, {"unit", "mm"}};
  model["input"] = {{"file", "box.off"}, {"scale", 2.0}};
  model["settings"] = {{"panels", 6}, {"thickness", thickness}, {"kerf", kerf}, {"fit", fit}, {"seed", 0}};
  for (int c = 0; c < 8; ++c)
    model["corners"].push_back({c & 1 ? size[0] : 0., c & 2 ? size[1] : 0., c & 4 ? size[2] : 0.});
  std::vector<Part> panels, connectors;
  for (int p = 0; p < 6; ++p) {
    panels.push_back(rectangular_panel(p));
    const Part& f = panels.back();
    const Vec u = dot(size, f.u) * f.u, v = dot(size, f.v) * f.v;
    const Json loop = {corner(f.origin), corner(f.origin + u), corner(f.origin + u + v), corner(f.origin + v)};
    model["panels"].push_back(
        {{"id", f.id}, {"normal", f.normal}, {"offset", dot(f.origin, f.normal)}, {"loops", {loop}}});
  }
  if (joints == Joints::teeth) add_teeth(panels);
  const auto all_edges = edges();
  for (int e = 0; e < int(all_edges.size()); ++e) {
    const Edge& edge = all_edges[e];
    const bool upright = edge.from[2] != edge.to[2];
    Json entry = {{"id", "E0" + std::string(e < 9 ? "0" : "") + std::to_string(e + 1)},
                  {"panels", {panel_id(edge.a), panel_id(edge.b)}},
                  {"corners", {corner(edge.from), corner(edge.to)}},
                  {"dihedral", 90.0},
                  {"joint", "none"},
                  {"parts", Json::array()}};
    if (joints == Joints::connectors) {
      connectors.push_back(add_connector(e, panels));
      entry["joint"] = "connector";
      entry["parts"] = {connectors.back().id};
    } else if (joints == Joints::teeth && upright) {
      entry["joint"] = "teeth";
    } else if (joints == Joints::teeth) {
      entry["reason"] = "glue";
    }
    model["edges"].push_back(entry);
  }
  for (const auto* list : {&panels, &connectors})
    for (const Part& part : *list) model["parts"].push_back(json_of(part));
  return model;
}

/// The base first, then the sides, the lid last; the connectors of an edge come with the panel placed first.
inline void add_assembly(Json& model)
{
  const std::array<int, 6> order = {0, 2, 3, 4, 5, 1};
  std::array<int, 6> rank;
  for (int i = 0; i < 6; ++i) rank[order[i]] = i;
  const auto all_edges = edges();
  for (int i = 0; i < 6; ++i) {
    Json parts = {panel_id(order[i])};
    for (int e = 0; e < int(all_edges.size()); ++e)
      if ((std::min)(rank[all_edges[e].a], rank[all_edges[e].b]) == i) parts.push_back(connector_id(e));
    model["assembly"].push_back({{"step", i + 1},
                                 {"parts", parts},
                                 {"direction", -1 * panel_frame(order[i]).normal},
                                 {"travel", thickness + 1}});
  }
}

} // namespace verify_fixture

#endif // MULTIPLANAR_TEST_VERIFY_FIXTURE_H
