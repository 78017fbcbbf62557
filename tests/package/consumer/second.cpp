// SPDX-License-Identifier: BSD-3-Clause
#include <vcavity/vcavity.hpp>

double white_furnace() {
  const vcavity::Cavity<double> groove(vcavity::radians(45.0));
  return vcavity::directional_reflectance(groove, {0.6, 0.0, 0.8}, [](double) { return 1.0; });
}
