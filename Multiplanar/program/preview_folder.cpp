// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Output.h"
#include "commands.h"
#include "previews.h"
#include "read_written_model.h"

#include "failure.h"
#include "read_image.h"
#include "read_mesh.h"
#include "texture_path.h"

#include <cstdio>
#include <deque>
#include <map>
#include <stdexcept>

namespace {

/// The images that the parts of a written model name. One that is missing or damaged leaves its parts in colours.
Part_pictures written_textures(const CGAL::Multiplanar::Model& model, const std::string& folder,
                               std::deque<CGAL::Multiplanar::Texture>& textures)
{
  Part_pictures pictures;
  std::map<std::string, const CGAL::Multiplanar::Texture*> by_file;
  for (const CGAL::Multiplanar::Part& part : model.parts) {
    if (part.texture.file.empty()) continue;
    const CGAL::Multiplanar::Texture*& texture = by_file[part.texture.file];
    try {
      std::string reason;
      const std::string file = file_below(folder, part.texture.file, reason);
      if (!texture && !file.empty()) {
        textures.emplace_back(read_image(read_file(file)), CGAL::Multiplanar::Texture_wrap::clamp,
                              CGAL::Multiplanar::Texture_wrap::clamp);
        texture = &textures.back();
      }
    } catch (const std::runtime_error&) {
    }
    if (texture)
      pictures[part.id] = {texture, part.texture.origin, texture->width() * part.texture.mm_per_pixel,
                           texture->height() * part.texture.mm_per_pixel};
  }
  return pictures;
}

} // namespace

void preview(const Settings& settings, Progress& progress)
{
  progress.update("read", 0);
  const CGAL::Multiplanar::Model model = read_written_model(settings.input);
  progress.update("preview", 0);
  int pictures = 0;
  const File_writer write = [&](const std::string& name, const std::function<void(std::ostream&)>& write_to) {
    Output output(Output::Kind::file, settings.input + "/" + name);
    output.write("", write_to);
    output.commit();
    progress.update("preview", double(++pictures) / double(4 + model.sheets.size()));
  };
  std::deque<CGAL::Multiplanar::Texture> textures;
  const Part_pictures looks = written_textures(model, settings.input, textures);
  const Preview_view view = preview_view(model.complex, settings.approximation.threads);
  write_model_previews(write, model, view, looks);
  progress.finish();
  if (progress.what_style() == Progress::Style::bar || progress.what_style() == Progress::Style::lines)
    std::printf("%d pictures written: %s/preview\n", pictures, settings.input.c_str());
}
