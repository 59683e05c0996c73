// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_TEST_VERIFY_FIXTURE_FILES_H
#define MULTIPLANAR_TEST_VERIFY_FIXTURE_FILES_H

#include "verify_fixture.h"

#include <filesystem>
#include <fstream>
#include <sstream>

/// The files of the box.
namespace verify_fixture {

// Sheets: parts in rows, some turned, some mirrored; cut paths by hand.

inline Flat place(const Json& placement, const Flat& p)
{
  const double a = placement["rotation"].get<double>() * pi / 180, c = std::cos(a), s = std::sin(a);
  const double x = placement["mirrored"].get<bool>() ? -p[0] : p[0];
  return {c * x - s * p[1] + placement["x"].get<double>(), s * x + c * p[1] + placement["y"].get<double>()};
}

inline void add_sheets(Json& model)
{
  double x = 5, y = 5, row = 0;
  int n = 0;
  for (const char* name : {"sheets/sheet-1.svg", "sheets/sheet-2.svg"})
    model["sheets"].push_back({{"file", name}, {"width", 600.0}, {"height", 400.0}, {"placements", Json::array()}});
  for (const Json& part : model["parts"]) {
    Json placement = {
        {"part", part["id"]}, {"x", 0.0}, {"y", 0.0}, {"rotation", 30.0 * (n % 4)}, {"mirrored", n % 3 > 0}};
    Flat low = {1e9, 1e9}, high = {-1e9, -1e9};
    for (const Json& q : part["outline"]) {
      const Flat p = place(placement, q.get<Flat>());
      for (int k = 0; k < 2; ++k) low[k] = (std::min)(low[k], p[k]), high[k] = (std::max)(high[k], p[k]);
    }
    const double w = high[0] - low[0], h = high[1] - low[1];
    if (x + w > 590) x = 5, y += row + 3, row = 0;
    placement["x"] = x - low[0];
    placement["y"] = y - low[1];
    x += w + 3;
    row = (std::max)(row, h);
    model["sheets"][n == 5 ? 1 : 0]["placements"].push_back(placement);
    ++n;
  }
}

/// The ring with every side moved to its right by its own amount, corners where the moved sides meet; where `round`,
/// convex corners (left turns) become arcs around the old corner.
inline Ring offset(const Ring& ring, const std::vector<double>& by, bool round)
{
  const int n = int(ring.size());
  const auto normal = [&](int i) -> Flat {
    const Flat &a = ring[(i + n) % n], &b = ring[(i + 1) % n];
    const double l = std::hypot(b[0] - a[0], b[1] - a[1]);
    return {(b[1] - a[1]) / l, (a[0] - b[0]) / l};
  };
  Ring result;
  for (int i = 0; i < n; ++i) {
    const double d0 = by[(i + n - 1) % n], d1 = by[i];
    const Flat p = ring[i], m = normal((i + n - 1) % n), k = normal(i);
    const double turn = m[0] * k[1] - m[1] * k[0], cosine = m[0] * k[0] + m[1] * k[1];
    if (round && turn > 1e-9) {
      const double angle = std::atan2(turn, cosine);
      const int steps = int(std::ceil(angle * d1 / 0.009)) + 1;
      for (int s = 0; s <= steps; ++s) {
        const double a = std::atan2(m[1], m[0]) + angle * s / steps;
        result.push_back({p[0] + d1 * std::cos(a), p[1] + d1 * std::sin(a)});
      }
    } else if (std::abs(turn) > 1e-9) {
      result.push_back({p[0] + (d0 * k[1] - d1 * m[1]) / turn, p[1] + (d1 * m[0] - d0 * k[0]) / turn});
    } else {
      result.push_back({p[0] + d1 * k[0], p[1] + d1 * k[1]});
    }
  }
  return result;
}

struct Cuts
{
  std::string id;
  Ring outer;
  std::vector<Ring> inner;
};

inline std::vector<Cuts> cuts_of_sheet(const Json& model, const Json& sheet)
{
  std::vector<Cuts> result;
  const double t = model["settings"]["kerf"].get<double>() / 2, f = model["settings"]["fit"].get<double>() / 2;
  for (const Json& placement : sheet["placements"]) {
    Json part;
    for (const Json& p : model["parts"])
      if (p["id"] == placement["part"]) part = p;
    if (part.is_null()) continue;
    const auto drawn = [&](const Ring& ring, const std::vector<double>& growth) {
      Ring path = offset(ring, growth, false);
      path = offset(path, std::vector<double>(path.size(), t), true);
      for (Flat& p : path) p = place(placement, p);
      return path;
    };
    const Ring outline = part["outline"].get<Ring>();
    std::vector<double> growth(outline.size(), 0);
    for (const Json& tab : part["tabs"]) growth[tab[0].get<int>()] = growth[tab[1].get<int>() - 1] = f;
    Cuts cuts{part["id"], drawn(outline, growth), {}};
    for (const Json& hole : part["holes"]) {
      const Ring ring = hole.get<Ring>();
      cuts.inner.push_back(drawn(ring, std::vector<double>(ring.size(), 0)));
    }
    result.push_back(cuts);
  }
  return result;
}

/// A point 0.8 mm inside the middle of the longest side.
inline Flat point_inside(const Ring& ring)
{
  const std::size_t n = ring.size();
  const auto vector = [&](std::size_t i) -> Flat {
    return {ring[(i + 1) % n][0] - ring[i][0], ring[(i + 1) % n][1] - ring[i][1]};
  };
  std::size_t longest = 0;
  for (std::size_t i = 1; i < n; ++i)
    if (std::hypot(vector(i)[0], vector(i)[1]) > std::hypot(vector(longest)[0], vector(longest)[1])) longest = i;
  const Flat d = vector(longest), a = ring[longest];
  const double s = (area(ring) > 0 ? 0.8 : -0.8) / std::hypot(d[0], d[1]);
  return {a[0] + d[0] / 2 - s * d[1], a[1] + d[1] / 2 + s * d[0]};
}

inline std::string svg_of_sheet(const Json& model, const Json& sheet)
{
  const double height = sheet["height"].get<double>();
  std::ostringstream out;
  out.precision(9);
  out << "<?xml version=\"1.0\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << sheet["width"]
      << "mm\" height=\"" << sheet["height"] << "mm\" viewBox=\"0 0 " << sheet["width"] << " " << sheet["height"]
      << "\">\n<g fill=\"none\" stroke-width=\"0.01\">\n";
  const auto path = [&](const Ring& ring) {
    out << "<path d=\"M";
    for (const Flat& p : ring) out << " " << p[0] << "," << height - p[1];
    out << " Z\"/>\n";
  };
  for (const char* layer : {"engrave", "inner", "outer"}) {
    const std::string name = layer;
    out << "<g inkscape:groupmode=\"layer\" inkscape:label=\"" << name << "\" stroke=\""
        << (name == "inner"   ? "blue"
            : name == "outer" ? "red"
                              : "black")
        << "\">\n";
    for (const Cuts& cuts : cuts_of_sheet(model, sheet)) {
      out << "<g id=\"" << cuts.id << (name == "outer" ? "" : "-" + name) << "\">\n";
      if (name == "engrave") {
        const Flat p = point_inside(cuts.outer);
        out << "<path d=\"M " << p[0] << " " << height - p[1] << " l 0.1 0 h 0.1 v 0.1\"/>\n";
      }
      if (name == "outer") path(cuts.outer);
      if (name == "inner")
        for (const Ring& ring : cuts.inner) path(ring);
      out << "</g>\n";
    }
    out << "</g>\n";
  }
  out << "</g>\n</svg>\n";
  return out.str();
}

inline std::string dxf_of_sheet(const Json& model, const Json& sheet)
{
  std::ostringstream out;
  out.precision(12);
  out << "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1015\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n";
  const auto polyline = [&](const char* layer, const Ring& ring) {
    out << "0\nLWPOLYLINE\n8\n" << layer << "\n90\n" << ring.size() << "\n70\n1\n";
    for (const Flat& p : ring) out << "10\n" << p[0] << "\n20\n" << p[1] << "\n";
  };
  for (const Cuts& cuts : cuts_of_sheet(model, sheet)) {
    polyline("CUT_OUTER", cuts.outer);
    for (const Ring& ring : cuts.inner) polyline("CUT_INNER", ring);
  }
  out << "0\nENDSEC\n0\nEOF\n";
  return out.str();
}

inline void write_text(const std::filesystem::path& file, const std::string& text)
{
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << text;
}

inline std::string read_text(const std::filesystem::path& file)
{
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

inline std::string shell_of_box(const Json& model)
{
  std::ostringstream out;
  out.precision(17);
  out << "ply\nformat ascii 1.0\nelement vertex 8\nproperty double x\nproperty double y\nproperty double z\n"
         "element face "
      << 2 * model["panels"].size() << "\nproperty list uchar int vertex_indices\nproperty int panel\nend_header\n";
  const double scale = model["input"]["scale"].get<double>();
  for (const Json& c : model["corners"])
    out << c[0].get<double>() / scale << " " << c[1].get<double>() / scale << " " << c[2].get<double>() / scale << "\n";
  for (std::size_t p = 0; p < model["panels"].size(); ++p) {
    const Json& l = model["panels"][p]["loops"][0];
    out << "3 " << l[0] << " " << l[1] << " " << l[2] << " " << p << "\n3 " << l[0] << " " << l[2] << " " << l[3] << " "
        << p << "\n";
  }
  return out.str();
}

inline std::string obj_of_model(const Json& model)
{
  std::ostringstream out;
  out.precision(17);
  for (const Json& c : model["corners"]) out << "v " << c[0] << " " << c[1] << " " << c[2] << "\n";
  for (const Json& panel : model["panels"]) {
    out << "g " << panel["id"].get<std::string>() << "\nf";
    for (const Json& c : panel["loops"][0]) out << " " << c.get<int>() + 1;
    out << "\n";
  }
  return out.str();
}

inline void write_model(const std::filesystem::path& dir, const Json& model)
{
  write_text(dir / "model.json", model.dump(1));
}

/// Everything that a directory holds.
inline void write_all(const std::filesystem::path& dir, const Json& model)
{
  write_model(dir, model);
  if (model.contains("sheets"))
    for (const Json& sheet : model["sheets"]) {
      const std::filesystem::path file = dir / sheet["file"].get<std::string>();
      write_text(file, svg_of_sheet(model, sheet));
      write_text(std::filesystem::path(file).replace_extension(".dxf"), dxf_of_sheet(model, sheet));
    }
  write_text(dir / "panels.obj", obj_of_model(model));
  write_text(dir / "shell.ply", shell_of_box(model));
  write_text(dir / "report.json", "{\"warnings\": []}");
}

} // namespace verify_fixture

#endif // MULTIPLANAR_TEST_VERIFY_FIXTURE_FILES_H
