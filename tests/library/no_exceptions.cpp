// SPDX-License-Identifier: BSD-3-Clause
/// Compiled without exceptions, as many renderers are: a valid groove has an answer, and an invalid argument ends
/// the program with one line that names it.

#include <cstdlib>
#include <vcavity/vcavity.hpp>

int main(int count, char**) {
  using namespace vcavity;
  const Conductor<double> silver(0.1249, 3.3391);
  const double aperture = count > 1 ? -1.0 : 1.0;
  const GrooveBsdf bsdf(Cavity<double>(aperture), polarized(silver));
  const auto sample = bsdf.sample(direction(0.4, 0.3), 0.5);
  return sample && unpolarized(sample->weight) > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
