// SPDX-License-Identifier: BSD-3-Clause

/// What a renderer does with a grooved surface, without a renderer: copper grooves of 60°, seen from 40°.

#include <cstdio>
#include <random>
#include <vcavity/vcavity.hpp>

using namespace vcavity;

int main() {
  const Cavity<float> groove(radians(60.0f));
  const Conductor<glm::vec3> copper({0.27f, 0.91f, 1.19f}, {3.41f, 2.60f, 2.36f});  // at 630, 550, 470 nm
  const GrooveBsdf bsdf(groove, copper);
  const Vec3<float> to_viewer = direction(radians(40.0f), radians(20.0f));

  std::puts("bounces  light from (x, y, z)      weight  throughput red, green, blue");
  for (const auto& lobe : bsdf.lobes(to_viewer)) {
    const Vec3<float>& from = lobe.direction;
    const glm::vec3& colour = lobe.throughput;
    std::printf("%7d  (%6.3f, %6.3f, %6.3f)  %.4f  %.4f  %.4f  %.4f\n", lobe.bounces, from.x, from.y, from.z,
                lobe.weight, colour.x, colour.y, colour.z);
  }

  // Under a sky of radiance 1 where y > 0 and 0 elsewhere, a path tracer would find:
  std::mt19937 random(1);
  const int paths = 100000;
  glm::vec3 radiance(0);
  for (int path = 0; path < paths; ++path) {
    const float u = static_cast<float>(random() % 65536) / 65536;
    if (const auto sample = bsdf.sample(to_viewer, u); sample && sample->direction.y > 0)
      radiance += sample->weight / static_cast<float>(paths);
  }
  const glm::vec3 all_sky = bsdf.albedo(to_viewer);
  std::printf("radiance under half a sky: %.2f %.2f %.2f\n", radiance.x, radiance.y, radiance.z);
  std::printf("directional albedo: %.4f %.4f %.4f\n", all_sky.x, all_sky.y, all_sky.z);
}
