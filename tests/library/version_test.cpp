// SPDX-License-Identifier: BSD-3-Clause
#include <string>
#include <vcavity/version.hpp>

#include "support/catch.hpp"

TEST_CASE("the version text is made of the three version numbers") {
  CHECK(std::string(VCAVITY_VERSION) == std::to_string(VCAVITY_VERSION_MAJOR) + "." +
                                            std::to_string(VCAVITY_VERSION_MINOR) + "." +
                                            std::to_string(VCAVITY_VERSION_PATCH));
}
