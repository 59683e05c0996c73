// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks.h"
#include "text_file.h"
#include "xml.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace CGAL {
namespace Multiplanar {
namespace verification {
namespace {

std::uint32_t big_endian(const std::string& s, std::size_t at)
{
  std::uint32_t x = 0;
  for (int i = 0; i < 4; ++i) x = x << 8 | static_cast<unsigned char>(s[at + i]);
  return x;
}

/// The check sum of PNG chunks.
std::uint32_t crc(const std::string& s, std::size_t from, std::size_t to)
{
  static const std::vector<std::uint32_t> table = [] {
    std::vector<std::uint32_t> t(256);
    for (std::uint32_t i = 0; i < 256; ++i) {
      t[i] = i;
      for (int k = 0; k < 8; ++k) t[i] = t[i] & 1 ? 0xedb88320u ^ t[i] >> 1 : t[i] >> 1;
    }
    return t;
  }();
  std::uint32_t c = 0xffffffffu;
  for (; from < to; ++from) c = table[(c ^ static_cast<unsigned char>(s[from])) & 255] ^ c >> 8;
  return ~c;
}

std::string problem_of_png(const std::string& s)
{
  if (s.compare(0, 8, "\x89PNG\r\n\x1a\n") != 0) return "is no PNG";
  for (std::size_t at = 8; at + 12 <= s.size();) {
    const std::size_t length = big_endian(s, at);
    if (length > s.size() - at - 12) break;
    if (crc(s, at + 4, at + 8 + length) != big_endian(s, at + 8 + length)) return "has a damaged chunk";
    if (s.compare(at + 4, 4, "IEND") == 0) return "";
    at += 12 + length;
  }
  return "breaks off";
}

std::string problem_of_pdf(const std::string& s)
{
  if (s.compare(0, 5, "%PDF-") != 0) return "is no PDF";
  return s.find("%%EOF", s.size() < 1024 ? 0 : s.size() - 1024) == std::string::npos ? "breaks off" : "";
}

std::string problem_of_glb(const std::string& s)
{
  if (s.size() < 20 || s.compare(0, 4, "glTF") != 0) return "is no GLB";
  std::uint32_t length = 0;
  for (int i = 3; i >= 0; --i) length = length << 8 | static_cast<unsigned char>(s[8 + i]);
  return length == s.size() ? "" : "breaks off";
}

std::string problem_of_html(const std::string& s) { return s.find("</html>") == std::string::npos ? "breaks off" : ""; }

std::string problem_of_json(const std::string& s) { return nlohmann::json::accept(s) ? "" : "is no JSON"; }

std::string problem_of_file(const std::filesystem::path& file)
{
  const std::string extension = file.extension().string();
  if (extension == ".svg") return parse_xml(read_text(file), file.filename().string()), "";
  const auto check = extension == ".png"    ? problem_of_png
                     : extension == ".pdf"  ? problem_of_pdf
                     : extension == ".glb"  ? problem_of_glb
                     : extension == ".html" ? problem_of_html
                     : extension == ".json" ? problem_of_json
                                            : nullptr;
  return check ? check(read_text(file)) : "";
}

} // namespace

void check_other_files(const Written_model& model, const std::filesystem::path& directory, Report& report)
{
  report.begin("files");
  std::size_t named = 0, read = 0;
  for (const Written_part& part : model.parts) {
    if (part.texture.empty()) continue;
    ++named;
    if (!std::filesystem::exists(directory / part.texture))
      report.violation(part.texture + ", the texture of part " + part.id + ", does not exist");
  }
  std::set<std::string> drawings; // read already
  for (const Written_sheet& sheet : model.sheets) drawings.insert((directory / sheet.file).lexically_normal().string());
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(directory))
    if (entry.is_regular_file() && !drawings.count(entry.path().lexically_normal().string()))
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const auto& file : files) {
    const std::string name = file.lexically_relative(directory).generic_string();
    try {
      const std::string problem = problem_of_file(file);
      if (!problem.empty()) report.unreadable(name + ": " + problem);
      ++read;
    } catch (const Unreadable& e) {
      report.unreadable((file.lexically_relative(directory).parent_path() / e.what()).generic_string());
    }
  }
  report.checked(counted(read, "file") + " beside the sheets whole, " + counted(named, "texture") + " named and there");
}

std::set<std::string> words_of_warnings(const std::filesystem::path& directory)
{
  std::set<std::string> words;
  if (!std::filesystem::exists(directory / "report.json")) return words;
  const nlohmann::json json = nlohmann::json::parse(read_text(directory / "report.json"), nullptr, false);
  if (!json.is_object() || !json.contains("warnings")) return words;
  const std::string text = json["warnings"].dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  std::string word;
  for (char c : text + " ")
    if (std::isalnum(static_cast<unsigned char>(c))) word += c;
    else words.insert(word), word.clear();
  return words;
}

} // namespace verification
} // namespace Multiplanar
} // namespace CGAL
