// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Light from all around, as a latitude–longitude image.

#include <filesystem>
#include <glm/vec3.hpp>
#include <string>
#include <vcavity/conventions.hpp>

#include "tools/images/sky.hpp"

namespace vcavity::tools {

/// An environment of radiances in red, green and blue.
///
/// The top row is the zenith +z, the bottom row −z. The middle of the image is the direction +y across the
/// groove, and the azimuth grows to the right: +x is three quarters of the way across. A picture taken from
/// the groove looks right, neither mirrored nor upside down.
class Environment {
 public:
  /// Reads an OpenEXR image; see read_sky() for what is understood.
  /// @throws std::runtime_error "cannot read 'PATH': REASON"
  explicit Environment(const std::filesystem::path& path);

  /// The path of the image.
  const std::string& name() const { return name_; }

  /// The radiance that comes from a direction; linear between the centres of the pixels, wrapped around in
  /// azimuth.
  /// @param from unit vector towards the light
  glm::dvec3 radiance(const Vec3<double>& from) const;

 private:
  glm::dvec3 pixel(int column, int row) const;

  std::string name_;
  SkyImage sky_;
};

}  // namespace vcavity::tools
