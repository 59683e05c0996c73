// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_VERIFY_CHECKS_H
#define MULTIPLANAR_VERIFY_CHECKS_H

#include "Report.h"
#include "solids.h"
#include "written_model.h"

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace verification {

// One subject each: a section of the summary, and a line for every violation.

/// The polygons of the model: closed, flat, simple, free of intersections.
/// \return the boundary, if it bounds a solid
std::optional<Boundary> check_surface(const Written_model& model, Report& report);

/// The list of edges against the polygons: all there, with the right panels and angles.
void check_edges(const Written_model& model, Report& report);

/// Every part by itself: its frame, its outline, its area, its panel.
/// \param explained ids that report.json's warnings mention: panels that may be without a part
/// \return the solids of the parts that are sound, in the order of the parts
std::vector<Solid> check_parts(const Written_model& model, const std::set<std::string>& explained, Report& report);

void check_disjoint(const std::vector<Solid>& solids, Report& report);
void check_inside(const std::vector<Solid>& solids, const Boundary* boundary, Report& report);
void check_joints(const Written_model& model, Report& report);
void check_assembly(const Written_model& model, const std::vector<Solid>& solids, Report& report);

/// Where model.json puts the parts on the sheets.
void check_sheets(const Written_model& model, const std::vector<Solid>& solids, Report& report);
/// What the sheets' SVG and DXF files show.
void check_drawings(const Written_model& model, const std::filesystem::path& directory, Report& report);

/// The sheets' PDF files: one page each, of the size of the sheet.
void check_pdf(const Written_model& model, const std::filesystem::path& directory, Report& report);

void check_panels_obj(const Written_model& model, const std::filesystem::path& directory, Report& report);
void check_shell(const Written_model& model, const std::filesystem::path& directory, Report& report);
/// Textures, pages, pictures: those named exist, those there are whole.
void check_other_files(const Written_model& model, const std::filesystem::path& directory, Report& report);

/// Words of report.json's warnings; \throw Unreadable. Empty if there is no such file.
std::set<std::string> words_of_warnings(const std::filesystem::path& directory);

} // namespace verification
} // namespace Multiplanar
} // namespace CGAL

#endif // MULTIPLANAR_VERIFY_CHECKS_H
