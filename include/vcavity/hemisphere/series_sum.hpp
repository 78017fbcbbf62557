// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The sum of a bounce series (bounce_series.hpp) along one direction: followed bounce by bounce at first, and many
/// bounces at once as soon as that pays.
///
/// Method. From m − 2 to m bounces the product of reflectances gains a factor at either end. Products that are numbers
/// go on in blocks (long_series.hpp). Fields are followed as Jones matrices until their planes of incidence turn slowly;
/// then s and p light go on as numbers (turning_fields.hpp). A series ends when no light to speak of is left, or when
/// none will be lost any more.

#include <algorithm>
#include <concepts>
#include <limits>
#include <type_traits>
#include <utility>

#include "vcavity/facet/facet.hpp"
#include "vcavity/hemisphere/bounce_series.hpp"
#include "vcavity/hemisphere/long_series.hpp"
#include "vcavity/hemisphere/turning_fields.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/polarization/jones.hpp"

namespace vcavity::detail {

/// Upper bound on the part of unpolarised light that a way leaves over, and so on what any longer way does.
template <class Value>
auto light_left(const Value& throughput) {
  return largest(throughput);
}
template <class Value>
auto light_left(const Jones<Value>& throughput) {
  const auto element = largest(throughput);
  return scalar_t<Value>(4) * element * element;  // ½‖J‖² of eight numbers
}
template <class Value>
auto light_left(const EndPolarizations<Value>& light) {
  return scalar_t<Value>(4) * largest(light);
}

/// A value that knows how many bounces it is the product of: bounces that reflect all light change it all the same.
template <class Throughput>
concept CountsBounces = requires(const Throughput& throughput) { throughput.bounces; };

/// The sum of a series for one ψ, or a pack of them.
template <class Value, class Real>
struct SeriesValue {
  Value value;
  Real left_out;  ///< bound on the error of what has been left out
};

/// What of a series need not be followed.
template <class Real>
struct SeriesLimits {
  Real negligible;   ///< the last part, when less light than this is left
  Real total_below;  ///< bounces whose cosine of incidence is below: they reflect all light
  int max_terms;     ///< what comes after as many bounces as this
  bool is_smooth;    ///< whether the facet is, as it is without a critical angle
};

/// The bounces at either end of rays, for one direction along the groove or a pack of them.
template <class Real, class Facet, class Reals>
class EndBounces {
 public:
  using Throughput = value_t<Facet, Reals>;

  /// @param facet must outlive the bounces
  /// @param sine, cosine of ψ
  EndBounces(const Facet& facet, const Reals& sine, const Reals& cosine)
      : facet_(&facet), sine_(sine), cosine_(cosine) {}

  // Bounces alternate between the panels; by symmetry it does not matter on which they begin.
  Bounce<Reals> first(const RayEnds<Real>& ends, int m) const {
    return {ends.cosine_first * cosine_, -ends.sine_first * cosine_, sine_, panel(m / 2), 1};
  }
  Bounce<Reals> last(const RayEnds<Real>& ends, int m) const {
    return {ends.cosine_last * cosine_, -ends.sine_last * cosine_, sine_, panel(m / 2 + m - 1), 1};
  }
  Throughput reflection(const Bounce<Reals>& bounce) const { return reflect(*facet_, bounce); }

  /// From m − 2 to m bounces.
  struct Step {
    Throughput first, last;
  };
  Step step(const RayEnds<Real>& ends, int m) const {
    return {reflection(first(ends, m)), m == 1 ? Throughput(1) : reflection(last(ends, m))};
  }
  static Throughput growth(const Step& step) { return step.first * step.last; }
  /// The product for m bounces from that for m − 2, which below 1 is none.
  static Throughput grown(const Throughput& product, const Step& step, int m) {
    if (m == 1) return step.first;
    return m == 2 ? Throughput(step.first * step.last) : Throughput(step.first * product * step.last);
  }
  static auto light(const Throughput& product, const Step&) { return unpolarized(power(product)); }

  /// Whether many bounces can be done at once.
  static constexpr bool in_blocks =
      PlainNumbers<Throughput>::count > 0 &&
      std::is_floating_point_v<Real>&& std::invocable<const Facet&, const Reals&>;
  /// Whether the light is more or less than the product.
  static constexpr bool is_observed_in_part = false;

 private:
  static Panel panel(int parity) { return parity % 2 == 0 ? Panel::one : Panel::two; }

  const Facet* facet_;
  Reals sine_, cosine_;
};

/// The same for fields whose planes of incidence turn slowly, in units of those that are kept.
template <class Real, class Facet, class Reals>
class TurningEndBounces {
 public:
  using Throughput = EndPolarizations<Reals>;
  using Fields = EndBounces<Real, Facet, Reals>;

  /// @param fields, series must outlive the bounces
  TurningEndBounces(const Fields& fields, const BounceSeries<Real>& series)
      : fields_(&fields), series_(&series) {}

  /// From m − 2 to m bounces.
  struct Step {
    TurningBounce<Reals> first, last;
  };
  Step step(const RayEnds<Real>& ends, int m) const {
    return {turning(fields_->first(ends, m)), turning(fields_->last(ends, m))};
  }
  static Throughput growth(const Step& step) {
    const auto& [first, last] = step;
    return {first.s * last.s, first.s * last.p, first.p * last.s, first.p * last.p};
  }
  static Throughput grown(const Throughput& product, const Step& step, int) { return product * growth(step); }
  static Throughput observed(const Throughput& product, const Step& step) {
    return Reals(step.first.power * step.last.power) * product;
  }
  static auto light(const Throughput& product, const Step& step) {
    return unpolarized(observed(product, step));
  }
  static constexpr bool in_blocks = PlainNumbers<Throughput>::count > 0 && std::is_floating_point_v<Real>;
  static constexpr bool is_observed_in_part = true;

  /// The light of a field after m bounces.
  Throughput light_of(const typename Fields::Throughput& way, int m) const {
    const RayEnds<Real> beyond = series_->ends(Real(m));  // half a step
    const Bounce<Reals> first = fields_->first(beyond, m), last = fields_->last(beyond, m);
    const TurningBounce<Reals> at_first = turning(first), at_last = turning(last);
    return Reals(Reals(Real(1)) / (at_first.unit * at_last.unit)) *
           by_end_polarizations(way, KeptFields<Reals>(at_first, first, false),
                                KeptFields<Reals>(at_last, last, true));
  }

  /// Bound on the relative error of the light that goes on like this.
  /// @param light that got here
  /// @param here the step to here
  static Reals uncertain(const Throughput& light, const Step& here) {
    using std::sqrt;
    const Reals mixing = select(here.first.mixing >= here.last.mixing, here.first.mixing, here.last.mixing);
    const Reals changed =
        sqrt((light.sp + light.ps) / at_least(unpolarized(light), smallest_divisor<Real>()));
    // Twice the worst found over random grooves.
    constexpr Real of_change = Real(60), of_interference = Real(10);
    return at_most(Reals(mixing * (of_interference * changed + Reals(of_change * mixing) * mixing)), Real(1));
  }

  /// Estimate of the sum of the terms after m bounces.
  /// @param light that got here
  /// @param here the step to here
  /// @param weight of the last terms
  /// @param rest of the weights
  Reals light_after(const Throughput& light, const Step& here, int m, const Real& weight,
                    const Real& rest) const {
    const Throughput factor = growth(here);
    const Reals most = select(factor.ss >= factor.pp, factor.ss, factor.pp);
    if (series_->is_single()) {
      // A loss in proportion to the cosine of incidence is at least half as large, in the mean over what follows.
      const Real steps = Real(series_->size() - m) / Real(4);
      return unpolarized(light) * transformed(most, [&](const Real& a) {
               using std::pow;
               return Real(pow(a, steps));
             });
    }
    constexpr Real later = Real(2);  // so much less is lost towards grazing incidence
    const Reals terms =
        Reals(later) / at_least(Reals(Reals(Real(1)) - most), std::numeric_limits<Real>::epsilon());
    // Weights grow like m.
    const Reals weights = weight * (terms + (Real(2) / Real(m)) * (terms * terms));
    return unpolarized(light) * at_most(weights, rest);
  }

 private:
  TurningBounce<Reals> turning(const Bounce<Reals>& bounce) const {
    return turning_bounce(fields_->reflection(bounce), bounce, series_->aperture());
  }

  const Fields* fields_;
  const BounceSeries<Real>* series_;
};

/// How many terms can be done at once after m bounces: the logarithm of half of them, or less than `min_block_log2`.
/// @param most the last term of the block at most
/// @param growth factor from m − 2 to m bounces
/// @param product of m bounces
/// @param negligible lanes with less light do not matter
template <class Value, class Real>
int block_after(int m, int most, Value growth, Value product, const Real& negligible) {
  using std::log;
  int count = std::min(m, most - m) / 2;
  constexpr Real largest_fall = Real(8);  // of the logarithm; the rules for sums are good for that
  for (std::size_t lane = 0; lane < PlainNumbers<Value>::count; ++lane) {
    if (PlainNumbers<Value>::at(product, lane) < negligible) continue;
    const Real fall = -log(at_least(PlainNumbers<Value>::at(growth, lane), std::numeric_limits<Real>::min()));
    if (fall * Real(count) > largest_fall) count = static_cast<int>(largest_fall / fall);
  }
  int log2 = 0;
  while (log2 < max_block_log2 && 2 << log2 <= count) ++log2;
  return log2;
}

/// Adds the terms of a series after m bounces to a sum.
/// @param m an even number of bounces
/// @param bounces at either end
/// @param products for m − 1 and for m bounces
/// @param leave called after even numbers of bounces with their number and the products; true ends the series
template <class Real, class Bounces, class Sum, class Leave>
void follow(const BounceSeries<Real>& series, int m, const Bounces& bounces,
            SeriesProducts<typename Bounces::Throughput> products, const SeriesLimits<Real>& limits,
            SeriesValue<Sum, Real>& result, Leave&& leave) {
  using Throughput = typename Bounces::Throughput;
  int next_block = 64, most_log2 = max_block_log2;  // when it pays to do many bounces at once, and how many
  for (++m; m <= series.size(); ++m) {
    const auto term = series[m];
    Throughput& product = m % 2 == 1 ? products.of_odd : products.of_even;
    const auto step = bounces.step(term.ends, m);
    product = Bounces::grown(product, step, m);
    result.value = result.value + scaled(term.weight, Bounces::light(product, step));
    if (m % 2 == 1 || m == series.size()) continue;

    const Real odd_rest = series[m - 1].rest;
    const Real left =
        Real(light_left(products.of_odd)) * odd_rest + Real(light_left(products.of_even)) * term.rest;
    const bool is_total = !CountsBounces<Throughput> && series[m - 1].ends.cosine_first <= limits.total_below;
    if (is_total || left <= limits.negligible || m >= limits.max_terms) {
      result.value = result.value + scaled(odd_rest, Bounces::light(products.of_odd, step)) +
                     scaled(term.rest, Bounces::light(products.of_even, step));
      if (!is_total) result.left_out += left;
      return;
    }
    if (leave(m, products)) return;
    if constexpr (Bounces::in_blocks) {
      if (m < next_block) continue;
      const int log2 = std::min(
          most_log2, block_after(m, series.unclipped(), Bounces::growth(step), product, limits.negligible));
      next_block = m + 16;
      if (log2 < min_block_log2) continue;
      const auto block = sum_of_block<Bounces, Real>(
          m, log2, [&](const Real& k) { return bounces.step(series.ends(k), 2); },
          [&](const Real& count) { return series.smooth_weight(count); }, products);
      const Real error = block.uncertain * (odd_rest + term.rest);
      constexpr Real small = Real(0.01);
      // Rounding of reflectances does as much, at 8 ε in either of two.
      const Real rounding = Real(16) * Real(2 << log2) * std::numeric_limits<Real>::epsilon() * left;
      if (!(error <= at_least(Real(small * limits.negligible), rounding))) {
        most_log2 = std::max(log2 - 1, min_block_log2);
        continue;
      }
      most_log2 = log2 + 1;
      result.value = result.value + unpolarized(power(block.value));
      result.left_out += error;
      products = block.products;
      m += 2 << log2;
      next_block = m + 2;
    }
  }
}

/// The same for fields, from the first bounce on: as numbers once their planes of incidence turn slowly.
template <class Real, class Facet, class Reals, class Sum>
void follow_fields(const BounceSeries<Real>& series, const EndBounces<Real, Facet, Reals>& fields,
                   const SeriesLimits<Real>& limits, SeriesValue<Sum, Real>& result) {
  using Fields = value_t<Facet, Reals>;
  using Turning = TurningEndBounces<Real, Facet, Reals>;
  const Turning turning(fields, series);
  constexpr int few_bounces = 16;  // that are followed as soon as it is known whether they need not be
  int next_try = 2;
  const auto go_on_as_numbers = [&](int m, const SeriesProducts<Fields>& products) {
    if (!limits.is_smooth || m < next_try || series.size() - m < few_bounces) return false;
    next_try = m + std::max(8, m / 6);
    const SeriesProducts<EndPolarizations<Reals>> light{turning.light_of(products.of_odd, m - 1),
                                                        turning.light_of(products.of_even, m)};
    const auto all = light.of_odd + light.of_even;
    const auto odd = series[m - 1], even = series[m];
    const auto here = turning.step(even.ends, m);
    const Reals uncertain = Turning::uncertain(all, here);
    const Reals left = turning.light_after(all, here, m, odd.weight + even.weight, odd.rest + even.rest);
    constexpr Real share = Real(3);
    if (!(largest(Reals(uncertain * left)) <= share * limits.negligible)) return false;
    SeriesValue<Sum, Real> rest{Sum(0), Real(0)};
    follow(series, m, turning, light, limits, rest, [](int, const auto&) { return false; });
    result.value = result.value + rest.value;
    result.left_out +=
        rest.left_out + largest(Reals(uncertain * select(rest.value >= left, rest.value, left)));
    return true;
  };
  follow(series, 0, fields, SeriesProducts<Fields>{Fields(1), Fields(1)}, limits, result, go_on_as_numbers);
}

/// Σ_m T_m Π_i ρ(cos ψ cos x_i)
/// @param sine, cosine of ψ
template <class Real, class Facet, class Reals>
auto sum_of_series(const BounceSeries<Real>& series, const Facet& facet, const Reals& sine,
                   const Reals& cosine, const SeriesLimits<Real>& all_limits) {
  using Bounces = EndBounces<Real, Facet, Reals>;
  using Throughput = typename Bounces::Throughput;
  using Sum = unpolarized_t<Facet, Reals>;
  SeriesLimits<Real> limits = all_limits;
  limits.total_below = limits.total_below / largest(cosine);
  const Bounces bounces(facet, sine, cosine);
  SeriesValue<Sum, Real> result{Sum(0), Real(0)};
  if constexpr (std::is_same_v<Throughput, Jones<Reals>> && PlainNumbers<Reals>::count > 0) {
    follow_fields(series, bounces, limits, result);
  } else {
    follow(series, 0, bounces, SeriesProducts<Throughput>{Throughput(1), Throughput(1)}, limits, result,
           [](int, const auto&) { return false; });
  }
  return result;
}

}  // namespace vcavity::detail
