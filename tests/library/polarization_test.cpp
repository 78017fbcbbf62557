// SPDX-License-Identifier: BSD-3-Clause
/// Polarisation against fields traced in three dimensions, and against what is known without calculating.

#include <complex>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <random>
#include <vcavity/vcavity.hpp>

#include "support/catch.hpp"
#include "support/reals.hpp"
#include "support/wave.hpp"

using namespace vcavity;
using namespace vcavity::test;

namespace {

/// The wave after its way through the groove between two finite mirrors; no unfolding, no bounce count.
Wave traced(const Cavity<double>& cavity, Wave wave, double position, const std::complex<double>& index,
            int& bounces) {
  Vec3<double> point{0, position * cavity.sin_half(), cavity.cos_half()};
  std::optional<Panel> last;
  for (bounces = 0;; ++bounces) {
    std::optional<Panel> next;
    double distance = std::numeric_limits<double>::infinity();
    for (const Panel panel : {Panel::one, Panel::two}) {
      const double approach = -glm::dot(wave.k, cavity.normal(panel));
      if (panel == last || !(approach > 0)) continue;
      const double way = glm::dot(point, cavity.normal(panel)) / approach;
      const double height = glm::dot(point + way * wave.k, cavity.tangent(panel));
      if (way < distance && height > 0 && height <= 1) {
        distance = way;
        next = panel;
      }
    }
    if (!next) return wave;
    point += distance * wave.k;
    wave = reflected(wave, cavity.normal(*next), index);
    last = next;
  }
}

struct Scene {
  Cavity<double> cavity;
  Vec3<double> e;
  std::complex<double> index;

  Polarized<Conductor<double>> facet() const { return polarized(metal()); }
  Conductor<double> metal() const { return {index.real(), index.imag()}; }
};

template <class Random>
Scene random_scene(Random& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  const bool transparent = unit(random) < 0.3;
  return {Cavity<double>(radians(4 + 176 * unit(random))),
          direction(std::acos(unit(random)), 2 * pi<double>() * unit(random)),
          {0.05 + 4 * unit(random), transparent ? 0 : 5 * unit(random)}};
}

/// The largest difference of two Mueller matrices.
double distance(const Mueller<double>& a, const Mueller<double>& b) {
  double result = 0;
  for (std::size_t row = 0; row < 4; ++row)
    for (std::size_t column = 0; column < 4; ++column)
      result = std::max(result, std::abs(a(row, column) - b(row, column)));
  return result;
}

/// A perfect conductor: no field along its surface.
struct PerfectConductor {
  Amplitudes<double> amplitudes(double) const { return {{-1, 0}, {-1, 0}}; }
};

}  // namespace

TEST_CASE("Stokes parameters leave a groove as fields traced in three dimensions do") {
  std::mt19937_64 random(101);
  std::uniform_real_distribution<double> unit(-1, 1);
  int long_ways = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const Scene scene = random_scene(random);
    const Vec3<double> a = polarization_axis(-scene.e);
    const Vec3<double> b = glm::cross(-scene.e, a);
    const Wave light{-scene.e,
                     along(a, {unit(random), unit(random)}) + along(b, {unit(random), unit(random)})};
    const double position = unit(random);
    int bounces = 0;
    const Wave expected = traced(scene.cavity, light, position, scene.index, bounces);
    const RayPath path = ray_path(scene.cavity, scene.e, position);
    if (path.bounces != bounces) {  // a ray through the edge of an image, within rounding
      CHECK(ray_path(scene.cavity, scene.e, position + 1e-9).bounces !=
            ray_path(scene.cavity, scene.e, position - 1e-9).bounces);
      continue;
    }
    const Stokes<double> out = stokes(expected);
    const Stokes<double> actual = ray_reflectance(scene.cavity, scene.e, path, scene.facet()) * stokes(light);
    CAPTURE(scene.cavity.aperture(), scene.e.x, scene.e.y, scene.e.z, scene.index, bounces);
    for (std::size_t i = 0; i < 4; ++i) CHECK(std::abs(actual[i] - out[i]) <= 1e-11 * out[0] + 1e-300);
    if (bounces > 3) ++long_ways;
  }
  CHECK(long_ways > 300);
}

TEST_CASE("every lobe has its reverse, with the transposed Mueller matrix") {
  std::mt19937_64 random(103);
  int compared = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const Scene scene = random_scene(random);
    for (const auto& lobe : lobes(scene.cavity, scene.e, scene.facet())) {
      if (lobe.weight < 1e-6 || lobe.direction.z < 1e-6) continue;
      const Mueller<double> forth = power(lobe.throughput);
      for (const auto& reverse : lobes(scene.cavity, lobe.direction, scene.facet())) {
        const Vec3<double> difference = reverse.direction - scene.e;
        if (reverse.bounces != lobe.bounces || glm::length(difference) > 1e-9) continue;
        // The axis b is k × a and turns over with k, so U changes its sign in either matrix.
        const double sign[] = {1, 1, -1, 1};
        const Mueller<double> back = power(reverse.throughput);
        for (std::size_t i = 0; i < 4; ++i)
          for (std::size_t j = 0; j < 4; ++j)
            CHECK(std::abs(back(i, j) - sign[i] * sign[j] * forth(j, i)) <= 1e-9 * forth(0, 0));
        ++compared;
      }
    }
  }
  CHECK(compared > 2500);
}

TEST_CASE("across the groove the two polarisations stay apart") {
  std::mt19937_64 random(107);
  for (int trial = 0; trial < 500; ++trial) {
    Scene scene = random_scene(random);
    scene.e = direction(std::acos(scene.e.z), trial % 2 == 0 ? 0.0 : pi<double>());
    scene.e.x = 0;
    const Mueller<double> full = directional_reflectance(scene.cavity, scene.e, scene.facet());
    const SeparatePolarizations<double> apart =
        directional_reflectance(scene.cavity, scene.e, separately_polarized(scene.metal()));
    CHECK(unpolarized(full) == Approx(unpolarized(apart)).epsilon(1e-12));
    // The electric field of s light lies along the groove, which is the axis a.
    CHECK(full(0, 1) == Approx((apart.s - apart.p) / 2).epsilon(1e-10).margin(1e-14 * full(0, 0)));
    CHECK(std::abs(full(0, 2)) <= 1e-14 * full(0, 0));
  }
}

TEST_CASE("unpolarised light keeps its first bounce, whatever the model") {
  std::mt19937_64 random(109);
  for (int trial = 0; trial < 500; ++trial) {
    const Scene scene = random_scene(random);
    const double expected = directional_reflectance(scene.cavity, scene.e, scene.metal(), 1);
    CHECK(unpolarized(directional_reflectance(scene.cavity, scene.e, scene.facet(), 1)) ==
          Approx(expected).epsilon(1e-12));
    CHECK(unpolarized(directional_reflectance(scene.cavity, scene.e, separately_polarized(scene.metal()),
                                              1)) == Approx(expected).epsilon(1e-12));
  }
}

TEST_CASE("a perfect conductor loses no light, and none of its polarisation") {
  std::mt19937_64 random(113);
  for (int trial = 0; trial < 500; ++trial) {
    const Scene scene = random_scene(random);
    CHECK(unpolarized(directional_reflectance(scene.cavity, scene.e, polarized(PerfectConductor{}))) ==
          Approx(1).epsilon(1e-12));
    for (const auto& lobe : lobes(scene.cavity, scene.e, polarized(PerfectConductor{}))) {
      const Mueller<double> m = power(lobe.throughput);
      CHECK(diattenuation(m) < 1e-12);
      CHECK(polarizance(m) < 1e-12);
      // Circular light changes its handedness at every mirror.
      CHECK(m(3, 3) == Approx(lobe.bounces % 2 == 0 ? 1 : -1).epsilon(1e-12));
      CHECK(m(1, 1) == Approx(1).epsilon(1e-12));
    }
  }
}

TEST_CASE("no passive groove brightens any polarisation") {
  std::mt19937_64 random(127);
  for (int trial = 0; trial < 1000; ++trial) {
    const Scene scene = random_scene(random);
    const Mueller<double> m = directional_reflectance(scene.cavity, scene.e, scene.facet());
    CHECK(m(0, 0) * (1 + diattenuation(m)) <= 1 + 1e-14);
    CHECK(diattenuation(m) <= 1);
  }
}

TEST_CASE("at Brewster's angle glass polarises completely") {
  const Cavity<double> flat(pi<double>());
  const Vec3<double> e = direction(std::atan(1.5), radians(90.0));
  const Mueller<double> m = directional_reflectance(flat, e, polarized(Dielectric<double>(1.5)));
  CHECK(polarizance(m) == Approx(1).epsilon(1e-14));
  // Light along the groove: s is across it, the axis b.
  CHECK(m(1, 0) == Approx(-m(0, 0)).epsilon(1e-14));
}

TEMPLATE_LIST_TEST_CASE("where s and p are undefined the field is reflected all the same", "", Reals) {
  using Real = TestType;
  using std::abs;
  const Conductor<Real> metal(Real(1.17), Real(2.4));
  // Along the normal of a panel, and beside it by less and less.
  const Cavity<Real> cavity(radians(Real(100)));
  const Vec3<Real> normal = cavity.normal(Panel::two);
  for (const double tilt : {0.0, 1e-30, 1e-12, 1e-6}) {
    const Vec3<Real> e{Real(tilt), normal.y, normal.z};
    const auto ray = ray_reflectance(cavity, e, RayPath{Panel::two, 1}, polarized(metal));
    CHECK(error_in_epsilons(unpolarized(ray), metal(Real(1))) < 64 + tilt * tilt / epsilon<double>());
    CHECK(polarizance(ray) < 64 * epsilon<Real>() + Real(tilt * tilt));
  }
  // Along the groove.
  for (const double z : {0.0, 1e-30}) {
    const Vec3<Real> e{Real(1), Real(0), Real(z)};
    const Real absorbed = Real(1) - unpolarized(directional_reflectance(cavity, e, polarized(metal)));
    CHECK(abs(absorbed) < Real(64) * epsilon<Real>() + Real(64) * Real(z));
  }
}

TEMPLATE_LIST_TEST_CASE("light almost along the groove has its limit, however small the rest", "",
                        HardwareReals) {
  using Real = TestType;
  using std::abs;
  const Cavity<Real> cavity(radians(Real(50)));
  const auto metal = polarized(Conductor<Real>(Real(1.17), Real(2.4)));
  const auto towards = [](const Real& rest) {
    return Vec3<Real>{Real(1), Real(0.6) * rest, Real(0.8) * rest};
  };
  const Vec3<Real> near = towards(epsilon<Real>() * epsilon<Real>());
  const Vec3<Real> nearest = towards(std::numeric_limits<Real>::min() * Real(1000));  // its square is 0
  const auto limit = directional_reflectance(cavity, near, metal);
  const auto actual = directional_reflectance(cavity, nearest, metal);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) CHECK(abs(actual(i, j) - limit(i, j)) < Real(64) * epsilon<Real>());
  for (const double position : {-0.9, -0.3, 0.2, 0.8}) {
    const RayPath path = ray_path(cavity, nearest, Real(position));
    CHECK(path.first_panel == ray_path(cavity, near, Real(position)).first_panel);
    CHECK(path.bounces == ray_path(cavity, near, Real(position)).bounces);
  }
  const Vec3<Real> axis = polarization_axis(nearest);
  CHECK(abs(axis.y - polarization_axis(near).y) < Real(4) * epsilon<Real>());
  CHECK(abs(axis.z - polarization_axis(near).z) < Real(4) * epsilon<Real>());
}

TEMPLATE_LIST_TEST_CASE("the polarised reflectance in other number types", "", Reals) {
  using Real = TestType;
  const Cavity<Real> cavity(radians(Real(60)));
  const Conductor<Real> silver(Real(0.1249), Real(3.3391));
  const Cavity<Digits50> exact_cavity(radians(Digits50(60)));
  const Conductor<Digits50> exact_silver(Digits50(Real(0.1249)), Digits50(Real(3.3391)));
  const Vec3<Real> e = direction(radians(Real(33)), radians(Real(47)));
  const Vec3<Digits50> exact_e{Digits50(e.x), Digits50(e.y), Digits50(e.z)};
  const auto m = directional_reflectance(cavity, e, polarized(silver));
  const auto exact = directional_reflectance(exact_cavity, exact_e, polarized(exact_silver));
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) CHECK(error_in_epsilons(m(i, j), exact(i, j), 1) < 64);
}

TEST_CASE("colours and packs of wavelengths are polarised one by one") {
  const Cavity<double> cavity(radians(50.0));
  const Vec3<double> e = direction(radians(25.0), radians(65.0));
  using Two = Pack<double, 2>;
  const auto both = directional_reflectance(
      cavity, e, polarized(Conductor<Two>(Two(std::array{0.2, 1.2}), Two(std::array{3.9, 2.3}))));
  const auto first = directional_reflectance(cavity, e, polarized(Conductor<double>(0.2, 3.9)));
  const auto second = directional_reflectance(cavity, e, polarized(Conductor<double>(1.2, 2.3)));
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      CHECK(both(i, j)[0] == Approx(first(i, j)).epsilon(1e-12).margin(1e-15));
      CHECK(both(i, j)[1] == Approx(second(i, j)).epsilon(1e-12).margin(1e-15));
    }
  CHECK(distance(first, second) > 1e-3);
}

TEST_CASE("models of polarisation differ where they should: glass at 60 degrees") {
  const Cavity<double> cavity(radians(60.0));
  const Dielectric<double> glass(1.5);
  CHECK(std::abs(bihemispherical_reflectance(cavity, glass, 1e-13).value - 0.017584127901) < 1e-12);
  CHECK(std::abs(bihemispherical_reflectance(cavity, polarized(glass), 1e-13).value - 0.016577458838) <
        1e-12);
}

TEST_CASE("whatever model follows polarisation, what is not reflected is absorbed") {
  std::mt19937_64 random(311);
  for (int trial = 0; trial < 5000; ++trial) {
    const Scene scene = random_scene(random);
    CAPTURE(scene.cavity.aperture(), scene.e.x, scene.e.y, scene.index);
    const auto check = [&](const auto& facet) {
      const double absorbed = unpolarized(directional_absorptance(scene.cavity, scene.e, facet));
      const double reflected = unpolarized(directional_reflectance(scene.cavity, scene.e, facet));
      CHECK(absorbed == Approx(1 - reflected).margin(2e-14));
    };
    check(scene.metal());
    check(separately_polarized(scene.metal()));
    check(scene.facet());
  }
}

TEST_CASE("the absorptance of a nearly perfect mirror keeps its digits in every model") {
  std::mt19937_64 random(313);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int trial = 0; trial < 2000; ++trial) {
    const float aperture = radians(static_cast<float>(30 + 150 * unit(random)));
    const Vec3<float> e(direction(std::acos(0.01 + 0.99 * unit(random)), 2 * pi<double>() * unit(random)));
    const Conductor<float> metal(30, 3000);  // it absorbs 1e-5 at normal incidence
    const Conductor<double> exact(30, 3000);
    CAPTURE(aperture, e.x, e.y, e.z);
    const auto check = [&](const auto& facet, const auto& exact_facet) {
      const double expected =
          1 - unpolarized(directional_reflectance(Cavity<double>(static_cast<double>(aperture)),
                                                  Vec3<double>(e), exact_facet));
      const float absorbed = unpolarized(directional_absorptance(Cavity<float>(aperture), e, facet));
      CHECK(absorbed == Approx(expected).epsilon(1e-4));
    };
    check(metal, exact);
    check(separately_polarized(metal), separately_polarized(exact));
    check(polarized(metal), polarized(exact));
  }
}

TEST_CASE("a perfect conductor's absorbed power seen through a way is that of its beginning") {
  // J† A J of a unitary J keeps the trace, so unpolarised light is absorbed as if there were no first way.
  const AbsorbedPower<double> absorbed(0.25, 0.5, {0.125, -0.0625});
  const Jones<double> turn({0.6, 0}, {0, 0.8}, {0, 0.8}, {0.6, 0});
  CHECK(unpolarized(absorbed_behind(turn, absorbed)) == Approx(unpolarized(absorbed)).epsilon(1e-15));
}

TEST_CASE("light along the groove is described in the axis z") {
  for (const double sign : {-1.0, 1.0}) {
    const Vec3<double> axis = polarization_axis(Vec3<double>{sign, 0, 0});
    CHECK(axis == Vec3<double>(0, 0, 1));
  }
}

TEST_CASE("polarizance is what unpolarised light becomes, diattenuation what it depends on") {
  // Whatever comes in leaves polarised along a: the incoherent sum of two ways, a to a and b to a.
  const Complex<double> one{1, 0}, none{0, 0};
  const Mueller<double> polarizing = Mueller<double>(Jones<double>{one, none, none, none}) +
                                     Mueller<double>(Jones<double>{none, one, none, none});
  CHECK(polarizance(polarizing) == Approx(1));
  CHECK(diattenuation(polarizing) == Approx(0).margin(1e-15));
  CHECK(polarizance(reversed(polarizing)) == Approx(0).margin(1e-15));
  CHECK(diattenuation(reversed(polarizing)) == Approx(1));
}
