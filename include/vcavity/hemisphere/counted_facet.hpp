// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// A facet that counts how often it is asked: the cost of a computation, whatever the machine.

#include <concepts>
#include <cstddef>
#include <utility>

#include "vcavity/facet/facet_wrapper.hpp"

namespace vcavity {

/// A facet that counts its evaluations, and is in all else the same.
template <class Facet>
class CountedFacet : public FacetWrapper<CountedFacet, Facet> {
  using Base = FacetWrapper<CountedFacet, Facet>;

 public:
  /// @param facet that is counted
  /// @param evaluations where they are counted; must outlive the facet
  /// @param directions of a call
  CountedFacet(Facet facet, long long& evaluations, std::size_t directions = 1)
      : Base(std::move(facet)), evaluations_(&evaluations), directions_(directions) {}

  /// The reflectance of a bounce, counted.
  /// @param bounce its cosine, or all of it
  template <class Argument>
    requires std::invocable<const Facet&, const Argument&>
  auto operator()(const Argument& bounce) const {
    *evaluations_ += static_cast<long long>(directions_);
    return Base::facet()(bounce);
  }

  /// The same for several directions at once.
  template <std::size_t directions>
  auto over_directions() const
    requires OverDirections<Facet>
  {
    using Wide = decltype(std::declval<const Facet&>().template over_directions<directions>());
    return CountedFacet<Wide>(Base::facet().template over_directions<directions>(), *evaluations_,
                              directions);
  }

 private:
  long long* evaluations_;
  std::size_t directions_;
};

}  // namespace vcavity
