// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "drawing.h"
#include "text_file.h"

#include <sstream>

namespace CGAL {
namespace Multiplanar {
namespace verification {
namespace {

/// A DXF file is a list of pairs: a group code and a value, a line each.
struct Pair
{
  int code;
  std::string value;
};

std::string trimmed(const std::string& s)
{
  const auto from = s.find_first_not_of(" \t\r"), to = s.find_last_not_of(" \t\r");
  return from == std::string::npos ? "" : s.substr(from, to - from + 1);
}

std::vector<Pair> read_pairs(const std::string& text, const std::string& file)
{
  std::vector<Pair> pairs;
  std::istringstream in(text);
  std::string code, value;
  while (std::getline(in, code)) {
    if (trimmed(code).empty() && in.peek() == EOF) break;
    const std::vector<double> n = parse_numbers(trimmed(code));
    if (n.size() != 1 || !std::getline(in, value))
      throw Unreadable(file + ": line " + std::to_string(2 * pairs.size() + 1) + ": no pair of group code and value");
    pairs.push_back({int(n[0]), trimmed(value)});
  }
  if (pairs.empty() || pairs.back().code != 0 || pairs.back().value != "EOF")
    throw Unreadable(file + ": breaks off before EOF");
  return pairs;
}

/// A header variable, or an empty text.
std::string header(const std::vector<Pair>& pairs, const std::string& name)
{
  for (std::size_t i = 0; i + 1 < pairs.size(); ++i)
    if (pairs[i].code == 9 && pairs[i].value == name) return pairs[i + 1].value;
  return "";
}

class Dxf_reader
{
public:
  explicit Dxf_reader(const std::string& file) : file(file) {}

  Drawing read(const std::vector<Pair>& pairs)
  {
    if (header(pairs, "$INSUNITS") != "4") complain("$INSUNITS is not 4: the unit is not said to be mm");
    if (header(pairs, "$ACADVER") != "AC1015") complain("$ACADVER is not AC1015: the file is no R2000");
    bool in_entities = false;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if (pairs[i].code != 0) continue;
      if (pairs[i].value == "SECTION") in_entities = i + 1 < pairs.size() && pairs[i + 1].value == "ENTITIES";
      if (pairs[i].value == "ENDSEC") in_entities = false;
      if (!in_entities || pairs[i].value == "SECTION") continue;
      std::size_t end = i + 1;
      while (end < pairs.size() && pairs[end].code != 0) ++end;
      read_entity(pairs, i, end);
    }
    return drawing;
  }

private:
  void complain(const std::string& what) { drawing.complaints.push_back(file + ": " + what); }

  [[noreturn]] void fail(std::size_t pair, const std::string& what) const
  {
    throw Unreadable(file + ": line " + std::to_string(2 * pair + 1) + ": " + what);
  }

  double number(const std::vector<Pair>& pairs, std::size_t i) const
  {
    const std::vector<double> n = parse_numbers(pairs[i].value);
    if (n.size() != 1) fail(i, "is no number");
    return n[0];
  }

  void read_entity(const std::vector<Pair>& pairs, std::size_t begin, std::size_t end)
  {
    Path path{Layer::engrave, "", {}, false};
    std::string layer;
    std::vector<double> xs, ys;
    double count = -1;
    for (std::size_t i = begin + 1; i < end; ++i) {
      switch (pairs[i].code) {
      case 8:
        layer = pairs[i].value;
        break;
      case 10:
        xs.push_back(number(pairs, i));
        break;
      case 20:
        ys.push_back(number(pairs, i));
        break;
      case 70:
        path.closed = int(number(pairs, i)) & 1;
        break;
      case 90:
        count = number(pairs, i);
        break;
      case 42:
        if (number(pairs, i) != 0) fail(i, "sheets have no arcs, this one has");
        break;
      }
    }
    if (layer == "CUT_INNER") path.layer = Layer::inner;
    else if (layer == "CUT_OUTER") path.layer = Layer::outer;
    else if (layer != "ENGRAVE")
      return complain("has a " + pairs[begin].value + " in the unknown layer \"" + layer + "\"");
    if (pairs[begin].value != "LWPOLYLINE") {
      if (path.layer != Layer::engrave) complain(std::string(name_of(path.layer)) + " have a " + pairs[begin].value);
      return;
    }
    if (xs.size() != ys.size() || count != double(xs.size()))
      fail(begin, "the polyline has not as many vertices as it says");
    for (std::size_t i = 0; i < xs.size(); ++i) path.points.emplace_back(xs[i], ys[i]);
    if (path.closed && path.points.size() > 1 && path.points.front() == path.points.back()) path.points.pop_back();
    drawing.paths.push_back(path);
  }

  const std::string file;
  Drawing drawing;
};

} // namespace

Drawing read_dxf(const std::filesystem::path& file)
{
  const std::string name = file.filename().string();
  return Dxf_reader(name).read(read_pairs(read_text(file), name));
}

} // namespace verification
} // namespace Multiplanar
} // namespace CGAL
