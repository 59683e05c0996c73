// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_FIT_TEST_H
#define CGAL_MULTIPLANAR_FIT_TEST_H

#include <CGAL/Multiplanar/Sheet_drawing.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace CGAL {
namespace Multiplanar {

/*!
\ingroup PkgMultiplanarSheets

Three pieces to cut before a model, to find what its sheets depend on. They are compensated for `kerf` as sheets are.

 - A bar of 100 mm by 12 mm. If it measures 100 + d mm, the kerf to give is smaller by d, for it was cut on both ends
   at half of it.
 - A key with a tab at each end, as long as the material is thick and 2.5 thicknesses wide: those of connectors.
 - A plate, a comb of slots. The lower row is as wide as the material is said to be thick and shorter than the tabs by
   what stands below: the tightest slot that the key can be pressed into tells the fit. The upper row differs in
   width by what stands above: the slot that the material itself goes into without play tells the thickness.
*/
class Fit_test
{
public:
  static constexpr int count = 7; ///< slots in a row

  /// \param thickness, kerf, fit in mm, of the material as it is said to be
  Fit_test(double thickness, double kerf, double fit)
      : t(thickness), kerf(kerf), tab(2.5 * thickness), pitch((std::max)(tab + 2 * thickness, 12.0))
  {
    for (int i = 0; i < count; ++i) {
      fits[i] = (std::max)(0., fit - 0.1) + 0.05 * i;
      widths[i] = thickness + (i - 3) * thickness / 30;
    }
  }

  /// What stands below the slots of the lower row: by how many mm they are shorter than the tabs.
  const std::array<double, count>& slot_fits() const { return fits; }
  /// What stands above the slots of the upper row: their widths in mm.
  const std::array<double, count>& slot_widths() const { return widths; }

  /// The pieces in their places on a sheet no larger than needed.
  Sheet_drawing drawing() const
  {
    std::vector<Part> parts = {bar(), key(), plate()};
    Sheet sheet;
    double y = 5;
    for (int i = 0; i < 3; ++i) {
      Placement placement;
      placement.part = i;
      placement.x = 5, placement.y = y;
      sheet.placements.push_back(placement);
      double high = 0;
      for (const Point_2& p : parts[i].outline) {
        high = (std::max)(high, p.y());
        sheet.width = (std::max)(sheet.width, p.x() + 10);
      }
      y += high + 4;
    }
    sheet.height = y + 1;
    return draw_sheet(sheet, parts, kerf);
  }

private:
  static std::string number(double x)
  {
    char text[32];
    std::snprintf(text, sizeof text, "%.2f", x);
    return text;
  }

  double length() const { return count * pitch + 6; }
  double middle(int i) const { return 3 + (i + 0.5) * pitch; }

  Part bar() const
  {
    Part part;
    part.id = "bar";
    part.outline = {Point_2(0, 0), Point_2(100, 0), Point_2(100, 12), Point_2(0, 12)};
    part.engraving.push_back({"100 mm - KERF " + number(kerf), Point_2(50, 6), 0, 4});
    return part;
  }

  Part key() const
  {
    Part part;
    part.id = "key";
    const double width = tab + 2 * t + 8, low = t, high = t + 16, left = (width - tab) / 2, right = left + tab;
    part.outline = {Point_2(0, low),          Point_2(left, low),      Point_2(left, 0),     Point_2(right, 0),
                    Point_2(right, low),      Point_2(width, low),     Point_2(width, high), Point_2(right, high),
                    Point_2(right, high + t), Point_2(left, high + t), Point_2(left, high),  Point_2(0, high)};
    part.engraving.push_back({"KEY", Point_2(width / 2, low + 8), 0, 4});
    return part;
  }

  Part plate() const
  {
    Part part;
    part.id = "plate";
    const double lower = 16, upper = lower + t + 14, high = upper + 1.2 * t + 20;
    part.outline = {Point_2(0, 0), Point_2(length(), 0), Point_2(length(), high), Point_2(0, high)};
    for (int i = 0; i < count; ++i) {
      slot(middle(i), lower, tab - fits[i], t, part);
      slot(middle(i), upper, tab, widths[i], part);
      part.engraving.push_back({number(fits[i]), Point_2(middle(i), lower - 4), 0, 2.5});
      part.engraving.push_back({number(widths[i]), Point_2(middle(i), upper + widths[i] + 4), 0, 2.5});
    }
    part.engraving.push_back({"FIT: SLOTS FOR THE KEY", Point_2(length() / 2, 5), 0, 3});
    part.engraving.push_back({"THICKNESS: SLOTS FOR THE SHEET", Point_2(length() / 2, high - 5), 0, 3});
    return part;
  }

  static void slot(double x, double y, double length, double width, Part& part)
  {
    const double a = x - length / 2, b = x + length / 2;
    part.holes.push_back({Point_2(a, y), Point_2(a, y + width), Point_2(b, y + width), Point_2(b, y)});
  }

  double t, kerf, tab, pitch;
  std::array<double, count> fits, widths;
};

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_FIT_TEST_H
