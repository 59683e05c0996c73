// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks.h"
#include "text_file.h"

#include <cmath>

namespace CGAL {
namespace Multiplanar {
namespace verification {
namespace {

std::size_t occurrences(const std::string& text, const std::string& word)
{
  std::size_t n = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + word.size())) ++n;
  return n;
}

/// Four numbers in points; without them the page has no size of its own.
std::vector<double> media_box(const std::string& pdf)
{
  const std::size_t begin = pdf.find("/MediaBox"), open = pdf.find('[', begin), close = pdf.find(']', begin);
  if (begin == std::string::npos || open == std::string::npos || close == std::string::npos) return {};
  return parse_numbers(pdf.substr(open + 1, close - open - 1));
}

void check_page(const Written_sheet& sheet, const std::filesystem::path& directory, const std::filesystem::path& file,
                Report& report)
{
  const std::string name = file.generic_string(), pdf = read_text(directory / file);
  const std::size_t pages = occurrences(pdf, "/Type /Page\n") + occurrences(pdf, "/Type /Page ");
  if (pages != 1) report.violation(name + ": has " + counted(pages, "page") + " instead of one");
  const std::vector<double> box = media_box(pdf);
  if (box.size() != 4) return report.violation(name + ": its page has no size");
  const double mm = 25.4 / 72, width = (box[2] - box[0]) * mm, height = (box[3] - box[1]) * mm;
  if (std::abs(width - sheet.width) > 0.01 || std::abs(height - sheet.height) > 0.01)
    report.violation(name + ": its page is " + shown(width) + " x " + shown(height) + " mm, the sheet is not");
}

} // namespace

void check_pdf(const Written_model& model, const std::filesystem::path& directory, Report& report)
{
  report.begin("pdf");
  std::size_t pages = 0;
  for (const Written_sheet& sheet : model.sheets) {
    const auto file = std::filesystem::path(sheet.file).replace_extension(".pdf");
    if (!std::filesystem::exists(directory / file)) continue;
    ++pages;
    try {
      check_page(sheet, directory, file, report);
    } catch (const Unreadable& e) {
      report.unreadable((file.parent_path() / e.what()).generic_string());
    }
  }
  if (pages == 0) return report.not_claimed("there is no PDF of a sheet");
  if (pages < model.sheets.size()) report.violation("some sheets have a PDF file beside them, others have none");
  report.checked(counted(pages, "page") + " of the size of the sheet");
}

} // namespace verification
} // namespace Multiplanar
} // namespace CGAL
