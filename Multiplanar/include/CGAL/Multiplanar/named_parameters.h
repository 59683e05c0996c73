// Copyright (c) 2026 The Multiplanar authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTIPLANAR_NAMED_PARAMETERS_H
#define CGAL_MULTIPLANAR_NAMED_PARAMETERS_H

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

namespace CGAL {
namespace Multiplanar {

namespace internal_np {
#ifndef DOXYGEN_RUNNING
#define CGAL_add_named_parameter(X, Y, Z)                                                                              \
  enum X                                                                                                               \
  {                                                                                                                    \
    Y                                                                                                                  \
  };
#include <CGAL/Multiplanar/internal/parameters_interface.h>
#undef CGAL_add_named_parameter
#endif
} // namespace internal_np

/// CGAL's named parameters extended by this package's, chained in any order:
/// `Multiplanar::parameters::number_of_panels(50).random_seed(3).effort(Multiplanar::Effort::fast)`.
/// CGAL's own are declared again so that they return this type: a member inherited from a link further down the chain
/// would drop the links above it.
template <typename T, typename Tag, typename Base = CGAL::internal_np::No_property>
struct Named_parameters : CGAL::Named_function_parameters<T, Tag, Base>
{
  using parent = CGAL::Named_function_parameters<T, Tag, Base>; ///< what is extended
  using self = Named_parameters<T, Tag, Base>;                  ///< this type

  explicit Named_parameters(const T& v) : parent(v) {}          ///< the first of a chain
  Named_parameters(const T& v, const Base& b) : parent(v, b) {} ///< the next of a chain

#ifndef DOXYGEN_RUNNING
#define CGAL_add_named_parameter(X, Y, Z)                                                                              \
  template <typename K>                                                                                                \
  Named_parameters<K, internal_np::X, self> Z(const K& k) const                                                        \
  {                                                                                                                    \
    return Named_parameters<K, internal_np::X, self>(k, *this);                                                        \
  }
#include <CGAL/Multiplanar/internal/parameters_interface.h>
#undef CGAL_add_named_parameter
#endif

#ifndef DOXYGEN_RUNNING
#define CGAL_add_named_parameter(X, Y, Z)                                                                              \
  template <typename K>                                                                                                \
  Named_parameters<K, CGAL::internal_np::X, self> Z(const K& k) const                                                  \
  {                                                                                                                    \
    return Named_parameters<K, CGAL::internal_np::X, self>(k, *this);                                                  \
  }
#define CGAL_add_named_parameter_with_compatibility(X, Y, Z) CGAL_add_named_parameter(X, Y, Z)
#define CGAL_add_named_parameter_with_compatibility_cref_only(X, Y, Z) CGAL_add_named_parameter(X, Y, Z)
#define CGAL_add_named_parameter_with_compatibility_ref_only(X, Y, Z) CGAL_add_named_parameter(X, Y, Z)
#define CGAL_add_extra_named_parameter_with_compatibility(X, Y, Z)
#include <CGAL/STL_Extension/internal/parameters_interface.h>
#undef CGAL_add_named_parameter
#undef CGAL_add_named_parameter_with_compatibility
#undef CGAL_add_named_parameter_with_compatibility_cref_only
#undef CGAL_add_named_parameter_with_compatibility_ref_only
#undef CGAL_add_extra_named_parameter_with_compatibility
#endif
};

namespace parameters {
#ifndef DOXYGEN_RUNNING
#define CGAL_add_named_parameter(X, Y, Z)                                                                              \
  template <typename K>                                                                                                \
  Named_parameters<K, internal_np::X> Z(const K& k)                                                                    \
  {                                                                                                                    \
    return Named_parameters<K, internal_np::X>(k);                                                                     \
  }
#include <CGAL/Multiplanar/internal/parameters_interface.h>
#undef CGAL_add_named_parameter
#endif
} // namespace parameters

} // namespace Multiplanar
} // namespace CGAL

#endif // CGAL_MULTIPLANAR_NAMED_PARAMETERS_H
