// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Text_scanner.h"
#include "number_parsing.h"

#include <cmath>

void Text_scanner::skip_space()
{
  while (!at_line_end() &&
         (text[position] == ' ' || text[position] == '\t' || text[position] == '\f' || text[position] == '\v'))
    ++position;
  if (!at_line_end() && text[position] == '#')
    while (!at_line_end()) ++position;
}

void Text_scanner::skip_line()
{
  while (!at_line_end()) ++position;
}

std::string_view Text_scanner::rest_of_line()
{
  const auto is_space = [](char c) { return c == ' ' || c == '\t' || c == '\f' || c == '\v'; };
  while (!at_line_end() && is_space(text[position])) ++position;
  const std::size_t begin = position;
  skip_line();
  std::size_t end = position;
  while (end > begin && is_space(text[end - 1])) --end;
  return text.substr(begin, end - begin);
}

bool Text_scanner::next_line()
{
  if (begun) skip_line();
  begun = true;
  for (;;) {
    skip_space();
    if (!at_line_end()) return true;
    if (position == text.size()) return false;
    if (text[position] == '\r' && position + 1 < text.size() && text[position + 1] == '\n') ++position;
    ++position;
    ++line_number;
  }
}

std::string_view Text_scanner::word()
{
  skip_space();
  const std::size_t begin = position;
  while (!at_line_end() && text[position] != ' ' && text[position] != '\t' && text[position] != '\f' &&
         text[position] != '\v' && text[position] != '#')
    ++position;
  return text.substr(begin, position - begin);
}

std::string_view Text_scanner::word_across_lines(const char* what)
{
  std::string_view result = word();
  if (result.empty()) {
    if (!next_line()) throw error(std::string("the file ends where ") + what + " should follow");
    result = word();
  }
  return result;
}

double Text_scanner::coordinate(std::string_view word) const
{
  double value = 0;
  if (!parse_number(word, value)) throw error(quoted(std::string(word)) + " is not a number");
  if (!std::isfinite(value)) throw error("the coordinate " + quoted(std::string(word)) + " is not finite");
  return value;
}

long long Text_scanner::integer(std::string_view word, const char* what) const
{
  long long value = 0;
  if (!parse_integer(word, value)) throw error(quoted(std::string(word)) + " is not " + what);
  return value;
}

std::array<double, 3> Text_scanner::point()
{
  std::array<double, 3> p;
  for (double& x : p) {
    const std::string_view w = word();
    if (w.empty()) throw error("a vertex needs three coordinates");
    x = coordinate(w);
  }
  return p;
}

Failure Text_scanner::error(const std::string& what) const
{
  return input_error(name + ":" + std::to_string(line_number) + ": " + what);
}
