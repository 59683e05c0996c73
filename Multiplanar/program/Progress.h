// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_PROGRAM_PROGRESS_H
#define MULTIPLANAR_PROGRAM_PROGRESS_H

#include <chrono>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

/// Tells the user on standard output how far the job is, stage by stage, and keeps each stage's seconds.
class Progress
{
public:
  enum class Style
  {
    quiet,
    bar,   ///< a terminal: one line that is drawn anew
    lines, ///< a pipe: a plain line now and then
    json   ///< an object a line
  };

  explicit Progress(Style style) : style(style) {}

  /// `fraction` in 0..1 of `stage` is done. Another stage than before ends the one before. May be called by any thread.
  void update(const std::string& stage, double fraction);
  /// Something happened that only programs want to know: a JSON object, printed where progress is such objects.
  void event(const std::string& json);
  /// Ends the current stage.
  void finish();
  /// Takes the bar away, so that a message can be printed.
  void clear();

  Style what_style() const { return style; }
  /// By stage, in the order of their beginnings.
  const std::vector<std::pair<std::string, double>>& seconds() const { return stages; }

private:
  using Clock = std::chrono::steady_clock;

  void begin(const std::string& stage);
  void end();
  void draw();
  void draw_bar(double elapsed) const;
  void draw_line(double elapsed) const;
  void draw_json(double elapsed) const;
  bool is_due(double elapsed) const;

  Style style;
  std::mutex mutex;
  std::string current;
  double done = 0;        ///< fraction of the current stage
  double drawn = -1;      ///< the fraction that was drawn last
  double drawn_after = 0; ///< and the second of the stage when it was
  Clock::time_point start;
  std::vector<std::pair<std::string, double>> stages;
};

#endif // MULTIPLANAR_PROGRAM_PROGRESS_H
