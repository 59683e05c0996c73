// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "drawing.h"
#include "text_file.h"
#include "xml.h"

#include <cmath>
#include <optional>
#include <set>

namespace CGAL {
namespace Multiplanar {
namespace verification {
namespace {

/// The path data of the SVG recommendation, straight lines only: M L H V Z and their relative forms.
class Path_reader
{
public:
  Path_reader(const std::string& data, const std::string& place) : data(data), place(place) {}

  std::vector<Path> read()
  {
    std::vector<Path> paths;
    char command = 0;
    for (skip(); at < data.size(); skip()) {
      if (std::isalpha(static_cast<unsigned char>(data[at]))) {
        command = data[at++];
        if (command == 'z' || command == 'Z') {
          if (paths.empty() || paths.back().closed) fail("'Z' closes nothing");
          paths.back().closed = true;
          x = paths.back().points.front().x();
          y = paths.back().points.front().y();
          continue;
        }
      }
      step(command, paths);
      if (command == 'M') command = 'L';
      if (command == 'm') command = 'l';
    }
    for (Path& path : paths)
      if (path.points.size() > 1 && path.closed && path.points.front() == path.points.back()) path.points.pop_back();
    return paths;
  }

private:
  [[noreturn]] void fail(const std::string& what) const { throw Unreadable(place + ": path data: " + what); }

  void skip()
  {
    while (at < data.size() &&
           (data[at] == ' ' || data[at] == ',' || data[at] == '\n' || data[at] == '\t' || data[at] == '\r'))
      ++at;
  }

  double number()
  {
    skip();
    const std::optional<Parsed_number> n = parse_number(data, at);
    if (!n) fail(at >= data.size() ? "breaks off" : std::string("unexpected '") + data[at] + "'");
    at = n->end;
    return n->value;
  }

  void step(char command, std::vector<Path>& paths)
  {
    const bool relative = command >= 'a';
    switch (command) {
    case 'M':
    case 'm':
    case 'L':
    case 'l': {
      const double nx = number(), ny = number();
      x = nx + (relative ? x : 0);
      y = ny + (relative ? y : 0);
      break;
    }
    case 'H':
    case 'h':
      x = number() + (relative ? x : 0);
      break;
    case 'V':
    case 'v':
      y = number() + (relative ? y : 0);
      break;
    default:
      fail(std::string("unknown command '") + (command ? command : data[at]) + "'");
    }
    const bool starts = command == 'M' || command == 'm';
    if (!starts && paths.empty()) fail("does not start with 'M'");
    if (starts || paths.back().closed) paths.push_back({Layer::outer, "", {}, false});
    if (!starts && paths.back().points.empty()) fail("goes on after 'Z' without 'M'");
    paths.back().points.emplace_back(x, y);
  }

  const std::string& data;
  const std::string place;
  std::size_t at = 0;
  double x = 0, y = 0;
};

/// What children inherit.
struct Style
{
  std::string stroke, fill = "black", group;
  std::optional<Layer> layer;
  std::string layer_name;
};

std::string property(const Xml_element& e, const std::string& key)
{
  const std::string style = e["style"], pattern = key + ":";
  for (std::size_t at = 0; (at = style.find(pattern, at)) != std::string::npos; ++at)
    if (at == 0 || style[at - 1] == ';' || style[at - 1] == ' ')
      return style.substr(at + pattern.size(), style.find(';', at) - at - pattern.size());
  return e[key];
}

std::optional<Layer> layer_of(const std::string& label)
{
  if (label.find("inner") != std::string::npos) return Layer::inner;
  if (label.find("outer") != std::string::npos) return Layer::outer;
  if (label.find("engrave") != std::string::npos) return Layer::engrave;
  return std::nullopt;
}

class Svg_reader
{
public:
  explicit Svg_reader(const std::string& file) : file(file) {}

  Drawing read(const Xml_element& root)
  {
    if (root.name != "svg") throw Unreadable(file + ": is no SVG");
    drawing.width = millimetres(root, "width");
    drawing.height = millimetres(root, "height");
    check_view_box(root);
    Style style;
    inherit(root, style);
    for (const Xml_element& child : root.children) visit(child, style);
    check_colours();
    for (Path& path : drawing.paths)
      for (Point_2& p : path.points) p = Point_2(p.x(), drawing.height - p.y());
    return drawing;
  }

private:
  void complain(const std::string& what) { drawing.complaints.push_back(file + ": " + what); }
  std::string place(const Xml_element& e) const { return file + ": line " + std::to_string(e.line); }

  double millimetres(const Xml_element& root, const char* key)
  {
    const std::string value = root[key];
    const auto n = parse_number(value, 0);
    if (!n) throw Unreadable(file + ": its " + key + " is no length");
    if (value.substr(n->end) != "mm") complain(std::string("its ") + key + " is not given in mm");
    return n->value;
  }

  void check_view_box(const Xml_element& root)
  {
    const std::string box = root["viewBox"];
    const std::vector<double> n = parse_numbers(box);
    if (n.size() != 4 || n[0] != 0 || n[1] != 0 || n[2] != drawing.width || n[3] != drawing.height)
      complain("its viewBox does not make a unit a millimetre");
  }

  static void inherit(const Xml_element& e, Style& style)
  {
    if (const std::string s = property(e, "stroke"); !s.empty()) style.stroke = s;
    if (const std::string s = property(e, "fill"); !s.empty()) style.fill = s;
    if (!e["id"].empty()) style.group = e["id"];
  }

  void visit(const Xml_element& e, Style style)
  {
    if (e.name == "text" || e.name == "tspan") complain("line " + std::to_string(e.line) + ": has a <text>");
    if (e.attributes.count("transform")) throw Unreadable(place(e) + ": sheets have no transform, this one has");
    if (e["inkscape:groupmode"] == "layer") {
      style.layer_name = e["inkscape:label"].empty() ? e["id"] : e["inkscape:label"];
      style.layer = layer_of(style.layer_name);
      if (!style.layer) complain("layer \"" + style.layer_name + "\" is neither engrave nor inner nor outer cuts");
    }
    const std::string group = style.group;
    inherit(e, style);
    if (e.name == "path") {
      style.group = group;
      read_path(e, style);
    }
    for (const char* shape : {"line", "polyline", "polygon", "rect", "circle", "ellipse", "use", "image"})
      if (e.name == shape) throw Unreadable(place(e) + ": sheets have only paths, this one has a <" + e.name + ">");
    for (const Xml_element& child : e.children) visit(child, style);
  }

  void read_path(const Xml_element& e, const Style& style)
  {
    if (!style.layer) {
      if (style.layer_name.empty()) complain("line " + std::to_string(e.line) + ": has a path in no layer");
      return;
    }
    if (style.fill != "none") complain("line " + std::to_string(e.line) + ": has a path that is filled");
    colours[*style.layer].insert(style.stroke);
    if (!drawing.paths.empty() && *style.layer < drawing.paths.back().layer)
      complain("line " + std::to_string(e.line) + ": " + name_of(*style.layer) + " comes after " +
               name_of(drawing.paths.back().layer));
    for (Path& path : Path_reader(e["d"], place(e)).read()) {
      path.layer = *style.layer;
      path.group = style.group;
      drawing.paths.push_back(path);
    }
  }

  void check_colours()
  {
    std::map<std::string, Layer> owner;
    for (const auto& layer : colours) {
      if (layer.second.size() != 1 || layer.second.begin()->empty())
        complain(std::string("the layer of ") + name_of(layer.first) + " has not one stroke colour");
      for (const std::string& colour : layer.second)
        if (const auto [it, fresh] = owner.emplace(colour, layer.first); !fresh)
          complain(std::string(name_of(layer.first)) + " and " + name_of(it->second) + " have the same colour");
    }
  }

  const std::string file;
  Drawing drawing;
  std::map<Layer, std::set<std::string>> colours;
};

} // namespace

const char* name_of(Layer layer)
{
  switch (layer) {
  case Layer::engrave:
    return "engraving";
  case Layer::inner:
    return "inner cuts";
  default:
    return "outer cuts";
  }
}

Drawing read_svg(const std::filesystem::path& file)
{
  const std::string name = file.filename().string(), text = read_text(file);
  return Svg_reader(name).read(parse_xml(text, name));
}

} // namespace verification
} // namespace Multiplanar
} // namespace CGAL
