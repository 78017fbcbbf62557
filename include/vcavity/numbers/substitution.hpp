// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// A variable of integration of either kind: one that draws nodes to the ends of a range, or one that draws them to a pair
/// of branch points next to the real axis.

#include <array>
#include <variant>

#include "vcavity/numbers/sine_substitution.hpp"
#include "vcavity/numbers/sinh_substitution.hpp"

namespace vcavity {

/// Either substitution, chosen piece by piece.
class Substitution {
 public:
  Substitution() = default;
  Substitution(const SineSubstitution& sine) : kind_(sine) {}
  Substitution(const SinhSubstitution& sinh) : kind_(sinh) {}

  /// The value x and its derivative dx/du.
  /// @param u in [−1, 1], a number or a pack of them
  template <class Reals>
  std::array<Reals, 2> at(const Reals& u) const {
    return std::visit([&u](const auto& kind) { return kind.at(u); }, kind_);
  }

  friend bool operator==(const Substitution&, const Substitution&) = default;

 private:
  std::variant<SineSubstitution, SinhSubstitution> kind_;
};

}  // namespace vcavity
