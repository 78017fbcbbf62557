// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The local frame of a grooved surface in a renderer's scene.
///
/// x runs along the groove, z is the shading normal, y = z × x crosses the groove. A renderer whose shading
/// frame already has the groove along its first tangent needs none of this.

#include <limits>

#include "vcavity/conventions.hpp"
#include "vcavity/numbers/components.hpp"

namespace vcavity {

/// An orthonormal, right-handed frame at a point of a surface.
template <class Real>
class GrooveFrame {
 public:
  /// @param normal shading normal, a unit vector
  /// @param along_groove direction of the groove, of any length; only its part in the tangent plane counts.
  ///        If there is none (zero, or along the normal), any tangent serves.
  GrooveFrame(const Vec3<Real>& normal, const Vec3<Real>& along_groove) : z_(normal) {
    // Squares of very long and very short vectors would overflow or vanish.
    const Real size =
        at_least(at_least(largest(along_groove.x), largest(along_groove.y)), largest(along_groove.z));
    const Vec3<Real> along = size > std::numeric_limits<Real>::min() ? along_groove / size : normal;
    const Vec3<Real> tangent = in_tangent_plane(along);
    const Real length2 = dot(tangent, tangent);
    // What rounding leaves of a direction along the normal is not a tangent.
    const Real rounding = Real(8) * std::numeric_limits<Real>::epsilon();
    const bool usable = length2 > rounding * rounding * dot(along, along);
    // Of a direction close to the normal most cancels, and what is left is a tangent only roughly; not any more
    // the second time.
    x_ = normalized(in_tangent_plane(normalized(usable ? tangent : any_tangent(normal))));
    y_ = cross(z_, x_);
  }

  /// A direction of the scene in the frame of the groove.
  Vec3<Real> to_local(const Vec3<Real>& v) const { return {dot(v, x_), dot(v, y_), dot(v, z_)}; }

  /// A direction in the frame of the groove in the scene.
  Vec3<Real> to_world(const Vec3<Real>& v) const { return v.x * x_ + v.y * y_ + v.z * z_; }

 private:
  static Real dot(const Vec3<Real>& a, const Vec3<Real>& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
  static Vec3<Real> cross(const Vec3<Real>& a, const Vec3<Real>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
  /// A vector without its part along the normal.
  Vec3<Real> in_tangent_plane(const Vec3<Real>& v) const { return v - dot(v, z_) * z_; }
  static Vec3<Real> normalized(const Vec3<Real>& v) {
    using std::sqrt;
    return v / Real(sqrt(dot(v, v)));
  }
  /// The cross product with the axis that is farther from the normal.
  static Vec3<Real> any_tangent(const Vec3<Real>& n) {
    const bool near_x = n.x * n.x > n.y * n.y;
    return near_x ? Vec3<Real>{-n.z, Real(0), n.x} : Vec3<Real>{Real(0), n.z, -n.y};
  }

  Vec3<Real> x_;
  Vec3<Real> y_;
  Vec3<Real> z_;
};

}  // namespace vcavity
