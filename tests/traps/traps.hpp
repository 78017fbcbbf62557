// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fenv.h>

#include <vcavity/vcavity.hpp>

namespace vcavity::test {

/// Arms the traps as long as it lives.
class Traps {
 public:
  Traps() {
    feclearexcept(FE_ALL_EXCEPT);
    feenableexcept(trapped);
  }
  ~Traps() {
    fedisableexcept(trapped);
    feclearexcept(FE_ALL_EXCEPT);
  }
  Traps(const Traps&) = delete;
  Traps& operator=(const Traps&) = delete;

 private:
  static constexpr int trapped = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW;
};

/// Takes results, so that no compiler leaves out their computation.
template <class T>
class Sink {
 public:
  void operator()(const T& result) {
    last_ = result;
    ++count_;
  }
  void operator()(const Amplitudes<T>& r) {
    for (const T& part : {r.r_s.re, r.r_s.im, r.r_p.re, r.r_p.im}) (*this)(part);
  }
  void operator()(const Vec3<T>& v) {
    for (const T& part : {v.x, v.y, v.z}) (*this)(part);
  }
  int count() const { return count_; }

 private:
  volatile T last_ = T(0);
  int count_ = 0;
};

/// All that a renderer asks of a BSDF.
template <class Bsdf, class T, class... Random>
void use_bsdf(const Bsdf& bsdf, const Vec3<T>& wo, Sink<T>& sink, const Random&... random) {
  sink(largest(unpolarized(bsdf.albedo(wo))));
  for (const Transport transport : {Transport::radiance, Transport::importance})
    if (const auto sample = bsdf.sample(wo, random..., transport)) {
      sink(largest(unpolarized(sample->weight)));
      sink(sample->probability);
      sink(bsdf.pdf(wo, sample->direction));
      sink(largest(unpolarized(bsdf.evaluate(wo, sample->direction))));
    }
}

}  // namespace vcavity::test
