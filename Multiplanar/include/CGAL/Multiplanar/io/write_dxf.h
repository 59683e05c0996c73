// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_IO_WRITE_DXF_H
#define CGAL_MULTIPLANAR_IO_WRITE_DXF_H

#include <CGAL/Multiplanar/Sheet_drawing.h>
#include <CGAL/Multiplanar/io/number_format.h>

#include <array>
#include <cstdio>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// Writes DXF R2000 (AC1015): pairs of a group code and a value, a line each. Every object has a handle and names its
/// owner; the tables, blocks and dictionaries that AutoCAD asks for are there even where they are empty.
class Dxf_writer
{
public:
  explicit Dxf_writer(std::ostream& out) : out(out) {}

  void write(const Sheet_drawing& sheet)
  {
    // Entities are written to memory first: the header names the next free handle.
    std::ostringstream entities;
    Dxf_writer inner(entities);
    inner.next_handle = first_free_handle;
    inner.write_entities(sheet);
    header(sheet, inner.next_handle);
    section("CLASSES", [] {});
    section("TABLES", [&] { tables(sheet); });
    section("BLOCKS", [&] { blocks(); });
    out << entities.str();
    section("OBJECTS", [&] { objects(); });
    pair(0, "EOF");
  }

private:
  // Handles, in hexadecimal.
  static constexpr const char *vport_table = "1", *ltype_table = "2", *layer_table = "3", *style_table = "4",
                              *view_table = "5", *ucs_table = "6", *appid_table = "7", *dimstyle_table = "8",
                              *block_table = "9", *model_space = "A", *paper_space = "B", *root = "C", *groups = "D";
  static constexpr int first_free_handle = 0x100;

  template <class Value>
  void pair(int code, const Value& value)
  {
    out << code << "\n" << value << "\n";
  }
  void length(int code, double mm) { pair(code, drawing_number(mm)); }

  template <class Body>
  void section(const char* name, Body body)
  {
    pair(0, "SECTION");
    pair(2, name);
    body();
    pair(0, "ENDSEC");
  }

  void header(const Sheet_drawing& sheet, int seed)
  {
    section("HEADER", [&] {
      pair(9, "$ACADVER"), pair(1, "AC1015");
      pair(9, "$DWGCODEPAGE"), pair(3, "ANSI_1252");
      pair(9, "$INSUNITS"), pair(70, 4); // mm
      pair(9, "$MEASUREMENT"), pair(70, 1);
      pair(9, "$EXTMIN"), length(10, 0), length(20, 0), length(30, 0);
      pair(9, "$EXTMAX"), length(10, sheet.width), length(20, sheet.height), length(30, 0);
      pair(9, "$LIMMIN"), length(10, 0), length(20, 0);
      pair(9, "$LIMMAX"), length(10, sheet.width), length(20, sheet.height);
      pair(9, "$HANDSEED"), pair(5, hexadecimal(seed));
    });
  }

  static std::string hexadecimal(int x)
  {
    char text[16];
    std::snprintf(text, sizeof text, "%X", unsigned(x));
    return text;
  }

  template <class Body>
  void table(const char* name, const char* handle, int entries, Body body)
  {
    pair(0, "TABLE");
    pair(2, name);
    pair(5, handle);
    pair(330, 0);
    pair(100, "AcDbSymbolTable");
    pair(70, entries);
    body();
    pair(0, "ENDTAB");
  }

  void record(const char* type, const char* handle, const char* owner, const char* subclass, const char* name,
              int handle_code = 5)
  {
    pair(0, type);
    pair(handle_code, handle);
    pair(330, owner);
    pair(100, "AcDbSymbolTableRecord");
    pair(100, subclass);
    pair(2, name);
  }

  void tables(const Sheet_drawing& sheet)
  {
    table("VPORT", vport_table, 1, [&] { viewport(sheet); });
    table("LTYPE", ltype_table, 3, [&] {
      line_type("20", "ByBlock", "");
      line_type("21", "ByLayer", "");
      line_type("22", "Continuous", "Solid line");
    });
    table("LAYER", layer_table, 4, [&] {
      layer("30", "0", 7);
      layer("31", "ENGRAVE", 7);   // black or white
      layer("32", "CUT_INNER", 5); // blue
      layer("33", "CUT_OUTER", 1); // red
    });
    table("STYLE", style_table, 1, [&] {
      record("STYLE", "40", style_table, "AcDbTextStyleTableRecord", "Standard");
      pair(70, 0), pair(40, 0), pair(41, 1), pair(50, 0), pair(71, 0), pair(42, "2.5"), pair(3, "txt"), pair(4, "");
    });
    table("VIEW", view_table, 0, [] {});
    table("UCS", ucs_table, 0, [] {});
    table("APPID", appid_table, 1, [&] {
      record("APPID", "50", appid_table, "AcDbRegAppTableRecord", "ACAD");
      pair(70, 0);
    });
    table("DIMSTYLE", dimstyle_table, 1, [&] {
      pair(100, "AcDbDimStyleTable");
      record("DIMSTYLE", "60", dimstyle_table, "AcDbDimStyleTableRecord", "Standard", 105);
      pair(70, 0);
    });
    table("BLOCK_RECORD", block_table, 2, [&] {
      record("BLOCK_RECORD", model_space, block_table, "AcDbBlockTableRecord", "*Model_Space");
      record("BLOCK_RECORD", paper_space, block_table, "AcDbBlockTableRecord", "*Paper_Space");
    });
  }

  void viewport(const Sheet_drawing& sheet)
  {
    record("VPORT", "10", vport_table, "AcDbViewportTableRecord", "*Active");
    pair(70, 0);
    for (const auto& p : std::vector<std::array<double, 3>>{{{10, 0, 0}},
                                                            {{11, 1, 1}},
                                                            {{12, sheet.width / 2, sheet.height / 2}},
                                                            {{13, 0, 0}},
                                                            {{14, 10, 10}},
                                                            {{15, 10, 10}}})
      length(int(p[0]), p[1]), length(int(p[0]) + 10, p[2]);
    pair(16, 0), pair(26, 0), pair(36, 1);
    pair(17, 0), pair(27, 0), pair(37, 0);
    length(40, sheet.height), length(41, sheet.width / sheet.height), pair(42, 50);
  }

  void line_type(const char* handle, const char* name, const char* description)
  {
    record("LTYPE", handle, ltype_table, "AcDbLinetypeTableRecord", name);
    pair(70, 0), pair(3, description), pair(72, 65), pair(73, 0), pair(40, 0);
  }

  void layer(const char* handle, const char* name, int colour)
  {
    record("LAYER", handle, layer_table, "AcDbLayerTableRecord", name);
    pair(70, 0), pair(62, colour), pair(6, "Continuous"), pair(370, -3), pair(390, "F");
  }

  void blocks()
  {
    block(model_space, "*Model_Space", "70", "71", false);
    block(paper_space, "*Paper_Space", "72", "73", true);
  }

  void block(const char* owner, const char* name, const char* begin, const char* end, bool paper)
  {
    for (const bool is_end : {false, true}) {
      pair(0, is_end ? "ENDBLK" : "BLOCK");
      pair(5, is_end ? end : begin);
      pair(330, owner);
      pair(100, "AcDbEntity");
      if (paper) pair(67, 1);
      pair(8, "0");
      pair(100, is_end ? "AcDbBlockEnd" : "AcDbBlockBegin");
      if (is_end) continue;
      pair(2, name), pair(70, 0), length(10, 0), length(20, 0), length(30, 0), pair(3, name), pair(1, "");
    }
  }

  /// Engraving, then inner cuts, then outer cuts, as they are to be done.
  void write_entities(const Sheet_drawing& sheet)
  {
    section("ENTITIES", [&] {
      for (const Part_drawing& part : sheet.parts)
        for (const Stroke& stroke : part.engraving) polyline(stroke, "ENGRAVE", false);
      for (const Part_drawing& part : sheet.parts)
        for (const Outline& path : part.inner) polyline(path, "CUT_INNER", true);
      for (const Part_drawing& part : sheet.parts)
        for (const Outline& path : part.outer) polyline(path, "CUT_OUTER", true);
    });
  }

  void polyline(const std::vector<Point_2>& points, const char* layer, bool closed)
  {
    pair(0, "LWPOLYLINE");
    pair(5, hexadecimal(next_handle++));
    pair(330, model_space);
    pair(100, "AcDbEntity");
    pair(8, layer);
    pair(100, "AcDbPolyline");
    pair(90, points.size());
    pair(70, closed ? 1 : 0);
    for (const Point_2& p : points) length(10, p.x()), length(20, p.y());
  }

  void objects()
  {
    dictionary(root, "0", {{"ACAD_GROUP", groups}, {"ACAD_PLOTSTYLENAME", "E"}});
    dictionary(groups, root, {});
    pair(0, "ACDBDICTIONARYWDFLT"), pair(5, "E"), pair(330, root), pair(100, "AcDbDictionary"), pair(281, 1);
    pair(3, "Normal"), pair(350, "F"), pair(100, "AcDbDictionaryWithDefault"), pair(340, "F");
    pair(0, "ACDBPLACEHOLDER"), pair(5, "F"), pair(330, "E");
  }

  void dictionary(const char* handle, const char* owner, const std::vector<std::array<const char*, 2>>& entries)
  {
    pair(0, "DICTIONARY");
    pair(5, handle);
    pair(330, owner);
    pair(100, "AcDbDictionary");
    pair(281, 1);
    for (const auto& entry : entries) pair(3, entry[0]), pair(350, entry[1]);
  }

  std::ostream& out;
  int next_handle = first_free_handle;
};

} // namespace internal

/*!
\ingroup PkgMultiplanarIO

Writes a sheet as DXF R2000 in mm: LWPOLYLINEs, closed where they are cuts, on the layers ENGRAVE, CUT_INNER and
CUT_OUTER, in this order; `$INSUNITS` is 4. y points upward. The caller checks the state of `out` afterwards.
*/
inline void write_dxf(std::ostream& out, const Sheet_drawing& sheet) { internal::Dxf_writer(out).write(sheet); }

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_IO_WRITE_DXF_H
