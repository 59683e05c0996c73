// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "failure.h"

std::string quoted(const std::string& text)
{
  std::string result = "\"";
  for (std::size_t i = 0; i < text.size() && i < 40; ++i) result += text[i] >= 32 && text[i] < 127 ? text[i] : '?';
  return result + (text.size() > 40 ? "...\"" : "\"");
}
