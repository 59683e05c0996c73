// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_ROBUSTNESS_VERDICT_H
#define MULTIPLANAR_ROBUSTNESS_VERDICT_H

#include <string>
#include <utility>
#include <vector>

/// What became of a mesh; each value is an exit code of `multiplanar_robustness`.
enum class Verdict
{
  kept = 0,           ///< all promises hold, or the mesh was refused with the right message
  usage = 1,          ///< the command line of the suite itself
  connectivity = 10,  ///< the shell has other vertices or triangles than the input, or a panel in pieces
  closed = 11,        ///< the shell is no closed, connected 2-manifold
  embedded = 12,      ///< it intersects itself or has degenerate faces
  flat = 13,          ///< a panel is bent by more than 1e-9 of the diagonal
  k_exceeded = 14,    ///< more panels than were asked for
  parts_overlap = 15, ///< two parts need the same room, or the same place on a sheet
  outside = 16,       ///< a part leaves the model
  other_parts = 17,   ///< another violation that `multiplanar verify` found
  unreadable = 18,    ///< what was written cannot be read
  refusal = 19,       ///< refused with the wrong message or exit code, or taken though it must be refused
  left_behind = 20,   ///< a refused run left something behind
  time_limit = 21,    ///< more processor time than allowed, or it hangs
  memory_limit = 22,  ///< more memory than allowed
  crash = 23,         ///< ended by a signal, or an internal error
  not_found = 24,     ///< taken, but no flat panels were found: exit code 3 and one line that says so
};

inline const char* name_of(Verdict verdict)
{
  switch (verdict) {
  case Verdict::kept:
    return "kept";
  case Verdict::usage:
    return "usage";
  case Verdict::connectivity:
    return "connectivity";
  case Verdict::closed:
    return "not closed";
  case Verdict::embedded:
    return "not embedded";
  case Verdict::flat:
    return "not flat";
  case Verdict::k_exceeded:
    return "k exceeded";
  case Verdict::parts_overlap:
    return "parts overlap";
  case Verdict::outside:
    return "outside";
  case Verdict::other_parts:
    return "parts";
  case Verdict::unreadable:
    return "unreadable output";
  case Verdict::refusal:
    return "wrong refusal";
  case Verdict::left_behind:
    return "left behind";
  case Verdict::time_limit:
    return "time limit";
  case Verdict::memory_limit:
    return "memory limit";
  case Verdict::crash:
    return "crash";
  case Verdict::not_found:
    return "not found";
  }
  return "";
}

/// Promises that were found broken, each with what was seen.
using Broken_promises = std::vector<std::pair<Verdict, std::string>>;

#endif // MULTIPLANAR_ROBUSTNESS_VERDICT_H
