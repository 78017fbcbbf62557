// SPDX-License-Identifier: BSD-3-Clause
/// The namespaces of GLM and of the library may be opened side by side: where both have a function of the same
/// name, such as `radians`, the one of the library is the more constrained and therefore meant.

#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>
#include <vcavity/vcavity.hpp>

#include "support/catch.hpp"

using namespace glm;
using namespace std;
using namespace vcavity;

TEST_CASE("with the namespaces of GLM and of the library open, angles are those of the library") {
  CHECK(radians(180.0) == vcavity::radians(180.0));
  CHECK(degrees(1.0f) == vcavity::degrees(1.0f));
  CHECK(vcavity::pi<double>() == Approx(3.14159265358979));
  const Cavity<double> groove(radians(60.0));
  const Conductor<dvec3> gold(dvec3(0.3), dvec3(3.0));
  CHECK(largest(directional_reflectance(groove, direction(radians(30.0), radians(20.0)), gold)) > 0);
}
