// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The reflectances of all bounces of several grooves, computed side by side.
///
/// The bounce i of a way has the angle of incidence κ − (i − ½)α in the plane across the groove, κ being the elevation
/// of the light above the panel that is met first: its cosine, times cos η, is that of the facet. So no bounce needs
/// the one before it. All of a batch of grooves are put into one row, whichever groove they belong to, and the facet
/// is asked for as many at once as vector registers hold, one component (colour) of its values after the other.
///
/// When not to use it: for facets that do not have `over_directions<n>(component)`, such as polarised ones, whose
/// values are no packs of numbers; `RoughGrooveBsdf` follows these bounce by bounce.

#include <algorithm>
#include <array>
#include <cstddef>

#include "vcavity/facet/facet.hpp"
#include "vcavity/numbers/acute_angles.hpp"
#include "vcavity/numbers/compiler.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/pack.hpp"
#include "vcavity/rough/connecting_grooves.hpp"

namespace vcavity {

/// How many numbers a value consists of.
template <class Value>
inline constexpr std::size_t number_count = 0;
template <Number Value>
inline constexpr std::size_t number_count<Value> = 1;
template <class Real, std::size_t size, std::size_t most_bytes>
inline constexpr std::size_t number_count<Pack<Real, size, most_bytes>> = size;

/// A facet whose values are numbers or packs of them, of which every component can be had for several directions at
/// once.
template <class Facet, class Real>
concept ComponentsOverDirections =
    number_count<value_t<Facet, Real>> > 0 && requires(const Facet& facet, std::size_t i) {
      facet.template over_directions<GrooveBatch<Real>::capacity>(i);
    };

/// Adds up the light of the ways through a batch of grooves.
template <class Real, ComponentsOverDirections<Real> Facet>
class BounceLanes {
 public:
  using Value = value_t<Facet, Real>;
  using Lanes = typename GrooveBatch<Real>::Lanes;

  explicit BounceLanes(const Facet& facet) : facet_(facet) {}

  /// @param cos_eta cos η of the grooves
  /// @param batch the grooves
  /// @param white the light of each for facets that reflect everything; those of 0 are left out
  /// @return the sum over the grooves of `white` times the reflectances of all bounces
  VCAVITY_INLINE Value sum(const Real& cos_eta, const GrooveBatch<Real>& batch, const Lanes& white) {
    // The grooves that have light, without a branch for each.
    std::array<std::size_t, lanes + 1> with_light;
    std::size_t count = 0;
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      with_light[count] = lane;
      count += white[lane] > Real(0) ? 1 : 0;
    }
    throughputs_.fill(Lanes(Real(1)));
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t lane = with_light[i];
      for (int done = 0; done < batch.bounces_of(lane); done += int(lanes)) {
        if (size_ > row_size - lanes) reflect_row(cos_eta);
        append(batch, lane, done);
      }
    }
    reflect_row(cos_eta);
    return value_of([&](std::size_t component) { return total(white * throughputs_[component]); });
  }

 private:
  static constexpr std::size_t lanes = GrooveBatch<Real>::capacity;
  static constexpr std::size_t row_size = 8 * lanes;
  static constexpr std::size_t components = number_count<Value>;
  using Row = std::array<Real, row_size>;

  /// A part of a way that stands in the row.
  struct Stretch {
    std::size_t lane, begin;
    int size;  // at most as many as there are lanes
  };

  /// Puts bounces of a way into the row, as many as there are lanes at most; what is written beyond them is overwritten
  /// or not used.
  /// @param done the bounces that are there already
  VCAVITY_INLINE void append(const GrooveBatch<Real>& batch, std::size_t lane, int done) {
    const int size = std::min(batch.bounces_of(lane) - done, static_cast<int>(lanes));
    const Lanes turns = Real(2) * lane_numbers() + Lanes(Real(2 * done + 1));
    const Lanes angles = Lanes(batch.elevation[lane]) - batch.half_aperture[lane] * turns;
    std::copy(angles.begin(), angles.end(), &row_[size_]);
    stretches_[stretch_count_++] = {lane, size_, size};
    size_ += static_cast<std::size_t>(size);
  }

  /// Multiplies the reflectances of all bounces of the row into the throughputs, and empties it.
  VCAVITY_INLINE void reflect_row(const Real& cos_eta) {
    for (std::size_t c = 0; c < components; ++c) {
      const auto facet = facet_.template over_directions<lanes>(c);
      Row reflectances;
      for (std::size_t i = 0; i < size_; i += lanes) {
        const Lanes cosine = at_least(cos_eta * detail::acute_cosine(Lanes::load(&row_[i])), Real(0));
        const Lanes reflectance = facet(cosine);
        std::copy(reflectance.begin(), reflectance.end(), &reflectances[i]);
      }
      for (std::size_t i = 0; i < stretch_count_; ++i) {
        const auto& [lane, begin, size] = stretches_[i];
        const Lanes factors =
            select(lane_numbers() < Real(size), Lanes::load(&reflectances[begin]), Lanes(Real(1)));
        throughputs_[c][lane] *= product(factors);
      }
    }
    size_ = 0;
    stretch_count_ = 0;
  }

  /// 0, 1, 2, …
  static Lanes lane_numbers() {
    Lanes result;
    for (std::size_t lane = 0; lane < lanes; ++lane) result[lane] = Real(static_cast<int>(lane));
    return result;
  }

  static Real total(Lanes a) {
    for (std::size_t half = lanes / 2; half > 0; half /= 2)
      for (std::size_t i = 0; i < half; ++i) a[i] += a[i + half];
    return a[0];
  }

  static Real product(Lanes a) {
    for (std::size_t half = lanes / 2; half > 0; half /= 2)
      for (std::size_t i = 0; i < half; ++i) a[i] *= a[i + half];
    return a[0];
  }

  template <class Function>
  static Value value_of(const Function& component) {
    if constexpr (Number<Value>) {
      return component(0);
    } else {
      std::array<Real, components> values;
      for (std::size_t c = 0; c < components; ++c) values[c] = component(c);
      return Value(values);
    }
  }

  const Facet& facet_;
  Row row_{};  // angles of incidence
  std::size_t size_ = 0;
  std::array<Stretch, 2 * lanes> stretches_;
  std::size_t stretch_count_ = 0;
  std::array<Lanes, components> throughputs_;  // a lane for each groove of the batch
};

}  // namespace vcavity
