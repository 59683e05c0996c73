// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "read_image.h"
#include "Row_reducer.h"

#include <png.h>
#include <stdio.h> // jpeglib.h needs FILE

#include <jpeglib.h>

#include <csetjmp>
#include <cstring>
#include <memory>
#include <string>

using CGAL::Multiplanar::Image;

namespace {

// Both libraries report errors by a jump: what needs a destructor lives outside of the functions that they jump to.

struct Png_state
{
  ~Png_state() { png_destroy_read_struct(&png, &info, nullptr); }

  std::string_view bytes;
  std::size_t position = 0;
  png_structp png = nullptr;
  png_infop info = nullptr;
  char message[128] = "";
  std::vector<std::uint8_t> rows; ///< one row, or all of an interlaced picture
  std::vector<png_bytep> row_pointers;
};

void read_png_bytes(png_structp png, png_bytep target, png_size_t length)
{
  auto& state = *static_cast<Png_state*>(png_get_io_ptr(png));
  if (length > state.bytes.size() - state.position) png_error(png, "the file is cut short");
  std::memcpy(target, state.bytes.data() + state.position, length);
  state.position += length;
}

[[noreturn]] void png_failed(png_structp png, png_const_charp message)
{
  auto& state = *static_cast<Png_state*>(png_get_error_ptr(png));
  std::strncpy(state.message, message, sizeof state.message - 1);
  longjmp(png_jmpbuf(png), 1);
}

void png_warned(png_structp, png_const_charp) {}

/// Asks for eight bits a channel, with alpha, whatever the file holds.
void ask_for_rgba(png_structp png, png_infop info)
{
  const int colour = png_get_color_type(png, info);
  if (colour == PNG_COLOR_TYPE_PALETTE) png_set_palette_to_rgb(png);
  if (colour == PNG_COLOR_TYPE_GRAY) png_set_expand_gray_1_2_4_to_8(png);
  if (png_get_valid(png, info, PNG_INFO_tRNS)) png_set_tRNS_to_alpha(png);
  if (png_get_bit_depth(png, info) == 16) png_set_scale_16(png);
  if (colour == PNG_COLOR_TYPE_GRAY || colour == PNG_COLOR_TYPE_GRAY_ALPHA) png_set_gray_to_rgb(png);
  png_set_filler(png, 255, PNG_FILLER_AFTER);
}

bool read_png_header(Png_state& state, png_uint_32& width, png_uint_32& height, bool& interlaced)
{
  if (setjmp(png_jmpbuf(state.png))) return false;
  png_read_info(state.png, state.info);
  width = png_get_image_width(state.png, state.info);
  height = png_get_image_height(state.png, state.info);
  interlaced = png_get_interlace_type(state.png, state.info) != PNG_INTERLACE_NONE;
  ask_for_rgba(state.png, state.info);
  if (interlaced) png_set_interlace_handling(state.png);
  png_read_update_info(state.png, state.info);
  if (png_get_rowbytes(state.png, state.info) != 4 * std::size_t(width))
    png_error(state.png, "unexpected kind of colour");
  return true;
}

bool read_png_row(Png_state& state)
{
  if (setjmp(png_jmpbuf(state.png))) return false;
  png_read_row(state.png, state.rows.data(), nullptr);
  return true;
}

bool read_whole_png(Png_state& state)
{
  if (setjmp(png_jmpbuf(state.png))) return false;
  png_read_image(state.png, state.row_pointers.data());
  return true;
}

Image read_png(std::string_view bytes, std::size_t most_pixels)
{
  Png_state state;
  state.bytes = bytes;
  state.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &state, png_failed, png_warned);
  if (state.png) state.info = png_create_info_struct(state.png);
  if (!state.info) throw std::bad_alloc();
  png_set_read_fn(state.png, &state, read_png_bytes);
  png_set_user_limits(state.png, 0x7fffffff, 0x7fffffff);
  const auto failed = [&] { return std::runtime_error(std::string("damaged PNG (") + state.message + ")"); };
  png_uint_32 width = 0, height = 0;
  bool interlaced = false;
  if (!read_png_header(state, width, height, interlaced)) throw failed();
  Row_reducer reducer(width, height, most_pixels);
  if (!interlaced) {
    state.rows.resize(4 * std::size_t(width));
    for (png_uint_32 y = 0; y < height; ++y) {
      if (!read_png_row(state)) throw failed();
      reducer.add(state.rows.data());
    }
    return reducer.take();
  }
  if (std::size_t(width) * height > most_pixels)
    throw std::runtime_error("an interlaced PNG of " + std::to_string(width) + " x " + std::to_string(height) +
                             " pixels: save it without interlacing, or smaller");
  state.rows.resize(4 * std::size_t(width) * height);
  for (png_uint_32 y = 0; y < height; ++y) state.row_pointers.push_back(state.rows.data() + 4 * std::size_t(width) * y);
  if (!read_whole_png(state)) throw failed();
  for (png_uint_32 y = 0; y < height; ++y) reducer.add(state.row_pointers[y]);
  return reducer.take();
}

struct Jpeg_state
{
  ~Jpeg_state() { jpeg_destroy_decompress(&info); }

  jpeg_decompress_struct info{};
  jpeg_error_mgr errors{};
  jmp_buf jump;
  char message[JMSG_LENGTH_MAX] = "";
  std::vector<std::uint8_t> line, rgba;
};

[[noreturn]] void jpeg_failed(j_common_ptr info)
{
  auto& state = *static_cast<Jpeg_state*>(info->client_data);
  info->err->format_message(info, state.message);
  longjmp(state.jump, 1);
}

void jpeg_is_silent(j_common_ptr, int) {}

bool read_jpeg_header(Jpeg_state& state, std::string_view bytes, std::size_t most_pixels)
{
  if (setjmp(state.jump)) return false;
  jpeg_create_decompress(&state.info);
  jpeg_mem_src(&state.info, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
  jpeg_read_header(&state.info, TRUE);
  const bool four = state.info.jpeg_color_space == JCS_CMYK || state.info.jpeg_color_space == JCS_YCCK;
  state.info.out_color_space = four ? JCS_CMYK : JCS_RGB;
  state.info.scale_num = 1;
  while (state.info.scale_denom < 8 && std::size_t(state.info.image_width / state.info.scale_denom) *
                                               (state.info.image_height / state.info.scale_denom) >
                                           most_pixels)
    state.info.scale_denom *= 2;
  jpeg_start_decompress(&state.info);
  return true;
}

bool read_jpeg_row(Jpeg_state& state)
{
  if (setjmp(state.jump)) return false;
  JSAMPROW row = state.line.data();
  jpeg_read_scanlines(&state.info, &row, 1);
  return true;
}

/// From red, green, blue, or from the inverted inks that programs write.
void widen(Jpeg_state& state)
{
  const std::size_t n = state.info.output_components;
  for (std::size_t x = 0; x < state.info.output_width; ++x) {
    const std::uint8_t* in = state.line.data() + n * x;
    for (int c = 0; c < 3; ++c) state.rgba[4 * x + c] = n == 4 ? std::uint8_t(in[c] * in[3] / 255) : in[c];
    state.rgba[4 * x + 3] = 255;
  }
}

Image read_jpeg(std::string_view bytes, std::size_t most_pixels)
{
  Jpeg_state state;
  state.info.err = jpeg_std_error(&state.errors);
  state.errors.error_exit = jpeg_failed;
  state.errors.emit_message = jpeg_is_silent;
  state.info.client_data = &state;
  const auto failed = [&] { return std::runtime_error(std::string("damaged JPEG (") + state.message + ")"); };
  if (!read_jpeg_header(state, bytes, most_pixels)) throw failed();
  if (state.info.output_components != 3 && state.info.output_components != 4)
    throw std::runtime_error("a JPEG with an unknown kind of colour");
  Row_reducer reducer(state.info.output_width, state.info.output_height, most_pixels);
  state.line.resize(std::size_t(state.info.output_components) * state.info.output_width);
  state.rgba.resize(4 * std::size_t(state.info.output_width));
  while (state.info.output_scanline < state.info.output_height) {
    if (!read_jpeg_row(state)) throw failed();
    widen(state);
    reducer.add(state.rgba.data());
  }
  return reducer.take();
}

} // namespace

Image read_image(std::string_view bytes, std::size_t most_pixels)
{
  CGAL_precondition(most_pixels > 0);
  if (bytes.substr(0, 8) == "\x89PNG\r\n\x1a\n") return read_png(bytes, most_pixels);
  if (bytes.substr(0, 3) == "\xff\xd8\xff") return read_jpeg(bytes, most_pixels);
  throw std::runtime_error("neither PNG nor JPEG: save it as one of them");
}
