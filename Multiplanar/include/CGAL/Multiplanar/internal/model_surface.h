// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_INTERNAL_MODEL_SURFACE_H
#define CGAL_MULTIPLANAR_INTERNAL_MODEL_SURFACE_H

#include <CGAL/Multiplanar/internal/Panel_model.h>
#include <CGAL/Multiplanar/internal/label_edits.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <vector>

// The triangulated panels of a model and its faults. Where a model comes from another, panels that did not change are
// taken over, and faults are looked for only where something did.

namespace CGAL {
namespace Multiplanar {
namespace internal {

/// The number in `m` of each panel of `old`, or -1.
inline std::vector<int> panels_now(const Panel_model& old, const Label_edit& edit)
{
  std::vector<int> now(old.panels(), -1);
  for (int p = 0; p < int(edit.old_panel.size()); ++p)
    if (edit.old_panel[p] >= 0) now[edit.old_panel[p]] = p;
  return now;
}

/// The number in `m` of the corner on the same mesh vertex, for each corner of `old`, or -1.
inline std::vector<int> corners_now(const Panel_model& old, const Panel_model& m)
{
  std::vector<int> result;
  std::size_t j = 0;
  for (int v : old.corner_vertex) { // both ascend
    while (j < m.corner_vertex.size() && m.corner_vertex[j] < v) ++j;
    result.push_back(j < m.corner_vertex.size() && m.corner_vertex[j] == v ? int(j) : -1);
  }
  return result;
}

/// Looks for contacts of the panels in `changed` anew.
inline void renew_contacts(Panel_model& m, const std::vector<char>& changed)
{
  const auto lost = [&](const std::array<int, 2>& pair) { return changed[pair[0]] || changed[pair[1]]; };
  m.contacts.erase(std::remove_if(m.contacts.begin(), m.contacts.end(), lost), m.contacts.end());
  const auto found = m.surface->conflicts(m.state, changed, 1 << 20);
  m.contacts.insert(m.contacts.end(), found.begin(), found.end());
}

/// The contacts of `old` between panels that exist before and after.
inline std::vector<std::array<int, 2>> contacts_kept(const Panel_model& old, const Label_edit& edit)
{
  std::vector<std::array<int, 2>> result;
  if (old.contacts.empty()) return result;
  const std::vector<int> now = panels_now(old, edit);
  for (const auto& pair : old.contacts)
    if (now[pair[0]] >= 0 && now[pair[1]] >= 0) result.push_back({now[pair[0]], now[pair[1]]});
  return result;
}

/// Makes the surface of `m`, whose state is known, and counts its faults.
/// \param old the model before, or null
/// \param changed panels whose shape is not what it was
/// \param corner_now the number of each corner of `old` in `m`, or -1
inline void make_surface(const Panel_model* old, const Label_edit& edit, const std::vector<char>& changed,
                         const std::vector<int>& corner_now, Panel_model& m)
{
  const int n = m.panels();
  auto surface = std::make_shared<Panel_surface>(*m.topology);
  std::vector<int> others;
  for (int p = 0; p < n; ++p)
    if (!old || changed[p] || edit.old_panel[p] < 0 || !surface->take(p, *old->surface, edit.old_panel[p], corner_now))
      others.push_back(p);
  surface->update(m.state, others);
  surface->build_tree(m.state);
  m.surface = surface;
  m.contacts = old ? contacts_kept(*old, edit) : std::vector<std::array<int, 2>>();
  renew_contacts(m, changed);
  m.faults = int(m.contacts.size());
  for (int p = 0; p < n; ++p) m.faults += !surface->is_simple(p);
}

} // namespace internal
} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_INTERNAL_MODEL_SURFACE_H
