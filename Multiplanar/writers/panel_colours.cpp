// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "panel_colours.h"

#include <algorithm>
#include <cmath>

using namespace CGAL::Multiplanar;

namespace {

/// Oklab (Ottosson 2020) to linear sRGB; lightness, chroma, and hue in turns.
Linear_colour oklch(double lightness, double chroma, double hue)
{
  const double angle = 2 * 3.14159265358979323846 * hue, a = chroma * std::cos(angle), b = chroma * std::sin(angle);
  const double l = std::pow(lightness + 0.3963377774 * a + 0.2158037573 * b, 3);
  const double m = std::pow(lightness - 0.1055613458 * a - 0.0638541728 * b, 3);
  const double s = std::pow(lightness - 0.0894841775 * a - 1.2914855480 * b, 3);
  const double rgb[3] = {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
                         -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
                         -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
  Linear_colour result;
  for (int c = 0; c < 3; ++c) result[c] = float(std::min(1., std::max(0., rgb[c])));
  return result;
}

constexpr int hues = 16;

double distance_of_hues(int a, int b)
{
  const int d = std::abs(a - b);
  return std::min(d, hues - d);
}

} // namespace

std::vector<Linear_colour> panel_colours(const Panel_complex& complex)
{
  std::vector<int> hue(complex.number_of_panels(), -1), used(hues, 0);
  for (int p = 0; p < complex.number_of_panels(); ++p) {
    int best = 0;
    double best_score = -1e300;
    for (int i = 0; i < hues; ++i) {
      const int h = (7 * i + 3 * p) % hues; // ties fall differently from panel to panel
      double nearest = hues;
      for (int q : complex.neighbours(p))
        if (hue[q] >= 0) nearest = std::min(nearest, distance_of_hues(h, hue[q]));
      const double score = std::min(nearest, 4.) - 0.6 * used[h];
      if (score > best_score) best_score = score, best = h;
    }
    hue[p] = best;
    ++used[best];
  }
  std::vector<Linear_colour> colours;
  for (int p = 0; p < complex.number_of_panels(); ++p)
    colours.push_back(oklch(p % 2 ? 0.80 : 0.75, 0.105, (hue[p] + 0.5) / hues));
  return colours;
}
