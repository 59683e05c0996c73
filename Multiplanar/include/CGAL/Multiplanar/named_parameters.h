// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_NAMED_PARAMETERS_H
#define CGAL_MULTIPLANAR_NAMED_PARAMETERS_H

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

namespace CGAL {
namespace Multiplanar {

namespace internal_np {
#define CGAL_add_named_parameter(X, Y, Z)                                                                              \
  enum X                                                                                                               \
  {                                                                                                                    \
    Y                                                                                                                  \
  };
#include <CGAL/Multiplanar/internal/parameters_interface.h>
#undef CGAL_add_named_parameter
} // namespace internal_np

/// CGAL's named parameters extended by this package's. Ours come first in a chain and CGAL's follow:
/// `Multiplanar::parameters::number_of_panels(50).random_seed(3)`.
template <typename T, typename Tag, typename Base = CGAL::internal_np::No_property>
struct Named_parameters : CGAL::Named_function_parameters<T, Tag, Base>
{
  using parent = CGAL::Named_function_parameters<T, Tag, Base>;
  using self = Named_parameters<T, Tag, Base>;

  explicit Named_parameters(const T& v) : parent(v) {}
  Named_parameters(const T& v, const Base& b) : parent(v, b) {}

#define CGAL_add_named_parameter(X, Y, Z)                                                                              \
  template <typename K>                                                                                                \
  Named_parameters<K, internal_np::X, self> Z(const K& k) const                                                        \
  {                                                                                                                    \
    return Named_parameters<K, internal_np::X, self>(k, *this);                                                        \
  }
#include <CGAL/Multiplanar/internal/parameters_interface.h>
#undef CGAL_add_named_parameter
};

namespace parameters {
#define CGAL_add_named_parameter(X, Y, Z)                                                                              \
  template <typename K>                                                                                                \
  Named_parameters<K, internal_np::X> Z(const K& k)                                                                    \
  {                                                                                                                    \
    return Named_parameters<K, internal_np::X>(k);                                                                     \
  }
#include <CGAL/Multiplanar/internal/parameters_interface.h>
#undef CGAL_add_named_parameter
} // namespace parameters

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_NAMED_PARAMETERS_H
