// SPDX-License-Identifier: BSD-3-Clause
#include <cstdlib>
#include <iostream>
#include "accuracy/fresnel_subjects.hpp"
#include "accuracy/groove_subjects.hpp"
#include "accuracy/worst_case.hpp"
using namespace vcavity::test;
template<class Real> void run(const char* type, int samples, int steps) {
  for (const auto& s : groove_subjects<Real>()) {
    Random random(1);
    const auto w = find_worst_case(s, samples, steps, random);
    std::cout << s.name << " " << type << " " << w.error.epsilons << " / " << w.error.bound << " cond " << w.error.condition << " at";
    for (auto& a : w.arguments) std::cout << " " << a;
    std::cout << std::endl;
  }
}
int main(int, char** argv) {
  const int samples = std::atoi(argv[1]), steps = std::atoi(argv[2]);
  run<float>("float", samples, steps);
  run<double>("double", samples, steps);
  run<long double>("long double", samples, steps);
}
