// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_PART_H
#define CGAL_MULTIPLANAR_PART_H

#include <CGAL/Multiplanar/internal/kernel.h>

#include <array>
#include <string>
#include <vector>

namespace CGAL {
namespace Multiplanar {

using Point_2 = Kernel::Point_2; ///< in the plane of a part or a sheet, in mm

/// A closed polygon in the plane of a part or of a sheet, in mm; the last vertex is followed by the first.
using Outline = std::vector<Point_2>;

/// Where the plane of a part lies in the model: orthonormal up to rounding, u x v = normal.
struct Frame
{
  Point_3 origin = Point_3(0, 0, 0);   ///< where (0, 0) lies in the model
  Vector_3 u = Vector_3(1, 0, 0);      ///< direction of x
  Vector_3 v = Vector_3(0, 1, 0);      ///< direction of y
  Vector_3 normal = Vector_3(0, 0, 1); ///< `u` x `v`; outward for panels

  /// From the plane into the model.
  Point_3 operator()(const Point_2& p) const { return origin + p.x() * u + p.y() * v; }
  /// The coordinates of the foot of the perpendicular from `p`.
  Point_2 project(const Point_3& p) const { return Point_2((p - origin) * u, (p - origin) * v); }
};

/// A line of text on a part. `at` is the middle of the text (half its width, half the height of a capital letter),
/// `angle` the direction of its base line in degrees, `height` that of a capital letter in mm. On a part that is placed
/// mirrored, `at` is mirrored and the base line too, but the letters are not.
struct Engraving
{
  std::string text;           ///< in ASCII
  Point_2 at = Point_2(0, 0); ///< the lower left corner of its first letter
  double angle = 0;           ///< of its base line, in degrees, counter-clockwise
  double height = 0;          ///< of capital letters, in mm
};

/// The picture that belongs on the outer face of a part. An empty name: none.
struct Part_texture
{
  std::string file;               ///< in the folder of the model
  Point_2 origin = Point_2(0, 0); ///< of its lower left corner, in the plane of the part
  double mm_per_pixel = 0;        ///< side of a pixel
};

/// Twice the signed area of a polygon: positive when it runs counter-clockwise.
inline double twice_signed_area(const Outline& outline)
{
  double sum = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point_2 &a = outline[i], &b = outline[(i + 1) % outline.size()], &o = outline[0];
    sum += (a.x() - o.x()) * (b.y() - o.y()) - (a.y() - o.y()) * (b.x() - o.x());
  }
  return sum;
}

/*!
\ingroup PkgMultiplanarParts

A flat piece to be cut out of sheet material, in mm, with nominal measures: no kerf, no interference. The solid it
stands for is { origin + x u + y v - z normal : (x, y) in the outline but in no hole, 0 <= z <= thickness }.
*/
struct Part
{
  /// What a part is for.
  enum class Kind
  {
    panel,
    connector
  };

  std::string id;                       ///< unique in the model: "P07", "P07b", "C013"
  Kind kind = Kind::panel;              ///< panel or connector
  Frame frame;                          ///< where it lies in the model
  Outline outline;                      ///< counter-clockwise
  std::vector<Outline> holes;           ///< clockwise
  std::vector<std::array<int, 2>> tabs; ///< outline vertices i..j that form a tab or a tooth
  std::vector<Engraving> engraving;     ///< texts on the side that `Sheet_options::mirrored` says
  std::vector<std::string> not_engraved; ///< texts that there is no room for
  Part_texture texture;                  ///< its image, if it has one

  /// In mm^2, holes taken off.
  double area() const
  {
    double sum = twice_signed_area(outline);
    for (const Outline& hole : holes)
      sum -= twice_signed_area(hole) < 0 ? -twice_signed_area(hole) : twice_signed_area(hole);
    return sum / 2;
  }
};

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_PART_H
