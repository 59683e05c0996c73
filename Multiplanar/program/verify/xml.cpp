// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "xml.h"

#include "written_model.h"

#include <algorithm>
#include <cstring>

namespace CGAL {
namespace Multiplanar {
namespace verification {
namespace {

class Parser
{
public:
  Parser(const std::string& text, const std::string& file) : text(text), file(file) {}

  Xml_element document()
  {
    skip_between();
    if (!starts("<")) fail("has no element");
    Xml_element root = element(0);
    skip_between();
    if (at < text.size()) fail("goes on after its end");
    return root;
  }

private:
  static constexpr int deepest = 100;

  int line() const { return 1 + int(std::count(text.begin(), text.begin() + at, '\n')); }

  [[noreturn]] void fail(const std::string& what) const
  {
    throw Unreadable(file + ": line " + std::to_string(line()) + ": " +
                     (at >= text.size() ? "the file breaks off" : what));
  }

  bool starts(const char* s) const { return text.compare(at, std::strlen(s), s) == 0; }

  static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
  static bool is_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) || std::strchr("_:-.", c); }

  void skip_spaces()
  {
    while (at < text.size() && is_space(text[at])) ++at;
  }

  void skip_to(const char* end)
  {
    const auto found = text.find(end, at);
    at = found == std::string::npos ? text.size() : found + std::strlen(end);
    if (found == std::string::npos) fail("");
  }

  /// Comments, declarations and space, in any order.
  void skip_between()
  {
    for (;;) {
      skip_spaces();
      if (starts("<!--")) skip_to("-->");
      else if (starts("<?")) skip_to("?>");
      else if (starts("<!")) skip_to(">");
      else return;
    }
  }

  std::string name()
  {
    const std::size_t from = at;
    while (at < text.size() && text[at] != 0 && is_name(text[at])) ++at;
    if (at == from) fail("a name is missing");
    return text.substr(from, at - from);
  }

  void expect(char c)
  {
    if (at >= text.size() || text[at] != c) fail(std::string("'") + c + "' is missing");
    ++at;
  }

  static std::string decoded(std::string value)
  {
    for (const auto& entity : {std::pair<const char*, const char*>{"&lt;", "<"},
                               {"&gt;", ">"},
                               {"&quot;", "\""},
                               {"&apos;", "'"},
                               {"&amp;", "&"}})
      for (std::size_t i = 0; (i = value.find(entity.first, i)) != std::string::npos; ++i)
        value.replace(i, std::strlen(entity.first), entity.second);
    return value;
  }

  void attributes(Xml_element& e)
  {
    for (;;) {
      skip_spaces();
      if (at >= text.size()) fail("");
      if (text[at] == '>' || text[at] == '/') return;
      const std::string key = name();
      skip_spaces();
      expect('=');
      skip_spaces();
      const char quote = at < text.size() ? text[at] : 0;
      if (quote != '"' && quote != '\'') fail("the value of " + key + " is not quoted");
      const std::size_t end = text.find(quote, ++at);
      if (end == std::string::npos) {
        at = text.size();
        fail("");
      }
      if (!e.attributes.emplace(key, decoded(text.substr(at, end - at))).second) fail(key + " is given twice");
      at = end + 1;
    }
  }

  Xml_element element(int depth)
  {
    if (depth > deepest) fail("is nested too deeply");
    Xml_element e;
    expect('<');
    e.line = line_here();
    e.name = name();
    attributes(e);
    if (starts("/>")) {
      at += 2;
      return e;
    }
    expect('>');
    for (;;) {
      const auto next = text.find('<', at);
      at = next == std::string::npos ? text.size() : next;
      skip_between();
      if (at >= text.size()) fail("");
      if (starts("</")) break;
      if (text[at] == '<') e.children.push_back(element(depth + 1));
    }
    at += 2;
    if (name() != e.name) fail("<" + e.name + "> is closed by another name");
    skip_spaces();
    expect('>');
    return e;
  }

  /// The line of the current place, counted on from the last time: elements come in order.
  int line_here()
  {
    counted_line += int(std::count(text.begin() + counted_to, text.begin() + at, '\n'));
    counted_to = at;
    return counted_line;
  }

  const std::string& text;
  const std::string& file;
  std::size_t at = 0, counted_to = 0;
  int counted_line = 1;
};

} // namespace

Xml_element parse_xml(const std::string& text, const std::string& file) { return Parser(text, file).document(); }

} // namespace verification
} // namespace Multiplanar
} // namespace CGAL
