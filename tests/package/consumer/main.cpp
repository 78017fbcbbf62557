// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <vcavity/vcavity.hpp>

double white_furnace();

int main() {
  std::printf("vcavity %s: a white groove reflects %.3f\n", VCAVITY_VERSION, white_furnace());
}
