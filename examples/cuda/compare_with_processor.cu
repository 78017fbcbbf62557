// SPDX-License-Identifier: BSD-3-Clause

/// Draws a direction, and evaluates, for each of a million directions of view, by a kernel and by the processor, and compares.
/// Prints a Markdown table with the largest deviations, and times of one of 1,048,576 directions; ends with status 1 where
/// they differ by more than rounding.
///
///     clang++ -x cuda -std=c++20 -O2 --cuda-gpu-arch=sm_90 -I include examples/cuda/compare_with_processor.cu -lcudart
///
/// with the architecture of the GPU at hand, and --cuda-path=… where the toolkit lies elsewhere than in /usr/local/cuda.

#include "vcavity.cuh"

#include <chrono>
#include <random>

namespace {

using namespace vcavity;
using Colour = glm::vec3;
using Direction = Vec3<float>;

constexpr std::size_t count = std::size_t{1} << 20;
constexpr int threads = 128;
constexpr int runs = 5;

/// A direction of view with random numbers.
struct Query {
  Direction view, light;
  float u_lobe;
  Vec2<float> u;
};

/// What a BSDF says of it.
struct Answer {
  Colour value{0.0f}, weight{0.0f};
  Direction drawn{0.0f, 0.0f, 0.0f};
  int bounces = 0;

  template <class Sample>
  __host__ __device__ void take(const Sample& sample) {
    weight = sample.weight;
    drawn = sample.direction;
    bounces = sample.bounces;
  }
};

/// Surfaces: parallel grooves, whose value is their albedo, for mirrors have none in single directions;
template <class Bsdf>
struct Parallel {
  const char* name;
  Bsdf bsdf;

  __host__ __device__ Answer answer(const Query& query, std::size_t) const { return answer_of(bsdf, query); }

  template <class Any>
  __host__ __device__ static Answer answer_of(const Any& bsdf, const Query& query) {
    Answer result;
    result.value = bsdf.albedo(query.view);
    if (const auto sample = bsdf.sample(query.view, query.u_lobe)) result.take(*sample);
    return result;
  }
};
template <class Bsdf>
Parallel(const char*, Bsdf) -> Parallel<Bsdf>;

/// grooves that each point has its own of, as a texture of apertures would;
struct Textured {
  const char* name;
  Conductor<Colour> facet;

  __host__ __device__ Answer answer(const Query& query, std::size_t i) const {
    const float aperture = 0.5f + 2.5f * static_cast<float>(i) / count;
    return Parallel<int>::answer_of(GrooveBsdf([=] { return Cavity<float>::by_addition(aperture); }, facet),
                                    query);
  }
};

/// and lobes with a width and rough surfaces, which have values.
template <class Bsdf>
struct Spread {
  const char* name;
  Bsdf bsdf;

  __host__ __device__ Answer answer(const Query& query, std::size_t) const {
    Answer result;
    result.value = bsdf.evaluate(query.view, query.light);
    if (const auto sample = bsdf.sample(query.view, query.u_lobe, query.u)) result.take(*sample);
    return result;
  }
};
template <class Bsdf>
Spread(const char*, Bsdf) -> Spread<Bsdf>;

template <class Surface>
__global__ void ask(const Surface surface, const Query* queries, Answer* answers) {
  const std::size_t i = blockIdx.x * blockDim.x + threadIdx.x;
  if (i < count) answers[i] = surface.answer(queries[i], i);
}

/// Ends the program where CUDA reports an error.
void require(cudaError_t status) {
  if (status == cudaSuccess) return;
  std::fprintf(stderr, "compare_with_processor: %s\n", cudaGetErrorString(status));
  std::exit(1);
}

template <class Item>
class GpuArray {
 public:
  GpuArray() { require(cudaMalloc(&items_, count * sizeof(Item))); }
  GpuArray(const GpuArray&) = delete;
  GpuArray& operator=(const GpuArray&) = delete;
  ~GpuArray() { cudaFree(items_); }

  Item* get() const { return items_; }

 private:
  Item* items_ = nullptr;
};

Direction direction_above(std::mt19937& random) {
  std::uniform_real_distribution<float> uniform(0, 1);
  const float z = uniform(random), azimuth = 2 * pi<float>() * uniform(random), across = std::sqrt(1 - z * z);
  return {across * std::cos(azimuth), across * std::sin(azimuth), z};
}

float largest_of(const Colour& c) {
  return std::max({std::abs(c.x), std::abs(c.y), std::abs(c.z)});
}

/// Prints a row.
/// @return whether the answers agree
template <class Surface>
bool compare(const Surface& surface, const std::vector<Query>& queries) {
  const GpuArray<Query> there;
  const GpuArray<Answer> answers_there;
  require(cudaMemcpy(there.get(), queries.data(), count * sizeof(Query), cudaMemcpyHostToDevice));
  cudaEvent_t start, end;
  require(cudaEventCreate(&start));
  require(cudaEventCreate(&end));
  float milliseconds = std::numeric_limits<float>::max();
  for (int run = 0; run < runs; ++run) {
    require(cudaEventRecord(start));
    ask<<<static_cast<unsigned>(count / threads), threads>>>(surface, there.get(), answers_there.get());
    require(cudaGetLastError());
    require(cudaEventRecord(end));
    require(cudaEventSynchronize(end));
    float elapsed;
    require(cudaEventElapsedTime(&elapsed, start, end));
    milliseconds = std::min(milliseconds, elapsed);
  }
  std::vector<Answer> found(count), expected(count);
  require(cudaMemcpy(found.data(), answers_there.get(), count * sizeof(Answer), cudaMemcpyDeviceToHost));

  const auto before = std::chrono::steady_clock::now();
  for (std::size_t i = 0; i < count; ++i) expected[i] = surface.answer(queries[i], i);
  const std::chrono::duration<double, std::nano> here = std::chrono::steady_clock::now() - before;

  std::vector<float> values, weights;
  std::size_t others = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Answer &a = found[i], &b = expected[i];
    values.push_back(largest_of(a.value - b.value) / std::max(largest_of(b.value), 1e-3f));
    constexpr float same_direction = 1e-3f;
    if (a.bounces != b.bounces ||
        largest_of({a.drawn.x - b.drawn.x, a.drawn.y - b.drawn.y, a.drawn.z - b.drawn.z}) > same_direction)
      ++others;
    else
      weights.push_back(largest_of(a.weight - b.weight));
  }
  // Close to where the number of bounces changes, and to mirror directions, rounding is more: one in a thousand is left out.
  const auto all_but_few = [](std::vector<float>& deviations) {
    const auto place =
        deviations.begin() + static_cast<std::ptrdiff_t>(0.999 * static_cast<double>(deviations.size()));
    std::nth_element(deviations.begin(), place, deviations.end());
    return *place;
  };
  const float value = all_but_few(values), weight = all_but_few(weights);
  std::printf("| %s | %.1e | %.1e | %zu | %.2g ns | %.0f ns |\n", surface.name, value, weight, others,
              1e6 * milliseconds / count, here.count() / count);
  constexpr float rounding = 3e-5f;
  return value < rounding && weight < rounding && others < count / 50'000;
}

}  // namespace

int main() {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> uniform(0, 1);
  std::vector<Query> queries(count);
  for (Query& query : queries) {
    query.view = direction_above(random);
    query.light = direction_above(random);
    query.u_lobe = uniform(random);
    query.u = {uniform(random), uniform(random)};
  }
  cudaDeviceProp properties;
  require(cudaGetDeviceProperties(&properties, 0));
  std::printf(
      "%s, %zu directions\n\n| copper | value | weight | other draws | GPU | one processor core |\n"
      "|---|---|---|---|---|---|\n",
      properties.name, count);
  const Conductor<Colour> copper({0.27f, 0.91f, 1.19f}, {3.41f, 2.60f, 2.36f});
  const Cavity<float> right(radians(90.0f)), acute(radians(45.0f)), narrow(radians(10.0f)),
      slit(radians(0.5f));
  bool agree = compare(Parallel{"90°", GrooveBsdf(right, copper)}, queries);
  agree &= compare(Parallel{"45°", GrooveBsdf(acute, copper)}, queries);
  agree &= compare(Parallel{"10°", GrooveBsdf(narrow, copper)}, queries);
  agree &= compare(Parallel{"0.5°", GrooveBsdf(slit, copper)}, queries);
  agree &= compare(Parallel{"70°, tilted by 20°",
                            GrooveBsdf(AsymmetricGroove<float>(radians(70.0f), radians(20.0f)), copper)},
                   queries);
  agree &= compare(Textured{"29° to 172°, one for each point", copper}, queries);
  agree &= compare(Spread{"45°, spread by 5°", SpreadGrooveBsdf(GrooveBsdf(acute, copper), radians(5.0f))},
                   queries);
  agree &= compare(Spread{"GGX 0.3, 8 bounces", RoughGrooveBsdf(GgxSlopes<float>(0.3f), copper, 8)}, queries);
  agree &= compare(Spread{"GGX 0.3, 32 bounces", RoughGrooveBsdf(GgxSlopes<float>(0.3f), copper)}, queries);
  return agree ? 0 : 1;
}
