// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Report.h"

#include <algorithm>
#include <cstdio>

namespace CGAL {
namespace Multiplanar {
namespace verification {
namespace {

/// Text from files made fit for a line.
std::string one_line(std::string text)
{
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 32 || c == 127) c = '?';
  return text;
}

} // namespace

void Report::violation(const std::string& line)
{
  out << "violation: " << one_line(line) << "\n";
  ++violations;
  if (!entries.empty()) ++entries.back().violations;
}

void Report::unreadable(const std::string& line)
{
  out << "unreadable: " << one_line(line) << "\n";
  ++unreadables;
  if (!entries.empty()) ++entries.back().unreadables;
}

void Report::write_summary(const std::string& title) const
{
  out << "\n" << one_line(title) << "\n";
  for (const Entry& e : entries) {
    std::string verdict = "ok";
    if (e.violations + e.unreadables > 0) verdict = "BROKEN";
    else if (e.state == State::not_claimed) verdict = "not claimed";
    else if (e.state == State::not_checked) verdict = "not checked";
    std::string text = e.text;
    if (e.violations > 0) text = counted(e.violations, "violation");
    if (e.unreadables > 0) text = counted(e.unreadables, "unreadable file") + (e.violations > 0 ? ", " + text : "");
    char line[64];
    std::snprintf(line, sizeof line, "  %-10s %-12s ", e.subject.c_str(), verdict.c_str());
    out << line << one_line(text) << "\n";
  }
  for (const std::string& line : notes) out << "  note: " << one_line(line) << "\n";
  if (exit_code() == 0) out << "Everything that is claimed holds.\n";
  else if (unreadables > 0)
    out << "Not verified: " << counted(unreadables, "file") << " cannot be read"
        << (violations > 0 ? ", " + counted(violations, "violation") : "") << ".\n";
  else out << "Do not cut this: " << counted(violations, "violation") << ".\n";
}

std::string shown(double x)
{
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.4g", x);
  return buffer;
}

namespace {

std::string decimals(double x)
{
  char buffer[512];
  std::snprintf(buffer, sizeof buffer, "%.3f", x);
  return buffer;
}

} // namespace

std::string shown(const CGAL::Exact_predicates_inexact_constructions_kernel::Point_2& p)
{
  return "(" + decimals(p.x()) + ", " + decimals(p.y()) + ")";
}

std::string shown(const CGAL::Exact_predicates_inexact_constructions_kernel::Point_3& p)
{
  return "(" + decimals(p.x()) + ", " + decimals(p.y()) + ", " + decimals(p.z()) + ")";
}

std::string counted(std::size_t n, const std::string& noun)
{
  return std::to_string(n) + " " + noun + (n == 1 ? "" : "s");
}

} // namespace verification
} // namespace Multiplanar
} // namespace CGAL
