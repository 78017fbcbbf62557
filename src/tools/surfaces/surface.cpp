// SPDX-License-Identifier: BSD-3-Clause
#include "tools/surfaces/surface.hpp"

#include <nlohmann/json.hpp>

#include "tools/support/error.hpp"

namespace vcavity::tools {
namespace {

UsageError no_plan() {
  return UsageError("--effects auto: plans mirrors only, not surfaces that scatter light");
}

}  // namespace

std::optional<double> Surface::absorptance(const Vec3<double>&) const {
  return std::nullopt;
}

std::vector<SurfaceLobe> Surface::lobes(const Vec3<double>&) const {
  return {};
}

std::optional<SurfaceRay> Surface::ray(const Vec3<double>&, double) const {
  return std::nullopt;
}

std::optional<SurfaceBrdf> Surface::brdf(const Vec3<double>&, const Vec3<double>&) const {
  return std::nullopt;
}

std::map<int, double> Surface::by_bounces(const Vec3<double>&) const {
  return {};
}

std::map<int, double> Surface::by_bounces(const Vec3<double>&, const Vec3<double>&) const {
  return {};
}

nlohmann::ordered_json Surface::more_about(const Vec3<double>&) const {
  return nlohmann::ordered_json::object();
}

EffectsPlan Surface::plan(double, Illumination) const {
  throw no_plan();
}

Integral<double> Surface::bihemispherical(const EffectsPlan&) const {
  throw no_plan();
}

}  // namespace vcavity::tools
