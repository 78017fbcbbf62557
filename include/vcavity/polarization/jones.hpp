// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Jones matrices: what a sequence of reflections does to the field of a fully polarised wave.

#include <cmath>

#include "vcavity/facet/facet.hpp"
#include "vcavity/numbers/complex.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/number.hpp"

namespace vcavity {

/// Field components along the axes a and b (see conventions.hpp): E_a → aa E_a + ab E_b, E_b → ba E_a + bb
/// E_b.
template <class Value>
struct Jones {
  using value_type = scalar_t<Value>;

  Complex<Value> aa, ab, ba, bb;

  Jones() = default;
  Jones(const Complex<Value>& a_from_a, const Complex<Value>& a_from_b, const Complex<Value>& b_from_a,
        const Complex<Value>& b_from_b)
      : aa(a_from_a), ab(a_from_b), ba(b_from_a), bb(b_from_b) {}

  /// 1: the field stays as it is. 0: no light at all.
  explicit Jones(int light)
      : aa{Value(static_cast<value_type>(light)), Value(0)},
        ab{Value(0), Value(0)},
        ba{Value(0), Value(0)},
        bb{Value(static_cast<value_type>(light)), Value(0)} {}

  /// `first` followed by `second`; the matrix product in the opposite order.
  friend Jones operator*(const Jones& first, const Jones& second) {
    return {second.aa * first.aa + second.ab * first.ba, second.aa * first.ab + second.ab * first.bb,
            second.ba * first.aa + second.bb * first.ba, second.ba * first.ab + second.bb * first.bb};
  }

  /// The largest part of an element.
  friend value_type largest(const Jones& a) {
    value_type result(0);
    for (const Complex<Value>* element : {&a.aa, &a.ab, &a.ba, &a.bb})
      result = at_least(result, at_least(largest(element->re), largest(element->im)));
    return result;
  }

  /// The matrix scaled down, if need be, so that no axis of the incident field leaves with an amplitude beyond `ceiling`.
  friend Jones at_most(const Jones& a, const value_type& ceiling) {
    using std::sqrt;
    const value_type power =
        at_least(largest(Value(norm(a.aa) + norm(a.ba))), largest(Value(norm(a.ab) + norm(a.bb))));
    if (!(power > ceiling * ceiling)) return a;
    const Value scale(ceiling / value_type(sqrt(power)));
    return {scale * a.aa, scale * a.ab, scale * a.ba, scale * a.bb};
  }
};

}  // namespace vcavity
