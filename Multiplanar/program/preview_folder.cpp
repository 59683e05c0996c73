// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Output.h"
#include "commands.h"
#include "previews.h"
#include "read_written_model.h"

#include <cstdio>

void preview(const Settings& settings, Progress& progress)
{
  progress.update("read", 0);
  const Written_folder folder = read_written_model(settings.input);
  progress.update("preview", 0);
  int pictures = 0;
  const File_writer write = [&](const std::string& name, const std::function<void(std::ostream&)>& write_to) {
    Output output(Output::Kind::file, settings.input + "/" + name);
    output.write("", write_to);
    output.commit();
    progress.update("preview", double(++pictures) / double(4 + folder.model.sheets.size()));
  };
  const Preview_view view = preview_view(folder.model.complex, settings.approximation.threads);
  write_model_previews(write, folder.model, view);
  progress.finish();
  if (progress.what_style() == Progress::Style::bar || progress.what_style() == Progress::Style::lines)
    std::printf("%d pictures written: %s/preview\n", pictures, settings.input.c_str());
}
