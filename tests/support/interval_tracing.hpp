// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Light in a convex groove, by the law of the mirror and nothing else: the independent witness of every closed form
/// for grooves that are not symmetric or have a flat bottom.
///
/// Method. Parallel rays side by side are a pencil: a direction and an interval of offsets across it. It is cut where
/// the ends of the edges lie in it, each piece is reflected about the edge that it meets, and stops at the opening. No
/// unfolding, no bounce count, no running minimum; all in the plane across the groove. Exact but for rounding, in any
/// number type.

#include <string>
#include <vcavity/conventions.hpp>
#include <vector>

namespace vcavity::test {

/// A straight piece of the cross-section of a groove.
template <class Real>
struct Edge {
  Vec2<Real> start, end;  ///< (y, z); the light is on the left of the way from start to end
  char name;              ///< '1' and '2' for the panels, 'F' for the floor
};

/// A pencil of rays that has left the groove.
template <class Real>
struct TracedPencil {
  std::string way;            ///< names of the edges in the order in which they were met
  Real weight;                ///< fraction of the opening
  std::vector<Real> cosines;  ///< of incidence, one for each edge of the way
  Vec3<Real> direction;       ///< of travel
};

/// The edges of a V-shaped groove of depth 1 whose floor has a given width; panels at slopes β1 and β2 to the mean
/// plane, rims at equal height. Without a floor walls may overhang.
template <class Real>
std::vector<Edge<Real>> groove_edges(const Real& beta1, const Real& beta2, const Real& floor_width) {
  using std::cos;
  using std::sin;
  const Real left = -cos(beta1) / sin(beta1);
  const Real right = cos(beta2) / sin(beta2) + floor_width;
  const Vec2<Real> rim1{left, Real(1)}, foot1{Real(0), Real(0)}, foot2{floor_width, Real(0)},
      rim2{right, Real(1)};
  std::vector<Edge<Real>> edges{{rim1, foot1, '1'}};
  if (floor_width > Real(0)) edges.push_back({foot1, foot2, 'F'});
  edges.push_back({foot2, rim2, '2'});
  return edges;
}

/// Follows all light of one direction through a groove.
template <class Real>
class IntervalTracing {
 public:
  /// @param edges from the rim at y < 0 to the other one; with the opening they bound a convex area
  explicit IntervalTracing(std::vector<Edge<Real>> edges) : edges_(std::move(edges)) {
    edges_.push_back({edges_.back().end, edges_.front().start, '\0'});
  }

  /// The pencils that leave the groove, longest first part first.
  /// @param e direction towards the light, e.z > 0
  std::vector<TracedPencil<Real>> operator()(const Vec3<Real>& e) const {
    using std::sqrt;
    const Real size = sqrt(e.y * e.y + e.z * e.z);
    const Vec2<Real> travel{-e.y / size, -e.z / size};
    const Edge<Real>& opening = edges_.back();
    const Real one = offset(travel, opening.start), two = offset(travel, opening.end);
    Result result{size, e.x, one < two ? two - one : one - two, {}};
    follow({travel, one < two ? one : two, one < two ? two : one}, {}, {}, result);
    return result.pencils;
  }

 private:
  struct Pencil {
    Vec2<Real> travel;
    Real low, high;
  };
  struct Result {
    Real across, along, width;
    std::vector<TracedPencil<Real>> pencils;
  };

  static Real offset(const Vec2<Real>& travel, const Vec2<Real>& point) {
    return travel.x * point.y - travel.y * point.x;
  }

  void follow(const Pencil& pencil, const std::string& way, const std::vector<Real>& cosines,
              Result& result) const {
    using std::sqrt;
    for (const Edge<Real>& edge : edges_) {
      const Vec2<Real> along = edge.end - edge.start;
      const Real length = sqrt(along.x * along.x + along.y * along.y);
      const Vec2<Real> normal{-along.y / length, along.x / length};  // towards the light
      const Real approach = -(pencil.travel.x * normal.x + pencil.travel.y * normal.y);
      if (!(approach > Real(0))) continue;
      const Real one = offset(pencil.travel, edge.start), two = offset(pencil.travel, edge.end);
      const Real low = one < two ? one : two, high = one < two ? two : one;
      const Pencil piece{pencil.travel, pencil.low < low ? low : pencil.low,
                         high < pencil.high ? high : pencil.high};
      if (!(piece.low < piece.high)) continue;
      if (edge.name == '\0') {
        result.pencils.push_back(
            {way,
             (piece.high - piece.low) / result.width,
             cosines,
             {-result.along, result.across * pencil.travel.x, result.across * pencil.travel.y}});
        continue;
      }
      const Vec2<Real> reflected{pencil.travel.x + Real(2) * approach * normal.x,
                                 pencil.travel.y + Real(2) * approach * normal.y};
      const Real mirror = offset(reflected, edge.start) + offset(pencil.travel, edge.start);
      std::vector<Real> met = cosines;
      met.push_back(result.across * approach);
      follow({reflected, mirror - piece.high, mirror - piece.low}, way + edge.name, met, result);
    }
  }

  std::vector<Edge<Real>> edges_;
};

}  // namespace vcavity::test
