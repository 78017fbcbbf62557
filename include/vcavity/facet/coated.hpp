// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Thin films on a facet: any number of dielectric, absorbing or metal films on a substrate.
///
/// Method. Indices n_j (complex) are relative to the incident medium, thicknesses d_j are in wavelengths of
/// that medium. With c and s² as in fresnel.hpp, q_j the normal component of the wave vector in medium j, X =
/// q for s and q/n² for p light, the stack seen from above has the admittance X = c + u/B. From the substrate
/// up,
///
///     u = X − c, B = 1,                          X − c = m/(q + c) for s, m (s²/n² − c²)/(q + c n²) for p;
///     t = G (u + (X_j + c) B),                   w = 4πi d_j q_j, G = −2πi d_j (e^w − 1)/w · (n_j² for p);
///     u ← e^w u + (X_j − c) t,  B ← e^w B + t;
///     r_s = −u/(u + 2cB), r_p = u/(u + 2cB).
///
/// It is the recursion of the characteristic matrix (Abelès 1950; Born & Wolf, "Principles of Optics", 7th
/// ed., §1.6), with the difference u of the admittance to that of the incident medium in place of the
/// admittance, and with e^{w/2} taken out. So nothing overflows in thick or evanescent films, weak contrast
/// keeps its digits, and a film of thickness 0 changes nothing, bit for bit.
///
/// The absorptance is not formed from 1 − |r|². The flux Re((u + cB) B*) at the top is that into the
/// substrate, Re X, times the |e^w| of all films, plus what films absorb, times the |e^w| of those above:
/// sums of what is not negative, from the mean squares of the field in a film. So it keeps its digits where R
/// is close to 1, be it that a mirror of many films absorbs little, and is 0 in total reflection.
///
/// The sign of r_p is the one that makes r_p = r_s at normal incidence; the phase is that at the top of the
/// stack.
///
/// Range: |n + ik| of films and substrate between 1e-4 and 1e4, thickness up to 1e6 wavelengths; cosines as
/// in interface.hpp.
///
/// Not for films so thick or rough that they reflect incoherently, for an absorbing incident medium, gain (k
/// < 0) or anisotropic films.

#include <array>
#include <cmath>
#include <complex>
#include <concepts>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "vcavity/facet/fresnel.hpp"
#include "vcavity/facet/interface.hpp"
#include "vcavity/numbers/complex.hpp"
#include "vcavity/numbers/components.hpp"
#include "vcavity/numbers/elementary.hpp"
#include "vcavity/numbers/invalid_argument.hpp"
#include "vcavity/numbers/number.hpp"
#include "vcavity/numbers/pack.hpp"
#include "vcavity/numbers/per_component.hpp"

namespace vcavity {

namespace detail {

/// Throws std::invalid_argument unless every component of `a` is in [low, high].
template <class Value>
void require_range(const Value& a, const scalar_t<Value>& low, const scalar_t<Value>& high,
                   const char* name) {
  using Real = scalar_t<Value>;
  for_each_component(a, [&](const Real& x) {
    if (!(x >= low && x <= high)) {
      throw_invalid_argument(name, " must lie in [", low, ", ", high, "], not be ", x);
    }
  });
}

/// A medium of a stack: n², the contrast n² − 1, which alone would lose digits where n is small, and 1/n².
template <class Value>
struct Medium {
  using Real = scalar_t<Value>;

  /// @param interface to the medium, such as `Conductor`
  /// @throws std::invalid_argument when |n + ik| is not in [1e-4, 1e4]: between such media no product
  /// overflows, see `StackedWave`
  template <class Interface>
  explicit Medium(const Interface& interface) : contrast(as_complex(interface.contrast())) {
    using std::sqrt;
    squared_index = {interface.permittivity(), contrast.im};
    const Value index = sqrt(sqrt(norm(squared_index)));
    require_range(index, Real(1e-4L), Real(1e4L), "the refractive index |n + ik| in a stack of films");
    inverse = Complex<Value>{Value(1), Value(0)} / squared_index;
  }

  /// The same medium in another number type, or for a `Pack` of equal components.
  template <class Other>
  Medium<Other> in() const {
    const auto converted = [](const Complex<Value>& z) {
      return Complex<Other>{static_cast<Other>(z.re), static_cast<Other>(z.im)};
    };
    return {converted(contrast), converted(squared_index), converted(inverse)};
  }

  Complex<Value> contrast, squared_index, inverse;

 private:
  template <class Other>
  friend struct Medium;

  Medium(const Complex<Value>& m, const Complex<Value>& n2, const Complex<Value>& of_n2)
      : contrast(m), squared_index(n2), inverse(of_n2) {}
};

/// A wave in a medium of a stack.
template <class Value>
struct MediumWave : RefractedWave<Value> {
  using Real = scalar_t<Value>;
  using RefractedWave<Value>::c, RefractedWave<Value>::s2;

  /// @param cos_theta_i cosine of the angle of incidence
  template <class Cosine>
  VCAVITY_INLINE MediumWave(const Medium<Value>& medium, const Cosine& cos_theta_i)
      : RefractedWave<Value>(medium.squared_index.re, medium.contrast, cos_theta_i) {
    const Complex<Value>& q = this->w;
    sum_s = {q.re + c, q.im};
    excess_s = medium.contrast / sum_s;
    const Complex<Value> cn2 = c * medium.squared_index, difference = q - cn2;
    sum_p = q + cn2;
    // (q − c n²)/n², or where q and c n² are close to each other the same from the contrast.
    const Complex<Value> bracket{s2 * medium.inverse.re - c * c, s2 * medium.inverse.im};
    const Complex<Value> near = medium.contrast * bracket / sum_p, far = difference * medium.inverse;
    const mask_t<Value> is_far = Value(Real(4) * norm(difference) - norm(q) - norm(cn2)) >= Real(0);
    excess_p = {select(is_far, far.re, near.re), select(is_far, far.im, near.im)};
  }

  Complex<Value> sum_s, sum_p;        ///< X + c for s, (X + c) n² for p light
  Complex<Value> excess_s, excess_p;  ///< X − c
};

/// Whether the flux through a stack is followed too.
enum class Tracked { amplitudes, flux };

/// How light of one polarisation sees the part of a stack that is done: its admittance is c + u/B.
template <class Value>
struct StackedWave {
  using Real = scalar_t<Value>;

  Complex<Value> u;
  Complex<Value> b;
  Value flux;   ///< Re (u + cB)B*, but for the factor e^depth
  Value depth;  ///< not positive
  Value c;      ///< cosine of the angle of incidence

  /// Adds a film on top.
  /// @param e e^w
  /// @param t G (u + (X + c) B)
  /// @param excess X − c
  VCAVITY_INLINE void add(const Complex<Value>& e, const Complex<Value>& t, const Complex<Value>& excess) {
    u = e * u + excess * t;
    b = e * b + t;
    keep_finite();
  }

  /// u + cB, the field that B is not: magnetic for s, electric for p light.
  VCAVITY_INLINE Complex<Value> other_field() const { return u + c * b; }

  /// Adds to the flux what the next film absorbs.
  /// @param absorbed ≥ 0
  /// @param decay Re w ≤ 0
  /// @param transparent set where the film does not absorb
  void add_flux(const Value& absorbed, const Value& decay, const mask_t<Value>& transparent) {
    depth = depth + decay;
    const Value here = flux * exponential(depth) + absorbed;
    flux = select(transparent, flux, here);
    depth = select(transparent, depth, Value(0));
  }

  /// u + 2cB
  VCAVITY_INLINE Complex<Value> sum() const { return u + Real(2) * c * b; }

  /// |r|²
  VCAVITY_INLINE Value reflectance() const { return norm(u) / norm(sum()); }

  /// 1 − |r|²
  Value absorptance() const {
    return at_most(Value(Real(4) * (c * flux) / norm(sum()) * exponential(depth)), Real(1));
  }

 private:
  /// In mirrors of many films u and B grow without limit. The factor is a power of two: no digit changes.
  VCAVITY_INLINE void keep_finite() {
    using std::ldexp;
    constexpr int doublings = std::numeric_limits<Real>::max_exponent / 4;
    const Real large = ldexp(Real(1), 2 * doublings);
    const Value factor(ldexp(Real(1), -doublings));
    const Value scale = select(Value(large) - norm(u) - norm(b) >= Real(0), Value(1), factor);
    u = scale * u;
    b = scale * b;
    flux = scale * scale * flux;
  }
};

/// s and p light in a stack.
template <class Value>
struct StackedWaves {
  StackedWave<Value> s, p;
};

/// How a wave of normal component q passes a film.
template <class Value>
struct FilmPassage {
  using Real = scalar_t<Value>;

  /// @param film_turn 4π times the thickness in wavelengths
  /// @param q of the wave in the film
  VCAVITY_INLINE FilmPassage(const Value& film_turn, const Complex<Value>& q)
      : turn(film_turn), w{-(turn * q.im), turn * q.re} {
    // e^w − 1 from sines and cosines of half the angle: no cancellation.
    const Value half = Real(0.5) * w.im;
    const auto [sin_half, cos_half] = sine_and_cosine(half);
    one_less_cosine = Real(2) * (sin_half * sin_half);
    lost = exponential_less_one(w.re);
    sine_of_turn = Real(2) * (sin_half * cos_half);
    change = {lost * (Value(1) - one_less_cosine) - one_less_cosine, (Value(1) + lost) * sine_of_turn};
  }

  /// e^w
  VCAVITY_INLINE Complex<Value> factor() const { return {Value(1) + change.re, change.im}; }

  /// G of s light, −½ i turn (e^w − 1)/w; where w is too small to be divided by, its limit.
  VCAVITY_INLINE Complex<Value> g() const {
    const Complex<Value> mean = divided_by_w(change, Value(1));
    const Value half_turn = Real(0.5) * turn;
    return {half_turn * mean.im, -(half_turn * mean.re)};
  }

  /// x/w, or `limit` where w is too small.
  VCAVITY_INLINE Complex<Value> divided_by_w(const Complex<Value>& x, const Value& limit) const {
    const Value w_norm = norm(w);
    const Real smallest = smallest_cosine<Real>() * smallest_cosine<Real>();
    const mask_t<Value> is_small = Value(smallest) >= w_norm;
    const Complex<Value> ratio = Value(Value(1) / at_least(w_norm, smallest)) * (x * conj(w));
    return {select(is_small, limit, ratio.re), select(is_small, Value(0), ratio.im)};
  }

  Value turn;
  Complex<Value> w;
  Value one_less_cosine, sine_of_turn;  ///< of the real phase Im w
  Value lost;                           ///< e^{Re w} − 1
  Complex<Value> change;                ///< e^w − 1
};

/// The means of |cos|², |sin|² and cos sin* of the phase across a film, times 2 e^{Re w}, and in part divided
/// by q: a field a cos + b q sin has the mean square ½(|a|² cosines + |b|² |q|² sines + 2 Re a b* q*
/// products). That of sines is a difference which nearly cancels in thin films; there it is summed as a
/// series.
template <class Value>
struct FilmMeans {
  using Real = scalar_t<Value>;

  explicit FilmMeans(const FilmPassage<Value>& film) {
    const Value one(1), decay = -film.w.re, phase = film.w.im, left = one + film.lost;
    const auto over = [](const Value& x, const Value& y, const Value& limit) {
      const Real smallest = smallest_cosine<Real>();
      return select(Value(smallest) >= y, limit, Value(x / at_least(y, smallest)));
    };
    // e^{−A} sinh A/A, e^{−A} sin P/P, and with 1 − cos P and 1 − cosh A in place of the sines.
    const Value sinh_mean = over(Value(Real(-0.5) * (film.lost * (one + left))), decay, one);
    const Value sin_mean = over(Value(left * film.sine_of_turn), phase, left);
    cosines = sinh_mean + sin_mean;
    products = {over(Value(left * film.one_less_cosine), phase, Value(0)),
                Real(-0.5) * over(Value(film.lost * film.lost), decay, Value(0))};

    // Σ (A^{2j} − (−P²)^j)/(2j + 1)! over |w|² = A² + P², for A and P up to 1.
    constexpr int terms = 2 + std::numeric_limits<Real>::digits10 / 2;
    const Value a = at_most(decay, Real(1)), p = at_most(phase, Real(1));
    const Value a2 = a * a, p2 = -(p * p);
    Value power = one, quotient = one, series(0);
    Real factor(1);
    for (int j = 1; j <= terms; ++j) {
      factor = factor / static_cast<Real>(2 * j * (2 * j + 1));
      series = series + factor * quotient;
      power = power * a2;
      quotient = power + p2 * quotient;
    }
    const Value w_norm = norm(film.w);
    const Value by_difference = (sinh_mean - sin_mean) / at_least(w_norm, Real(1));
    sines = select(one >= w_norm, Value(left * series), by_difference);
  }

  Value cosines;
  Value sines;  ///< over |w|²
  Complex<Value> products;
};

}  // namespace detail

/// A homogeneous film of a stack.
/// @tparam Value a number, or a `glm::vec` or `Pack` with one value per colour or wavelength
template <class Value>
class Film {
 public:
  using Real = scalar_t<Value>;

  /// None: a film without thickness.
  Film() : Film(Value(1), Value(0), Value(0)) {}

  /// @param n real part of the refractive index relative to the incident medium, ≥ 0
  /// @param k extinction coefficient, ≥ 0, |n + ik| in [1e-4, 1e4]
  /// @param thickness in wavelengths of the incident medium, in [0, 1e6]
  /// @throws std::invalid_argument when a component is out of range or not a number, naming it
  Film(const Value& n, const Value& k, const Value& thickness) : Film(Conductor<Value>(n, k), thickness) {}

  /// The same from n − 1, for indices so close to 1 that n itself cannot carry the difference.
  static Film from_contrast(const Value& n_minus_1, const Value& k, const Value& thickness) {
    return Film(Conductor<Value>::from_contrast(n_minus_1, k), thickness);
  }

  /// The same with lengths.
  /// @param thickness_nm thickness, ≥ 0
  /// @param wavelength_nm wavelength in the incident medium, > 0, one for each component
  /// @param n real part of the refractive index, relative to the incident medium
  /// @param k extinction coefficient, ≥ 0
  static Film of_thickness_nm(const Value& n, const Value& k, const Real& thickness_nm,
                              const Value& wavelength_nm) {
    constexpr Real most = std::numeric_limits<float>::max();
    detail::require_range(thickness_nm, Real(0), most, "the thickness of a film in nm");
    detail::require_range(wavelength_nm, Real(std::numeric_limits<float>::min()), most, "a wavelength in nm");
    return Film(n, k, Value(thickness_nm) / wavelength_nm);
  }

  /// (n + ik)² − 1
  Complex<Value> contrast() const { return medium_.contrast; }

  /// Whether there is anything of it, in some component.
  bool present() const { return largest(thickness_) > Real(0); }

  /// The same film in another number type, or for a `Pack` of equal components.
  template <class Other>
  Film<Other> in() const
    requires Number<Value>
  {
    return Film<Other>(medium_.template in<Other>(), static_cast<Other>(thickness_));
  }

  /// Puts the film on a stack; for `Coated`.
  /// @param cos_theta_i cosine of the angle of incidence
  /// @param waves the light in the stack below
  template <detail::Tracked tracked, class Cosine>
  VCAVITY_INLINE void add_to(detail::StackedWaves<Value>& waves, const Cosine& cos_theta_i) const {
    const detail::MediumWave<Value> wave(medium_, cos_theta_i);
    const detail::FilmPassage<Value> film(Real(4) * pi<Real>() * thickness_, wave.w);
    if constexpr (tracked == detail::Tracked::flux) add_flux_to(waves, wave, film);
    const Complex<Value> e = film.factor(), g = film.g();
    waves.s.add(e, g * (waves.s.u + wave.sum_s * waves.s.b), wave.excess_s);
    waves.p.add(e, g * (medium_.squared_index * waves.p.u + wave.sum_p * waves.p.b), wave.excess_p);
  }

 private:
  template <class Other>
  friend class Film;

  // The flux grows through the film by 2π Im n² ∫|B|² for s, and by 2π Im n² ∫(|U|² + s²|B/n²|²) for p light,
  // with U = u + cB and B = B cos − i (U/X) sin, U = U cos − i X B sin of the phase 2π q z.
  void add_flux_to(detail::StackedWaves<Value>& waves, const detail::MediumWave<Value>& wave,
                   const detail::FilmPassage<Value>& film) const {
    const detail::FilmMeans<Value> means(film);
    // |a cos + b sin|² of fields b = −i b_q q and, below, b = −i b_1.
    const Value sines_q = film.turn * film.turn * means.sines;
    const Complex<Value> over_w = film.divided_by_w(conj(means.products), Value(0));
    const Complex<Value> products_q{-(film.turn * over_w.im), -(film.turn * over_w.re)};  // products/q*
    const auto mean_square = [](const Complex<Value>& a, const Complex<Value>& b, const Value& cosines,
                                const Value& sines, const Complex<Value>& products) {
      return norm(a) * cosines + norm(b) * sines - Real(2) * (a * conj(b) * products).im;
    };
    const Value strength = Real(0.25) * (film.turn * medium_.contrast.im);

    const Complex<Value> u_s = waves.s.other_field(), u_p = waves.p.other_field();
    const Value s = mean_square(waves.s.b, u_s, means.cosines, sines_q, products_q);
    const Value sines = norm(film.w) * means.sines;
    const Value along =
        mean_square(u_p, medium_.inverse * wave.w * waves.p.b, means.cosines, sines, means.products);
    const Value across =
        mean_square(waves.p.b, medium_.squared_index * u_p, means.cosines, sines_q, products_q);
    const mask_t<Value> transparent = Value(-medium_.contrast.im) >= Real(0);
    waves.s.add_flux(strength * at_least(s, Real(0)), film.w.re, transparent);
    waves.p.add_flux(strength * at_least(Value(along + wave.s2 * norm(medium_.inverse) * across), Real(0)),
                     film.w.re, transparent);
  }

  Film(const detail::Medium<Value>& medium, const Value& thickness)
      : medium_(medium), thickness_(thickness) {}

  Film(const Conductor<Value>& interface, const Value& thickness)
      : medium_(interface), thickness_(thickness) {
    detail::require_range(thickness, Real(0), Real(1e6L), "the thickness of a film in wavelengths");
  }

  detail::Medium<Value> medium_;
  Value thickness_;
};

/// A facet under thin films.
///
///     const Conductor<double> titanium(2.54, 3.43);
///     const auto oxide = Film<double>::of_thickness_nm(2.4, 0.0, 60.0, 550.0);
///     const Coated anodised(titanium, oxide);
///
/// @tparam Substrate what lies under the films: `Conductor` or `Dielectric`
/// @tparam max_films how many films there is room for. The default is for films that are counted at run time:
/// they are kept in a std::vector, allocated when the facet is made or copied.
template <class Substrate, std::size_t max_films = std::dynamic_extent>
class Coated {
 public:
  using Value = std::remove_cvref_t<decltype(std::declval<const Substrate&>().permittivity())>;
  using Real = scalar_t<Value>;

  /// @param substrate of an index relative to the incident medium, |n + ik| in [1e-4, 1e4]
  /// @param films the top one first. Those without thickness are left out, and without any the facet is the
  /// substrate, bit for bit
  /// @throws std::invalid_argument when there is no room for so many films, or when the index of the
  /// substrate is out of range
  Coated(const Substrate& substrate, std::span<const Film<Value>> films)
      : substrate_(substrate), medium_(substrate) {
    for (const Film<Value>& film : films)
      if (film.present()) add(film);
  }

  /// The same with a number of films that is known.
  template <class... Films>
    requires(sizeof...(Films) > 0 && (std::same_as<Films, Film<Value>> && ...))
  explicit Coated(const Substrate& substrate, const Films&... films)
      : Coated(substrate, std::array<Film<Value>, sizeof...(Films)>{films...}) {}

  /// Reflectance of unpolarised light, (|r_s|² + |r_p|²)/2, in [0, 1].
  /// @param cos_theta_i cosine of the angle of incidence in [0, 1]
  template <CosineFor<Value> Cosine>
  Value operator()(const Cosine& cos_theta_i) const {
    if (count_ == 0) return substrate_(cos_theta_i);
    const detail::StackedWaves<Value> waves = stacked<detail::Tracked::amplitudes>(cos_theta_i);
    return at_most(Value(Real(0.5) * (waves.s.reflectance() + waves.p.reflectance())), Real(1));
  }

  /// What is not reflected of unpolarised light: absorbed in films and substrate, or refracted into a
  /// transparent substrate. To full relative precision.
  /// @param cos_theta_i cosine of the angle of incidence in [0, 1]
  template <CosineFor<Value> Cosine>
  Value absorptance(const Cosine& cos_theta_i) const {
    const Absorptances<Value> part = absorptances(cos_theta_i);
    return Real(0.5) * (part.s + part.p);
  }

  /// The same for s and for p light.
  /// @param cos_theta_i cosine of the angle of incidence in [0, 1]
  template <CosineFor<Value> Cosine>
  Absorptances<Value> absorptances(const Cosine& cos_theta_i) const {
    if (count_ == 0) return substrate_.absorptances(cos_theta_i);
    const detail::StackedWaves<Value> waves = stacked<detail::Tracked::flux>(cos_theta_i);
    return {waves.s.absorptance(), waves.p.absorptance()};
  }

  /// Amplitudes r_s and r_p, with the phase at the top of the stack.
  /// @param cos_theta_i cosine of the angle of incidence in [0, 1]
  template <CosineFor<Value> Cosine>
  Amplitudes<Value> amplitudes(const Cosine& cos_theta_i) const {
    if (count_ == 0) return substrate_.amplitudes(cos_theta_i);
    const detail::StackedWaves<Value> waves = stacked<detail::Tracked::amplitudes>(cos_theta_i);
    const Complex<Value> minus_u{-waves.s.u.re, -waves.s.u.im};
    return {minus_u / waves.s.sum(), waves.p.u / waves.p.sum()};
  }

  /// That of the substrate: the field in a film depends on the square of q alone, and so has none of its own.
  Value critical_cosine() const { return substrate_.critical_cosine(); }

  /// The complex cosines at which the reflectance is singular whatever the films are, up to conjugation: the
  /// branch points of the substrate. Quadrature wants to know them.
  std::array<std::complex<double>, 2> singular_cosines() const
    requires Number<Value>
  {
    const Complex<Value>& m = medium_.contrast;
    const std::complex<double> branch =
        std::sqrt(-std::complex<double>(static_cast<double>(m.re), static_cast<double>(m.im)));
    return {branch, -branch};
  }

  /// The facet without films.
  const Substrate& substrate() const { return substrate_; }

  /// The same facet in another number type, or for a `Pack` of equal components.
  template <class Other>
  auto in() const
    requires Number<Value>
  {
    using Facet = decltype(substrate_.template in<Other>());
    std::vector<Film<Other>> films;
    for (const Film<Value>& film : this->films()) films.push_back(film.template in<Other>());
    return Coated<Facet, max_films>(substrate_.template in<Other>(), films);
  }

  /// The same facet for several directions at once: it takes a `Pack` of cosines.
  template <std::size_t directions>
  auto over_directions() const
    requires Number<Value>
  {
    return in<Pack<Real, directions>>();
  }

 private:
  std::span<const Film<Value>> films() const { return {films_.data(), count_}; }

  void add(const Film<Value>& film) {
    if constexpr (max_films == std::dynamic_extent) {
      films_.push_back(film);
    } else {
      if (count_ == max_films)
        throw_invalid_argument("more films than there is room for, which is ", max_films);
      films_[count_] = film;
    }
    ++count_;
  }

  template <detail::Tracked tracked, class Cosine>
  detail::StackedWaves<Value> stacked(const Cosine& cos_theta_i) const {
    const detail::MediumWave<Value> wave(medium_, cos_theta_i);
    const Complex<Value> one{Value(1), Value(0)};
    // Re X of q/n² is Re q (|q|² + s²)/|n²|²: no cancellation in metals.
    const Value flux_p = wave.w.re * (wave.w_norm + wave.s2) * norm(medium_.inverse);
    detail::StackedWaves<Value> waves{{wave.excess_s, one, wave.w.re, Value(0), wave.c},
                                      {wave.excess_p, one, flux_p, Value(0), wave.c}};
    for (std::size_t i = count_; i-- > 0;) films_[i].template add_to<tracked>(waves, cos_theta_i);
    return waves;
  }

  Substrate substrate_;
  detail::Medium<Value> medium_;  // of the substrate
  std::conditional_t<max_films == std::dynamic_extent, std::vector<Film<Value>>,
                     std::array<Film<Value>, max_films == std::dynamic_extent ? 1 : max_films>>
      films_;
  std::size_t count_ = 0;
};

template <class Substrate, class... Films>
  requires(sizeof...(Films) > 0)
Coated(const Substrate&, const Film<Films>&...) -> Coated<Substrate, sizeof...(Films)>;

template <class Substrate, class Films>
  requires requires(const Films& films) { films.size(); }
Coated(const Substrate&, const Films&) -> Coated<Substrate>;

}  // namespace vcavity
