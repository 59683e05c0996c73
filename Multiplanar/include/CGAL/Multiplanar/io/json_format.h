// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_IO_JSON_FORMAT_H
#define CGAL_MULTIPLANAR_IO_JSON_FORMAT_H

#include <CGAL/Multiplanar/internal/kernel.h>

#include <nlohmann/json.hpp>

#include <ostream>
#include <string>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// Keeps keys in the order in which they were added.
using Json = nlohmann::ordered_json;

inline Json to_json(const Kernel::Point_2& p) { return Json::array({p.x(), p.y()}); }
inline Json to_json(const Point_3& p) { return Json::array({p.x(), p.y(), p.z()}); }
inline Json to_json(const Vector_3& v) { return Json::array({v.x(), v.y(), v.z()}); }

/// One line; bytes that are not UTF-8 (in file names, say) are replaced.
inline std::string one_line(const Json& value) { return value.dump(-1, ' ', false, Json::error_handler_t::replace); }

/// Writes an object with a key a line, and lists below it with an element a line: readable, and short enough to
/// compare.
inline void write_json(std::ostream& out, const Json& object)
{
  const char* comma = "\n";
  out << "{";
  for (const auto& item : object.items()) {
    out << comma << "  " << one_line(Json(item.key())) << ": ";
    comma = ",\n";
    if (!item.value().is_array() || item.value().empty()) {
      out << one_line(item.value());
      continue;
    }
    const char* inner_comma = "\n";
    out << "[";
    for (const auto& element : item.value()) {
      out << inner_comma << "    " << one_line(element);
      inner_comma = ",\n";
    }
    out << "\n  ]";
  }
  out << "\n}\n";
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_IO_JSON_FORMAT_H
