// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "write_png.h"

#include <png.h>

#include <cmath>
#include <ostream>
#include <stdexcept>
#include <string>

namespace {

void pass_on(png_structp png, png_bytep data, png_size_t length)
{
  static_cast<std::ostream*>(png_get_io_ptr(png))->write(reinterpret_cast<const char*>(data), std::streamsize(length));
}

void flush_nothing(png_structp) {}

/// libpng comes back here by longjmp: no C++ object with a destructor may live in the functions in between.
[[noreturn]] void jump(png_structp png, png_const_charp) { longjmp(png_jmpbuf(png), 1); }
void ignore(png_structp, png_const_charp) {}

bool is_opaque(const CGAL::Multiplanar::Image& image)
{
  for (std::size_t i = 3; i < image.rgba.size(); i += 4)
    if (image.rgba[i] != 255) return false;
  return true;
}

/// \return did it succeed?
bool write_all(png_structp png, png_infop info, const CGAL::Multiplanar::Image& image, bool opaque, unsigned per_metre)
{
  if (setjmp(png_jmpbuf(png))) return false;
  png_set_compression_level(png, 4);
  png_set_IHDR(png, info, png_uint_32(image.width), png_uint_32(image.height), 8,
               opaque ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGB_ALPHA, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  if (per_metre > 0) png_set_pHYs(png, info, per_metre, per_metre, PNG_RESOLUTION_METER);
  png_write_info(png, info);
  if (opaque) png_set_filler(png, 0, PNG_FILLER_AFTER);
  for (int y = 0; y < image.height; ++y) png_write_row(png, image.pixel(0, y));
  png_write_end(png, info);
  return true;
}

} // namespace

void write_png(std::ostream& out, const CGAL::Multiplanar::Image& image, double pixels_per_mm)
{
  CGAL_precondition(!image.empty());
  const bool opaque = is_opaque(image);
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, jump, ignore);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  if (info) {
    png_set_user_limits(png, 0x7fffffff, 0x7fffffff);
    png_set_write_fn(png, &out, pass_on, flush_nothing);
  }
  const bool written = info && write_all(png, info, image, opaque, unsigned(std::lround(1000 * pixels_per_mm)));
  png_destroy_write_struct(&png, &info);
  if (!written && out) throw std::runtime_error("a PNG could not be written");
}
