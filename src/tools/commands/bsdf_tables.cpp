// SPDX-License-Identifier: BSD-3-Clause
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <vcavity/conventions.hpp>
#include <vector>

#include "tools/commands/bsdf_files.hpp"
#include "tools/images/progress.hpp"
#include "tools/materials/provenance.hpp"
#include "tools/support/error.hpp"

namespace vcavity::tools {
namespace {

static_assert(std::endian::native == std::endian::little, "both formats are little-endian");

void require_isotropic(const ExportedSurface& surface) {
  if (!surface.is_isotropic)
    throw UsageError(
        "export: this format is for isotropic surfaces: ggx or beckmann with one roughness; write .xml "
        "instead");
}

/// In radians, of half vectors from the normal. In the mirror direction itself the BRDF of a rough surface is infinite, and
/// next to it grooves of very many bounces count: so a table has there what the BRDF is at this distance.
constexpr double nearest_to_mirror = 5e-3;

template <class Number>
void append(std::string& bytes, const Number& number) {
  std::array<char, sizeof(Number)> raw;
  std::memcpy(raw.data(), &number, sizeof(Number));
  for (const char byte : raw) bytes += byte;
}

/// The mirror image of `e` in facets of normal `m`.
Vec3<double> mirrored(const Vec3<double>& e, const Vec3<double>& m) {
  const double twice = 2 * (e.x * m.x + e.y * m.y + e.z * m.z);
  return {twice * m.x - e.x, twice * m.y - e.y, twice * m.z - e.z};
}

Vec3<double> from_angles(double theta, double phi) {
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

// The "tensor file" of Dupuy and Jakob, "An adaptive parameterization for efficient material acquisition and rendering",
// ACM Trans. Graph. 37(6), 2018, of which the adaptive part is left out: the warp of the half vectors is the identity.

/// One table of such a file.
struct Tensor {
  enum class Type : std::uint8_t { bytes = 1, floats = 10 };

  std::string name;
  Type type;
  std::vector<std::uint64_t> shape;
  std::string data;
};

Tensor tensor_of_floats(std::string name, std::vector<std::uint64_t> shape,
                        const std::vector<double>& values) {
  Tensor tensor{std::move(name), Tensor::Type::floats, std::move(shape), {}};
  for (const double value : values) append(tensor.data, static_cast<float>(value));
  return tensor;
}

std::string tensor_file(const std::vector<Tensor>& tensors) {
  constexpr std::string_view magic("tensor_file\0", 12);
  constexpr std::uint64_t alignment = 8;
  std::uint64_t offset = magic.size() + 2 + 4;
  for (const Tensor& tensor : tensors) offset += 2 + tensor.name.size() + 2 + 1 + 8 + 8 * tensor.shape.size();
  std::string header(magic), data;
  const std::uint64_t start = (offset + alignment - 1) / alignment * alignment;
  append(header, std::uint8_t{1});
  append(header, std::uint8_t{0});
  append(header, static_cast<std::uint32_t>(tensors.size()));
  for (const Tensor& tensor : tensors) {
    data.resize((data.size() + alignment - 1) / alignment * alignment, '\0');
    append(header, static_cast<std::uint16_t>(tensor.name.size()));
    header += tensor.name;
    append(header, static_cast<std::uint16_t>(tensor.shape.size()));
    append(header, tensor.type);
    append(header, start + data.size());
    for (const std::uint64_t extent : tensor.shape) append(header, extent);
    data += tensor.data;
  }
  header.resize(start, '\0');
  return header + data;
}

/// BRDF × cosine at the nodes of the table of one angle of incidence: rows of the azimuth of the half vector, columns of
/// the root of its polar angle.
class HalfVectorTable {
 public:
  static constexpr int nodes = 64;

  HalfVectorTable(const Surface& surface, double theta_i) {
    const Vec3<double> e = from_angles(theta_i, 0);
    values_.resize(nodes * nodes);
    density_.resize(nodes * nodes);
    for (int row = 0; row < nodes; ++row) {
      const double phi_m = (2.0 * row / (nodes - 1.0) - 1) * pi<double>();
      // The BRDF is the same on both sides of the plane of incidence.
      const bool is_known = row >= nodes / 2;
      double last = 0;
      for (int column = 0; column < nodes; ++column) {
        const double u = column / (nodes - 1.0);
        const double theta_m = u * u * pi<double>() / 2;
        const Vec3<double> m = from_angles(std::max(theta_m, nearest_to_mirror), phi_m), o = mirrored(e, m);
        const double e_m = e.x * m.x + e.z * m.z;
        const bool is_above = o.z > 0 && e_m > 0;
        // Where there is no such direction the table goes on as it was: readers interpolate.
        if (is_known)
          last = values_[index(nodes - 1 - row, column)];
        else if (is_above)
          last = surface.brdf(e, o)->value.unpolarized * o.z;
        values_[index(row, column)] = last;
        // Of solid angle to the unit square of the table.
        const double jacobian = 8 * pi<double>() * pi<double>() * u * std::sin(theta_m) * std::max(e_m, 0.0);
        density_[index(row, column)] = is_above ? last * jacobian : 0;
      }
    }
  }

  const std::vector<double>& values() const { return values_; }

  /// In proportion to which directions are drawn.
  const std::vector<double>& density() const { return density_; }

 private:
  static std::size_t index(int row, int column) { return static_cast<std::size_t>(row * nodes + column); }

  std::vector<double> values_, density_;
};

}  // namespace

std::string measured_tensors(const ExportedSurface& surface) {
  require_isotropic(surface);
  constexpr std::size_t angles = 46;
  constexpr double last_deg = 89.5;
  constexpr auto nodes = static_cast<std::uint64_t>(HalfVectorTable::nodes);
  const std::size_t wavelengths = surface.wavelengths_nm.size();
  std::vector<double> thetas, spectra, luminance;
  for (std::size_t i = 0; i < angles; ++i)
    thetas.push_back(radians(last_deg * static_cast<double>(i) / (angles - 1)));
  std::vector<std::optional<HalfVectorTable>> tables(angles * wavelengths);
  Progress progress(tables.size());
  tbb::parallel_for(std::size_t{0}, tables.size(), [&](std::size_t i) {
    tables[i].emplace(*surface.spectrum[i % wavelengths], thetas[i / wavelengths]);
    progress.advance();
  });
  for (std::size_t angle = 0; angle < angles; ++angle) {
    std::vector<double> density(nodes * nodes, 0);
    for (std::size_t wavelength = 0; wavelength < wavelengths; ++wavelength) {
      const HalfVectorTable& table = *tables[angle * wavelengths + wavelength];
      spectra.insert(spectra.end(), table.values().begin(), table.values().end());
      for (std::size_t k = 0; k < density.size(); ++k)
        density[k] += table.density()[k] / static_cast<double>(wavelengths);
    }
    // No direction may be left out.
    constexpr double least_share = 1e-3;
    const double least = least_share * *std::max_element(density.begin(), density.end());
    for (const double value : density) luminance.push_back(std::max(value, least));
  }
  const std::string description = surface.name + "; " + software() + ": " + command_line();
  const auto extent = static_cast<std::uint64_t>(angles);
  const std::vector<double> four_ones(4, 1.0);
  return tensor_file({{"description", Tensor::Type::bytes, {description.size()}, description},
                      tensor_of_floats("phi_i", {1}, {0}),
                      tensor_of_floats("theta_i", {extent}, thetas),
                      tensor_of_floats("wavelengths", {wavelengths}, surface.wavelengths_nm),
                      tensor_of_floats("sigma", {2, 2}, four_ones),
                      tensor_of_floats("ndf", {2, 2}, four_ones),
                      tensor_of_floats("vndf", {1, extent, 2, 2}, std::vector<double>(4 * angles, 1.0)),
                      tensor_of_floats("luminance", {1, extent, nodes, nodes}, luminance),
                      tensor_of_floats("spectra", {1, extent, wavelengths, nodes, nodes}, spectra),
                      {"jacobian", Tensor::Type::bytes, {1}, std::string(1, '\0')}});
}

std::string merl_binary(const ExportedSurface& surface) {
  require_isotropic(surface);
  if (surface.spectrum.size() != 1 && surface.spectrum.size() != 3)
    throw UsageError(
        "export: a MERL file has three colours; give one wavelength, or those of blue, green and red");
  // Matusik et al., "A data-driven reflectance model", ACM Trans. Graph. 22(3), 2003, and the reader that comes with
  // their data: cells of √θ_h, θ_d and φ_d, red first, in these units.
  constexpr int cells_theta = 90, cells_phi = 180;
  constexpr std::array<double, 3> unit{1.0 / 1500, 1.15 / 1500, 1.66 / 1500};
  // The values at each wavelength: rows of the half vector, and in them all difference vectors.
  const std::size_t rows = surface.spectrum.size() * cells_theta;
  std::vector<std::vector<double>> values(rows);
  Progress progress(rows);
  tbb::parallel_for(std::size_t{0}, rows, [&](std::size_t row) {
    const Surface& at_wavelength = *surface.spectrum[row / cells_theta];
    const double root = (static_cast<double>(row % cells_theta) + 0.5) / cells_theta;
    const double theta_h = std::max(root * root * pi<double>() / 2, nearest_to_mirror);
    for (int d = 0; d < cells_theta; ++d) {
      const double theta_d = (d + 0.5) / cells_theta * pi<double>() / 2;
      for (int p = 0; p < cells_phi; ++p) {
        const Vec3<double> difference = from_angles(theta_d, (p + 0.5) / cells_phi * pi<double>());
        // The half vector lies at y = 0; the difference vector is seen from it.
        const Vec3<double> e{std::cos(theta_h) * difference.x + std::sin(theta_h) * difference.z,
                             difference.y,
                             std::cos(theta_h) * difference.z - std::sin(theta_h) * difference.x};
        const Vec3<double> o = mirrored(e, from_angles(theta_h, 0));
        values[row].push_back(e.z > 0 && o.z > 0 ? at_wavelength.brdf(e, o)->value.unpolarized : 0);
      }
    }
    progress.advance();
  });
  std::string bytes;
  for (const int cells : {cells_theta, cells_theta, cells_phi})
    append(bytes, static_cast<std::int32_t>(cells));
  for (std::size_t colour = 0; colour < unit.size(); ++colour) {
    const std::size_t wavelength = surface.spectrum.size() == 1 ? 0 : unit.size() - 1 - colour;
    for (std::size_t h = 0; h < cells_theta; ++h)
      for (const double value : values[wavelength * cells_theta + h]) append(bytes, value / unit[colour]);
  }
  return bytes;
}

}  // namespace vcavity::tools
