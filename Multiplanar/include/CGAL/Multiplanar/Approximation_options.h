// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_APPROXIMATION_OPTIONS_H
#define CGAL_MULTIPLANAR_APPROXIMATION_OPTIONS_H

#include <CGAL/Multiplanar/Labelling_record.h>
#include <CGAL/Multiplanar/Panel_complex.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace CGAL {
namespace Multiplanar {

/// How much work an approximation may do: the paper's loop once with an exact finish; accuracy steps over a few
/// partitions; or until nothing improves.
enum class Effort { fast, normal, best };

/// Which model of `MultiplanarDeformationSolver` solves the least squares of eqs. 5-9.
enum class Solver { automatic, ceres, direct };

/// The parameters of an approximation, with the package's defaults.
struct Approximation_options
{
  int panels = 50;       ///< k: at most so many panels
  int iterations = 50;   ///< passes of the paper's loop; w_p goes from 1 to 2000 over them
  std::uint64_t seed = 0; ///< of the first planes
  int restarts = 1;      ///< seeds tried; the best result is kept
  int threads = 0;       ///< 0: all that the machine has
  Effort effort = Effort::normal;    ///< how long to look for closer panels
  Solver solver = Solver::automatic; ///< automatic: the direct one
  double smoothness = 0;          ///< weight of eq. 9
  std::vector<double> saliency;   ///< s in 0..1 per face, empty: none
  double saliency_weight = 1;     ///< W of w_t = W (1 - s)
  double min_edge = 0;  ///< edges of panels shorter than this, in input units, are removed; 0: 0.002 diagonals
  double sheet_thickness = 0; ///< in input units: edges of panels get room for joints in such sheets; 0: they need none
  double min_width = 0; ///< panels narrower than this are merged; 0: 0.002 diagonals
};

/// What came out of an approximation, in the input's units.
struct Approximation_result
{
  std::vector<Point_3> points;     ///< the moved vertices
  std::vector<int> panel_of_face;  ///< 0 .. complex.number_of_panels() - 1
  Panel_complex complex;           ///< the panels as polygons
  bool embedded = false;           ///< checked exactly on `points`
  int iterations = 0;              ///< passes done
  bool converged = false;          ///< stopped because nothing changed
  double hausdorff = 0;            ///< symmetric, in input units
  double hausdorff_to_panels = 0;  ///< from the input to the panels
  double hausdorff_to_input = 0;   ///< from the panels to the input
  double mean_distance = 0;        ///< between input and panels, the mean of both directions
  double planarity_deviation = 0;  ///< largest distance of a vertex from its panel's plane
  std::map<std::string, double> seconds; ///< by stage
  std::vector<Labelling_record> labellings; ///< what each labelling did to the energy, by restart and pass
  std::vector<std::string> notes;  ///< what a user should know: where accuracy was given up, early stops
};

/// Receives the progress of an approximation; the default does nothing. Return false from `progress` to stop.
struct Approximation_visitor
{
  virtual ~Approximation_visitor() = default;
  /// `fraction` in 0..1 of `stage` ("approximate", "finish", ...) is done.
  virtual bool progress(const std::string& stage, double fraction)
  {
    (void)stage, (void)fraction;
    return true;
  }
  /// Called after every pass of the loop with the current vertices and labels.
  virtual void pass_done(int pass, const std::vector<Point_3>& points, const std::vector<int>& labels)
  {
    (void)pass, (void)points, (void)labels;
  }
  /// Called after every labelling; with several restarts when all of them are done, in order.
  virtual void labelled(const Labelling_record& record) { (void)record; }
};

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_APPROXIMATION_OPTIONS_H
