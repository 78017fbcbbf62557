// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// What a facet made of another one passes on.

#include <cstddef>
#include <utility>

#include "vcavity/facet/facet.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/number.hpp"

namespace vcavity {

/// Base of the facets that see the reflection of another one in their own way, such as `Polarized`.
/// @tparam Wrapper the class template that derives from it
/// @tparam Facet the facet that it wraps
template <template <class> class Wrapper, class Facet>
class FacetWrapper {
 public:
  explicit FacetWrapper(Facet facet) : facet_(std::move(facet)) {}

  /// The facet that this one is made of.
  const Facet& facet() const& { return facet_; }
  Facet facet() && { return std::move(facet_); }

  /// That of the facet.
  auto critical_cosine() const
    requires requires(const Facet& facet) { facet.critical_cosine(); }
  {
    return facet_.critical_cosine();
  }

  /// Those of the facet.
  auto singular_cosines() const
    requires requires(const Facet& facet) { facet.singular_cosines(); }
  {
    return facet_.singular_cosines();
  }

  /// The same for several directions at once.
  template <std::size_t directions>
  auto over_directions() const
    requires OverDirections<Facet>
  {
    auto facet = facet_.template over_directions<directions>();
    return Wrapper<decltype(facet)>(std::move(facet));
  }

 private:
  Facet facet_;
};

}  // namespace vcavity
