// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Several distributions of grooves in one type, so that a test of all of them compiles the physics once.

#include <utility>
#include <variant>
#include <vcavity/rough/brushed_slopes.hpp>
#include <vcavity/rough/elliptic_slopes.hpp>
#include <vcavity/rough/mixed_slopes.hpp>
#include <vcavity/rough/tabulated_slopes.hpp>

namespace vcavity::test {

template <class Slopes, class Lanes>
concept HasDensities = requires(const Slopes& slopes, const Vec2<scalar_t<Lanes>>& across, const Lanes& x) {
  slopes.densities(across, x, x);
};

/// One of some distributions. It has densities of packs if all of them have.
template <class Real, class... Slopes>
class OneOfSlopes {
 public:
  using value_type = Real;

  template <class One>
  explicit OneOfSlopes(One slopes) : slopes_(std::move(slopes)) {}

  Real density(const Vec3<Real>& m) const {
    return std::visit([&m](const auto& slopes) { return slopes.density(m); }, slopes_);
  }
  template <class Lanes>
    requires(HasDensities<Slopes, Lanes> && ...)
  Lanes densities(const Vec2<Real>& across, const Lanes& cos_half, const Lanes& sin_half) const {
    return std::visit([&](const auto& slopes) { return slopes.densities(across, cos_half, sin_half); },
                      slopes_);
  }
  Vec3<Real> sample(const Vec2<Real>& u) const {
    return std::visit([&u](const auto& slopes) { return slopes.sample(u); }, slopes_);
  }

 private:
  std::variant<Slopes...> slopes_;
};

template <class Real>
using AnyEllipticSlopes = OneOfSlopes<Real, GgxSlopes<Real>, BeckmannSlopes<Real>>;

template <class Real>
using AnyOtherSlopes = OneOfSlopes<Real, BrushedSlopes<BeckmannSlopes<Real>>, TabulatedSlopes<Real>,
                                   MixedSlopes<GgxSlopes<Real>, BeckmannSlopes<Real>>>;

}  // namespace vcavity::test
