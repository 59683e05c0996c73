// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_PROGRAM_TEXT_SCANNER_H
#define MULTIPLANAR_PROGRAM_TEXT_SCANNER_H

#include "failure.h"

#include <array>
#include <string>
#include <string_view>

/// Reads words and numbers from a text, and knows the line for error messages. A '#' begins a comment.
class Text_scanner
{
public:
  /// \param name of the file, for messages
  Text_scanner(std::string_view text, std::string name) : text(text), name(std::move(name)) {}

  /// Goes to the next line that has a word; false at the end of the text.
  bool next_line();
  /// The next word of the current line, empty at its end.
  std::string_view word();
  /// The next word of the text; what is missing at its end is named by `what`.
  std::string_view word_across_lines(const char* what);
  void skip_line();
  /// All that is left of the line, without space around it; '#' counts as any other character.
  std::string_view rest_of_line();

  /// The number that a word says. \throws Failure if it is none, or not finite
  double coordinate(std::string_view word) const;
  long long integer(std::string_view word, const char* what) const;
  /// Three coordinates from the current line.
  std::array<double, 3> point();

  int line() const { return line_number; }
  std::size_t offset() const { return position; }
  std::size_t remaining() const { return text.size() - position; }
  Failure error(const std::string& what) const;

private:
  void skip_space();
  bool at_line_end() const { return position == text.size() || text[position] == '\n' || text[position] == '\r'; }

  std::string_view text;
  std::string name;
  std::size_t position = 0;
  int line_number = 1;
  bool begun = false; ///< stands in a line; before the first call of next_line() it stands in front of all
};

#endif // MULTIPLANAR_PROGRAM_TEXT_SCANNER_H
