// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_VERIFY_XML_H
#define MULTIPLANAR_VERIFY_XML_H

#include <map>
#include <string>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace verification {

/// An element of an XML file; text between elements is left out.
struct Xml_element
{
  std::string name;
  std::map<std::string, std::string> attributes;
  std::vector<Xml_element> children;
  int line = 0;

  /// The value of an attribute, or an empty text.
  std::string operator[](const std::string& attribute) const
  {
    const auto found = attributes.find(attribute);
    return found == attributes.end() ? "" : found->second;
  }
};

/// Reads well-formed XML (no DTD with a body): the root element. \throw Unreadable, with the line, if it is not
Xml_element parse_xml(const std::string& text, const std::string& file);

} // namespace verification
} // namespace Multiplanar
} // namespace CGAL

#endif // MULTIPLANAR_VERIFY_XML_H
