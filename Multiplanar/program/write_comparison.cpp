// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Comparison.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <ostream>

namespace {

template <class... Values>
std::string text(const char* format, Values... values)
{
  char buffer[256];
  std::snprintf(buffer, sizeof buffer, format, values...);
  return buffer;
}

const char* yes_or_no(bool value) { return value ? "yes" : "no"; }

std::string line_of(const Comparison_row& row)
{
  const std::string paper = row.paper ? text("%7.2f", *row.paper) : std::string();
  if (!row.measured) return text("%4d  %-11s %6s  ", row.k, row.method.c_str(), "-") + row.note;
  std::string line = text("%4d  %-11s %6d %9.2f %9.2f %8.2f %7.3f %8.1e %7s %5s %13d %8.2f", row.k, row.method.c_str(),
                          row.panels, row.hausdorff, row.to_panels, row.to_input, row.mean, row.bend,
                          yes_or_no(row.closed), yes_or_no(row.flat), row.intersections, row.seconds);
  return paper.empty() ? line : line + " " + paper;
}

/// The row of another method for the same k, if it has one that was measured.
const Comparison_row* same_k(const Comparison& comparison, int k, const std::string& method)
{
  for (const Comparison_row& row : comparison.rows)
    if (row.k == k && row.method == method && row.measured) return &row;
  return nullptr;
}

/// The width of the bounds on Hausdorff distances, in per cent: what is below counts as this much.
constexpr double measurable = 0.01;

/// Geometric mean over k of the first method's Hausdorff distance over another one's.
void write_ratio(std::ostream& out, const Comparison& comparison, const std::string& other)
{
  double logarithms = 0;
  int count = 0;
  const std::string ours = comparison.rows.front().method;
  for (const Comparison_row& row : comparison.rows) {
    const Comparison_row* theirs = row.method == ours && row.measured ? same_k(comparison, row.k, other) : nullptr;
    if (!theirs) continue;
    logarithms += std::log((std::max)(row.hausdorff, measurable) / (std::max)(theirs->hausdorff, measurable));
    ++count;
  }
  if (count > 0)
    out << text("Hausdorff distance, %s / %s, geometric mean over k: %.2f\n", ours.c_str(), other.c_str(),
                std::exp(logarithms / count));
}

void write_legend(std::ostream& out, bool paper)
{
  out << "Hausdorff: the larger of 'to panels' (from the input to the panels) and 'to input', in % of the input's\n"
         "  diagonal, upper bounds within 0.01 %; mean: mean distance, both ways; bent: largest distance of a corner\n"
         "  from the plane fitted to its panel (flat: below 1e-7 %). Seconds are elapsed ones; see --tsv for "
         "processor\n"
         "  time. CGAL's methods use one thread.\n"
         "CGAL VSA: variational shape approximation, hierarchical seeding with k proxies, 50 iterations, its own\n"
         "  triangles over its anchors. CGAL QEM: edge collapses by quadric errors down to k triangles, each a "
         "panel.\n";
  if (paper) out << "paper: Hausdorff distances of Table 1 (Chen et al. 2013), of another mesh of the same bunny.\n";
}

} // namespace

void write_table(std::ostream& out, const Comparison& comparison)
{
  const bool paper = std::any_of(comparison.rows.begin(), comparison.rows.end(),
                                 [](const Comparison_row& row) { return row.paper.has_value(); });
  out << comparison.input << ": " << comparison.faces << " faces, genus " << comparison.genus << "; "
      << comparison.settings << "\n\n";
  out << text("%4s  %-11s %6s %9s %9s %8s %7s %8s %7s %5s %13s %8s%s\n", "k", "method", "panels", "Hausdorff",
              "to panels", "to input", "mean", "bent", "closed", "flat", "intersections", "seconds",
              paper ? "   paper" : "");
  int k = comparison.rows.empty() ? 0 : comparison.rows.front().k;
  for (const Comparison_row& row : comparison.rows) {
    if (row.k != k) out << "\n";
    k = row.k;
    out << line_of(row) << "\n";
  }
  out << "\n";
  for (const Comparison_row& row : comparison.rows)
    if (row.measured && !row.note.empty()) out << row.method << ", k = " << row.k << ": " << row.note << "\n";
  for (const char* other : {"CGAL VSA", "CGAL QEM"})
    if (!comparison.rows.empty()) write_ratio(out, comparison, other);
  write_legend(out, paper);
}

void write_tsv(std::ostream& out, const Comparison& comparison)
{
  out << "input\tfaces\tgenus\tk\tmethod\tpanels\thausdorff_percent\tto_panels_percent\tto_input_percent\tmean_"
         "percent\t"
         "bent_percent\tclosed\tflat\tintersections\tseconds\tprocessor_seconds\tpaper_hausdorff_percent\tnote\n";
  for (const Comparison_row& row : comparison.rows) {
    out << comparison.input << '\t' << comparison.faces << '\t' << comparison.genus << '\t' << row.k << '\t'
        << row.method << '\t';
    if (row.measured)
      out << row.panels
          << text("\t%.6g\t%.6g\t%.6g\t%.6g\t%.6g", row.hausdorff, row.to_panels, row.to_input, row.mean, row.bend)
          << '\t' << yes_or_no(row.closed) << '\t' << yes_or_no(row.flat) << '\t' << row.intersections;
    else out << "\t\t\t\t\t\t\t\t";
    out << text("\t%.6g\t%.6g\t", row.seconds, row.processor_seconds) << (row.paper ? text("%.2f", *row.paper) : "")
        << '\t' << row.note << '\n';
  }
}
