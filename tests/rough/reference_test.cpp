// SPDX-License-Identifier: BSD-3-Clause
/// Reference cases in 40 digits, whose terms were found by root finding on explicit three-dimensional reflections
/// and weighed by bisection on traced rays.

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vcavity/facet/fresnel.hpp>
#include <vcavity/polarization/polarization.hpp>
#include <vcavity/rough/brushed_slopes.hpp>
#include <vcavity/rough/rough_bsdf.hpp>

#include "support/catch.hpp"
#include "support/reals.hpp"

using namespace vcavity;

namespace {

const nlohmann::json& cases() {
  static const nlohmann::json data =
      nlohmann::json::parse(std::ifstream(VCAVITY_TEST_DATA "/distribution_reference.json"));
  return data["cases"];
}

double number(const nlohmann::json& text) {
  return std::stod(text.get<std::string>());
}

Vec3<double> vector_of(const nlohmann::json& row) {
  return {number(row[0]), number(row[1]), number(row[2])};
}

/// Calls `use` with the distribution of a case.
template <class Use>
void with_distribution(const nlohmann::json& row, Use&& use) {
  const nlohmann::json& distribution = row["distribution"];
  const std::string kind = distribution["kind"];
  if (kind == "ggx") {
    use(GgxSlopes<double>(distribution["ax"], distribution["ay"]));
  } else if (kind == "beckmann") {
    use(BeckmannSlopes<double>(distribution["ax"], distribution["ay"]));
  } else {
    REQUIRE(kind == "brushed");
    use(BrushedSlopes(BeckmannSlopes<double>(distribution["a"].get<double>()),
                      distribution["kappa"].get<double>()));
  }
}

/// Calls `use` with every facet of the cases and its name there.
template <class Use>
void with_facets(Use&& use) {
  use("rho=1", [](double) { return 1.0; });
  use("rho=0.5", [](double) { return 0.5; });
  use("n=0.2+3i", Conductor<double>(0.2, 3));
  use("n=1.5", Dielectric<double>(1.5));
}

/// The largest relative error of the formulas here is 2e-13.
constexpr double tolerance = 1e-12;

}  // namespace

TEST_CASE("the BRDF of rough surfaces agrees with 40 digits, in total and for every number of bounces") {
  REQUIRE(cases().size() == 21);
  int compared = 0;
  for (const auto& row : cases()) {
    CAPTURE(row["name"].get<std::string>());
    const Vec3<double> e = vector_of(row["e"]), o = vector_of(row["o"]);
    with_distribution(row, [&](const auto& distribution) {
      with_facets([&](const char* name, const auto& facet) {
        CAPTURE(name);
        const RoughGrooveBsdf bsdf(distribution, facet, 200);
        const auto& expected = row["f_cos_o"][name];
        CHECK(bsdf.evaluate(e, o) == Approx(number(expected["total_of_at_most_200"])).epsilon(tolerance));
        for (int bounces = 1; bounces <= 12; ++bounces) {
          const auto by_bounces = expected["by_bounces"].find(std::to_string(bounces));
          const double value = by_bounces == expected["by_bounces"].end() ? 0 : number(*by_bounces);
          CAPTURE(bounces);
          CHECK(bsdf.evaluate_bounces(e, o, bounces) == Approx(value).epsilon(tolerance));
          ++compared;
        }
      });
    });
  }
  CHECK(compared == 21 * 4 * 12);
}

TEST_CASE("in 50 digits the BRDF agrees with all digits that the cases have") {
  using Real = test::Digits50;
  const auto wide = [](const nlohmann::json& text) { return Real(text.get<std::string>()); };
  int compared = 0;
  for (const auto& row : cases()) {
    const auto& kind = row["distribution"];
    if (kind["kind"] != "ggx") continue;
    CAPTURE(row["name"].get<std::string>());
    // Decimal numbers: 0.3 is three tenths, not the nearest double.
    const auto roughness = [&](const char* axis) {
      return Real(std::lround(100 * kind[axis].get<double>())) / 100;
    };
    const GgxSlopes<Real> slopes(roughness("ax"), roughness("ay"));
    const auto unit = [&](const auto& v) { return detail::unit_vector(wide(v[0]), wide(v[1]), wide(v[2])); };
    const Vec3<Real> e = unit(row["e"]), o = unit(row["o"]);
    const auto check = [&](const char* name, const auto& facet) {
      CAPTURE(name);
      const Real found = RoughGrooveBsdf(slopes, facet, 200).evaluate(e, o);
      const Real expected = wide(row["f_cos_o"][name]["total_of_at_most_200"]);
      CHECK(static_cast<double>(abs(Real(found / expected - 1))) < 1e-15);
      ++compared;
    };
    check("rho=1", [](const Real&) { return Real(1); });
    check("n=0.2+3i", Conductor<Real>(Real(1) / 5, Real(3)));
    check("n=1.5", Dielectric<Real>(Real(3) / 2));
  }
  CHECK(compared == 3 * 14);
}

TEST_CASE("grooves, apertures and panels of a pair of directions agree with 40 digits") {
  for (const auto& row : cases()) {
    CAPTURE(row["name"].get<std::string>());
    const ConnectingGrooves<double> grooves(vector_of(row["e"]), vector_of(row["o"]));
    const double azimuth = radians(number(row["psi_deg"]));
    const Vec2<double> across{std::cos(azimuth), std::sin(azimuth)};
    CHECK(std::abs(grooves.across().x - across.x) < 1e-12);
    CHECK(std::abs(grooves.across().y - across.y) < 1e-12);
    const auto& terms = row["terms"];
    int most = 0;
    for (const auto& term : terms) most = std::max(most, term["bounces"].get<int>());
    std::size_t found = 0;
    for_each_groove(grooves, most, [&](const ConnectingGroove<double>& groove) {
      const auto term = std::find_if(terms.begin(), terms.end(), [&](const auto& t) {
        return t["bounces"].template get<int>() == groove.bounces &&
               t["first_panel"].template get<int>() == static_cast<int>(groove.first_panel);
      });
      REQUIRE(term != terms.end());
      ++found;
      CHECK(2 * degrees(std::atan2(groove.sin_half, groove.cos_half)) ==
            Approx(number((*term)["aperture_deg"])).epsilon(tolerance));
      // The fraction of the rays of such a groove.
      const double weight = grooves.cos_eta() * groove.beam / (2 * groove.sin_half * grooves.to_light().z);
      CHECK(weight == Approx(number((*term)["weight"])).epsilon(tolerance));
      with_distribution(row, [&](const auto& distribution) {
        CHECK(grooves.density(groove, distribution.density(grooves.normal(groove))) ==
              Approx(number((*term)["white_f_cos_o"])).epsilon(tolerance));
      });
    });
    CHECK(found == terms.size());
  }
}

TEST_CASE("Mueller matrices of rough surfaces agree with 30 digits") {
  int compared = 0;
  for (const auto& row : cases()) {
    const auto matrices = row.find("mueller_f_cos_o_of_at_most_12");
    if (matrices == row.end()) continue;
    CAPTURE(row["name"].get<std::string>());
    const Vec3<double> e = vector_of(row["e"]), o = vector_of(row["o"]);
    with_distribution(row, [&](const auto& distribution) {
      with_facets([&](const char* name, const auto& facet) {
        const auto expected = matrices->find(name);
        if constexpr (FieldReflector<std::decay_t<decltype(facet)>, double>) {
          REQUIRE(expected != matrices->end());
          const RoughGrooveBsdf bsdf(distribution, polarized(facet), 12);
          const Mueller<double> found = bsdf.evaluate(e, o, Transport::importance);
          const double scale = number((*expected)[0][0]);
          for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = 0; j < 4; ++j) {
              CAPTURE(name, i, j);
              CHECK(std::abs(found(i, j) - number((*expected)[i][j])) < tolerance * scale);
              ++compared;
            }
        }
      });
    });
  }
  CHECK(compared == 8 * 2 * 16);
}
