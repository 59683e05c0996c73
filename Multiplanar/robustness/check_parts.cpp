// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "check_parts.h"

#include <set>
#include <sstream>

namespace {

bool begins_with(const std::string& line, const char* words) { return line.rfind(words, 0) == 0; }

bool says(const std::string& line, const char* words) { return line.find(words) != std::string::npos; }

/// What a line of the verifier tells; kept: nothing.
Verdict meaning_of(const std::string& line)
{
  if (begins_with(line, "unreadable: ")) return Verdict::unreadable;
  if (!begins_with(line, "violation: ")) return Verdict::kept;
  if (says(line, " overlap near ")) return Verdict::parts_overlap;
  if (says(line, " leaves the model ") || says(line, " lies outside the model ")) return Verdict::outside;
  return Verdict::other_parts;
}

} // namespace

void check_parts(const Process_result& verified, Broken_promises& broken)
{
  std::istringstream lines(verified.output);
  std::set<Verdict> known;
  for (std::string line; std::getline(lines, line);) {
    const Verdict verdict = meaning_of(line);
    if (verdict != Verdict::kept && known.insert(verdict).second) broken.emplace_back(verdict, line);
  }
  if (verified.exit_code != 0 && known.empty())
    broken.emplace_back(Verdict::other_parts, "verify ends with exit code " + std::to_string(verified.exit_code));
  if (verified.exit_code == 0 && !known.empty())
    broken.emplace_back(Verdict::other_parts, "verify ends with exit code 0, though it found violations");
}
