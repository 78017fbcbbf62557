// SPDX-License-Identifier: BSD-3-Clause

/// What examples/cuda does in kernels, for Clang to find what no GPU has: memory that is allocated, static memory that is
/// filled at first use, exceptions. It is compiled without a CUDA toolkit, and never run.

#define __host__ __attribute__((host))
#define __device__ __attribute__((device))
#define __global__ __attribute__((global))

__device__ inline void* memcpy(void* to, const void* from, __SIZE_TYPE__ size) {
  return __builtin_memcpy(to, from, size);
}

#include "examples/cuda/vcavity.cuh"

using namespace vcavity;
using Facet = Conductor<glm::vec3>;

/// Random numbers, and two directions.
struct Query {
  Vec3<float> view, light;
  float u_lobe;
  Vec2<float> u;
};

template <class Bsdf>
__device__ float mirrored(const Bsdf& bsdf, const Query& query) {
  const auto sample = bsdf.sample(query.view, query.u_lobe);
  return largest(bsdf.albedo(query.view)) + (sample ? sample->probability : 0.0f);
}

template <class Bsdf>
__device__ float spread(const Bsdf& bsdf, const Query& query) {
  const auto sample = bsdf.sample(query.view, query.u_lobe, query.u);
  return largest(bsdf.evaluate(query.view, query.light)) + bsdf.pdf(query.view, query.light) +
         (sample ? sample->probability : 0.0f);
}

__global__ void parallel_grooves(const GrooveBsdf<float, Facet> bsdf, const Query query, float* out) {
  *out = mirrored(bsdf, query);
}

__global__ void grooves_of_points(const float aperture, const float tilt, const Facet facet,
                                  const Query query, float* out) {
  *out =
      mirrored(GrooveBsdf([=] { return Cavity<float>::by_addition(aperture); }, facet), query) +
      mirrored(GrooveBsdf(AsymmetricGroove<float>(Cavity<float>::by_addition(aperture), tilt), facet), query);
}

__global__ void fields(const GrooveBsdf<float, Polarized<Facet>> bsdf, const Query query, float* out) {
  *out = unpolarized(bsdf.albedo(query.view)).x;
}

__global__ void one_wavelength(const Cavity<float> groove, const Conductor<float> facet, const Query query,
                               float* out) {
  *out =
      directional_reflectance(groove, query.view, facet) + directional_absorptance(groove, query.view, facet);
}

__global__ void lobes_with_width(const SpreadGrooveBsdf<float, Facet> bsdf, const Query query, float* out) {
  *out = spread(bsdf, query);
}

__global__ void rough_surface(const RoughGrooveBsdf<GgxSlopes<float>, Facet> bsdf, const Query query,
                              float* out) {
  *out = spread(bsdf, query);
}
