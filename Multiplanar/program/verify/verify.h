// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPLANAR_VERIFY_VERIFY_H
#define MULTIPLANAR_VERIFY_VERIFY_H

#include <filesystem>
#include <iosfwd>

namespace CGAL {
namespace Multiplanar {

/*!
Digital assembly of what stands in `directory`: reads the written files only, rebuilds every part as a solid and checks
every promise that the files make. Nothing here is shared with the code that made the parts.

Writes one line a violation ("violation: ..."), one line a file that cannot be read ("unreadable: ..."), and at the end
a summary that says what was proved and what the files do not claim.

\return 0 if all holds, 1 if a promise is broken, 3 if `model.json` or another file cannot be read

What is decided, and how exactly:
- The model: closed, every loop simple, no two panels meeting elsewhere than in shared corners and edges: exact
  predicates on the written coordinates. Flat: exact, within 1e-9 of the diagonal.
- Parts disjoint, parts inside the model, steps of the assembly free: exact on the written numbers, parts eroded by
  1 micrometre. See erosion.h for what that means to the last digit: an overlap that holds a ball of radius 1.5
  micrometres is never missed, one that holds no ball of radius 1 micrometre is never reported.
- Tabs in slots, teeth, drawings: lengths compared with tolerances of micrometres, in doubles (rounding errors are a
  millionth of the tolerances).

In an assembly, `direction` is the direction in which the parts of a step move when they are put in place.
*/
int verify(const std::filesystem::path& directory, std::ostream& out);

} // namespace Multiplanar
} // namespace CGAL

#endif // MULTIPLANAR_VERIFY_VERIFY_H
