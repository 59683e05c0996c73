// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "guide_files.h"

// The assembler takes the files in as they are; CMake names them.
#define MULTIPLANAR_TAKE_IN(name, file)                                                                                \
  __asm__(".pushsection .rodata\n"                                                                                     \
          "multiplanar_" #name ":\n.incbin \"" file "\"\n"                                                             \
          "multiplanar_" #name "_end:\n.popsection\n");                                                                \
  extern "C" const char multiplanar_##name[] __asm__("multiplanar_" #name);                                            \
  extern "C" const char multiplanar_##name##_end[] __asm__("multiplanar_" #name "_end");                               \
  static std::string take_##name() { return std::string(multiplanar_##name, multiplanar_##name##_end); }

MULTIPLANAR_TAKE_IN(page, MULTIPLANAR_GUIDE "/guide.html")
MULTIPLANAR_TAKE_IN(style, MULTIPLANAR_GUIDE "/guide.css")
MULTIPLANAR_TAKE_IN(scene, MULTIPLANAR_GUIDE "/scene.js")
MULTIPLANAR_TAKE_IN(painting, MULTIPLANAR_GUIDE "/painting.js")
MULTIPLANAR_TAKE_IN(view, MULTIPLANAR_GUIDE "/view.js")
MULTIPLANAR_TAKE_IN(steps, MULTIPLANAR_GUIDE "/steps.js")
MULTIPLANAR_TAKE_IN(card, MULTIPLANAR_GUIDE "/card.js")
MULTIPLANAR_TAKE_IN(controls, MULTIPLANAR_GUIDE "/controls.js")
MULTIPLANAR_TAKE_IN(print, MULTIPLANAR_GUIDE "/print.js")
MULTIPLANAR_TAKE_IN(begin, MULTIPLANAR_GUIDE "/begin.js")
MULTIPLANAR_TAKE_IN(three, MULTIPLANAR_THREE)
MULTIPLANAR_TAKE_IN(orbit, MULTIPLANAR_ORBIT)

namespace guide_files {

std::string page() { return take_page(); }
std::string style() { return take_style(); }
std::string three() { return take_three(); }
std::string orbit() { return take_orbit(); }

std::string script()
{
  return "'use strict';\n(function () {\n" + take_scene() + take_painting() + take_view() + take_steps() + take_card() +
         take_controls() + take_print() + take_begin() + "})();\n";
}

} // namespace guide_files
