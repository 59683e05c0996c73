// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"
#include "failure.h"

#include "verify/verify.h"

#include <iostream>

void verify(const Settings& settings)
{
  const int code = CGAL::Multiplanar::verify(settings.input, std::cout);
  std::cout.flush();
  if (code == exit_broken_promise)
    throw Failure(exit_broken_promise, settings.input + ": breaks what it promises: see the lines \"violation\"");
  if (code != exit_done)
    throw input_error(settings.input +
                      ": cannot be read as a whole: see the lines \"unreadable\"; it should be a folder "
                      "that make or fabricate wrote");
}
