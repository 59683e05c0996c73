// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "proof.h"
#include "failure.h"

#include "verify/verify.h"

#include <sstream>

void require_proof(const std::string& folder, const std::string& shown)
{
  std::stringstream report;
  if (CGAL::Multiplanar::verify(folder, report) == exit_done) return;
  std::string first;
  int faults = 0;
  for (std::string line; std::getline(report, line);)
    if ((line.rfind("violation: ", 0) == 0 || line.rfind("unreadable: ", 0) == 0) && faults++ == 0)
      first = line.substr(line.find(' ') + 1);
  throw Failure(exit_broken_promise, shown + ": the parts break what is promised (" + std::to_string(faults) +
                                         (faults == 1 ? " fault: " : " faults, the first: ") + first +
                                         "): nothing was written; try another --seed, -k or --size, and report this");
}
