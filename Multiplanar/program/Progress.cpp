// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Progress.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace {

std::string clock_text(double seconds)
{
  char buffer[32];
  const long s = std::lround(std::min(seconds, 1e6));
  std::snprintf(buffer, sizeof buffer, "%ld:%02ld", s / 60, s % 60);
  return buffer;
}

double seconds_left(double elapsed, double fraction) { return elapsed * (1 - fraction) / fraction; }

} // namespace

void Progress::update(const std::string& stage, double fraction)
{
  const std::lock_guard<std::mutex> lock(mutex);
  if (stage != current) {
    end();
    begin(stage);
  }
  done = std::min(1., std::max(0., fraction));
  draw();
}

void Progress::event(const std::string& json)
{
  const std::lock_guard<std::mutex> lock(mutex);
  if (style != Style::json) return;
  std::printf("%s\n", json.c_str());
  std::fflush(stdout);
}

void Progress::finish()
{
  const std::lock_guard<std::mutex> lock(mutex);
  end();
}

void Progress::clear()
{
  const std::lock_guard<std::mutex> lock(mutex);
  if (style == Style::bar && !current.empty()) std::fputs("\r\033[K", stdout);
  std::fflush(stdout);
}

void Progress::begin(const std::string& stage)
{
  current = stage;
  done = 0;
  drawn = -1;
  start = Clock::now();
}

void Progress::end()
{
  if (current.empty()) return;
  const double elapsed = std::chrono::duration<double>(Clock::now() - start).count();
  const auto known = std::find_if(stages.begin(), stages.end(), [&](const auto& s) { return s.first == current; });
  if (known == stages.end()) stages.emplace_back(current, elapsed);
  else known->second += elapsed;
  if (style == Style::bar) std::printf("\r\033[K%-12s %6.1f s\n", current.c_str(), elapsed);
  if (style == Style::lines) std::printf("%s: done in %.1f s\n", current.c_str(), elapsed);
  if (style == Style::json)
    std::printf("{\"event\":\"stage\",\"stage\":\"%s\",\"fraction\":1,\"seconds\":%.3f}\n", current.c_str(), elapsed);
  std::fflush(stdout);
  current.clear();
}

/// A bar may move ten times a second; lines come at every tenth of a stage, but not more often than once a second.
bool Progress::is_due(double elapsed) const
{
  if (drawn < 0) return true;
  if (style == Style::lines) return std::floor(done * 10) > std::floor(drawn * 10) && elapsed >= drawn_after + 1;
  return elapsed >= drawn_after + 0.1;
}

void Progress::draw()
{
  const double elapsed = std::chrono::duration<double>(Clock::now() - start).count();
  if (style == Style::quiet || !is_due(elapsed)) return;
  if (style == Style::bar) draw_bar(elapsed);
  if (style == Style::lines) draw_line(elapsed);
  if (style == Style::json) draw_json(elapsed);
  std::fflush(stdout);
  drawn = done;
  drawn_after = elapsed;
}

void Progress::draw_bar(double elapsed) const
{
  const int width = 30, filled = int(done * width);
  const std::string bar = std::string(filled, '#') + std::string(width - filled, '-');
  const std::string left = done > 0 && elapsed > 0.5 ? "  " + clock_text(seconds_left(elapsed, done)) + " left" : "";
  std::printf("\r\033[K%-12s [%s] %3.0f%%%s", current.c_str(), bar.c_str(), done * 100, left.c_str());
}

void Progress::draw_line(double elapsed) const
{
  if (done > 0) std::printf("%s: %.0f%%, %.0f s left\n", current.c_str(), done * 100, seconds_left(elapsed, done));
  else std::printf("%s\n", current.c_str());
}

void Progress::draw_json(double elapsed) const
{
  std::printf("{\"event\":\"progress\",\"stage\":\"%s\",\"fraction\":%.4f,\"seconds\":%.3f", current.c_str(), done,
              elapsed);
  if (done > 0) std::printf(",\"seconds_left\":%.3f", seconds_left(elapsed, done));
  std::printf("}\n");
}
