// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_VERIFY_REPORT_H
#define MULTIPLANAR_VERIFY_REPORT_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace verification {

/// What the verifier has to say: violations as they are found, a line each, and a summary by subject.
class Report
{
public:
  explicit Report(std::ostream& out) : out(out) {}

  /// Opens a subject; violations count for it until the next.
  void begin(const std::string& subject) { entries.push_back({subject, "", 0, 0, State::checked}); }
  void violation(const std::string& line);
  void unreadable(const std::string& line);
  /// Says in the summary what was checked.
  void checked(const std::string& what) { entries.back().text = what; }
  /// Says in the summary that the files make no such claim.
  void not_claimed(const std::string& why) { entries.back().text = why, entries.back().state = State::not_claimed; }
  /// Says in the summary that something else must be mended first.
  void not_checked(const std::string& why) { entries.back().text = why, entries.back().state = State::not_checked; }
  /// Something to know that breaks no promise.
  void note(const std::string& line) { notes.push_back(line); }

  bool has_violations() const { return violations > 0; }
  int violations_of_subject() const { return entries.back().violations; }
  int exit_code() const { return unreadables > 0 ? 3 : violations > 0 ? 1 : 0; }
  void write_summary(const std::string& title) const;

private:
  enum class State
  {
    checked,
    not_claimed,
    not_checked
  };
  struct Entry
  {
    std::string subject, text;
    int violations, unreadables;
    State state;
  };

  std::ostream& out;
  std::vector<Entry> entries;
  std::vector<std::string> notes;
  int violations = 0, unreadables = 0;
};

/// A number with few digits, for people.
std::string shown(double x);
std::string shown(const CGAL::Exact_predicates_inexact_constructions_kernel::Point_2& p);
std::string shown(const CGAL::Exact_predicates_inexact_constructions_kernel::Point_3& p);
/// "1 part", "3 parts".
std::string counted(std::size_t n, const std::string& noun);

} // namespace verification
} // namespace Multiplanar
} // namespace CGAL

#endif // MULTIPLANAR_VERIFY_REPORT_H
