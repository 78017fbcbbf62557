// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The axes of polarised light that a rough surface has in common for all its grooves.
///
/// Light that travels along k is described in a_z(k), the mean normal z as far as it is normal to k, and b_z =
/// k × a_z. Along z there is no such axis, and the x axis of the surface stands in. Values without polarisation
/// know no axes and stay as they are.

#include "vcavity/conventions.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/polarization/mueller.hpp"
#include "vcavity/rough/connecting_grooves.hpp"

namespace vcavity {

namespace detail {

/// The turn from the axes of a groove (conventions.hpp) to those of the surface.
/// @param k direction of travel in the frame of the groove
/// @param across of the groove, in the frame of the surface
template <class Real>
AxesTurn<Real> turn_to_mean_axes(const Vec3<Real>& k, const Vec2<Real>& across) {
  // The components of the new axis a along the old axes a and b, up to a factor.
  Real along_a = -k.x * k.z;
  Real along_b = -k.y;
  Real size = at_least(largest(along_a), largest(along_b));
  if (!(size > Real(0))) {
    along_a = across.y;
    along_b = k.z < Real(0) ? Real(-across.x) : across.x;
    size = Real(1);
  }
  along_a /= size;
  along_b /= size;
  const Real inverse = Real(1) / (along_a * along_a + along_b * along_b);
  return {(along_a * along_a - along_b * along_b) * inverse, Real(2) * along_a * along_b * inverse};
}

}  // namespace detail

/// What is the same for all axes.
template <class Value, class Real>
const Value& in_mean_axes(const Value& value, const ConnectingGrooves<Real>&) {
  return value;
}

/// A Mueller matrix in the axes of the surface.
/// @param value the same in the axes of a groove
/// @param e direction towards the light in the frame of the groove
/// @param leaving direction in which the light leaves, in the same frame
/// @param across the unit vector across the groove, in the frame of the surface
template <class Value, class Real>
Mueller<Value> in_mean_axes(const Mueller<Value>& value, const Vec3<Real>& e, const Vec3<Real>& leaving,
                            const Vec2<Real>& across) {
  return in_turned_axes(value, detail::turn_to_mean_axes(Vec3<Real>{-e.x, -e.y, -e.z}, across),
                        detail::turn_to_mean_axes(leaving, across));
}

/// A Mueller matrix in the axes of the grooves, of light from `to_light()` that leaves along `leaving()`, in those of
/// the surface.
template <class Value, class Real>
Mueller<Value> in_mean_axes(const Mueller<Value>& value, const ConnectingGrooves<Real>& grooves) {
  return in_mean_axes(value, grooves.to_light(), grooves.leaving(), grooves.across());
}

}  // namespace vcavity
