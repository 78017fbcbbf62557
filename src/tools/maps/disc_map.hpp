// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Maps of the hemisphere: a value for every direction, on the disc of the equal-area projection.
///
/// Pixel (column, row) of a map of size N shows the direction at u = √2 (2 column + 1 − N)/N,
/// v = √2 (N − 1 − 2 row)/N: across the groove to the right, along it upwards. Pixels whose centre lies
/// outside the disc hold 0 in all channels; those inside hold 1 in the channel `A`.

#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tools/colour/spectral_weights.hpp"
#include "tools/images/exr.hpp"
#include "tools/images/progress.hpp"
#include "tools/kernel/kernel.hpp"
#include "tools/maps/environment.hpp"
#include "tools/surfaces/surface_description.hpp"

namespace vcavity::tools {

/// Whether a map of many wavelengths holds a channel for each of them, or only their colour.
enum class Spectrum { written, colour_only };

/// At which wavelengths the colour of a map is computed: where the reflectance changes between those of the grid by more
/// than a straight line shows, as with thin films or a table of n and k finer than the grid, also in between; or only at
/// those of the grid.
enum class ColourGrid { refined, as_given };

/// How the spectrum of a map becomes a colour.
struct Viewing {
  std::string light = "D65";  ///< see load_light()
  Observer observer = Observer::cie_1931_2deg;
  RgbSpace rgb = RgbSpace::srgb;
};

/// How the numbers of a map are stored.
struct Storage {
  ExrNumber number = ExrNumber::float32;
  ExrCompression compression = ExrCompression::piz;
};

/// A direction in degrees.
struct DirectionDeg {
  double theta;
  double phi;
};

/// A map to be computed.
struct MapRequest {
  SurfaceDescription surface;
  std::vector<double> wavelengths_nm;  ///< one, or an ascending grid
  int size;                            ///< pixels along one side
  int max_bounces;
  Quantity quantity = Quantity::reflectance;
  Spectrum spectrum = Spectrum::written;
  Polarization polarization = Polarization::none;
  Precision precision = Precision::double_precision;
  std::shared_ptr<const Environment> environment = nullptr;  ///< needs one wavelength, or one per R, G and B
  Viewing viewing = {};
  std::optional<DirectionDeg> light =
      std::nullopt;  ///< if given, the map shows the BRDF for light from there
  ColourGrid colour_grid = ColourGrid::refined;
};

/// The direction that a pixel shows; nothing outside the disc.
std::optional<Vec3<double>> pixel_direction(int column, int row, int size);

/// Some rows of a map: for each channel a plane of rows × size values.
using Planes = std::vector<std::vector<float>>;

/// Computes the rows of a map, so that a map of any size fits into memory.
///
/// Channels: `Y` and `A` for the reflectance at one wavelength; `R`, `G`, `B` (linear RGB of the
/// spectrum, negative components kept; absent if nothing is visible), `A` and one `T.…nm` per
/// wavelength for a grid; `Y` (mean over the opening), `bounces.least`, `bounces.most` and `A` for bounces.
/// With an environment: its radiance reflected towards each direction, in `R`, `G`, `B` and `A`.
/// The degree of polarisation (as seen under unpolarised diffuse light) and the absorptance are stored like
/// the reflectance, but have no colour.
class DiscMapper {
 public:
  /// Throws UsageError for a wavelength without data, or for the degree of polarisation in a model without
  /// polarisation.
  explicit DiscMapper(MapRequest request);

  const MapRequest& request() const { return request_; }
  const std::vector<std::string>& channels() const { return channels_; }

  /// Whether there are channels R, G, B.
  bool coloured() const { return weights_ || request_.environment; }

  /// What the image says about itself.
  ExrAttributes attributes() const;

  /// The radiance of the environment that the groove reflects towards a viewer. Only with an environment.
  glm::dvec3 reflected_radiance(const Vec3<double>& e) const;

  /// The colour seen from a direction in diffuse light, and the white beside it. Only where there is a
  /// channel `R`.
  Xyz colour(const Vec3<double>& e) const;
  const Xyz& white() const { return weights_->white(); }

  /// Computes `rows` rows from `first_row` on, on all cores.
  /// @param planes memory to use again, such as the planes of an earlier call
  Planes rows(int first_row, int rows, Planes planes = {}) const;

 private:
  std::vector<double> spectra(const Directions& directions) const;
  template <class Put>
  void put_spectra(std::span<const double> spectra, std::size_t pixels, const Put& put) const;
  template <class Put>
  void put_from_lobes(const Vec3<double>& e, std::size_t pixel, const Put& put) const;
  void check() const;
  bool by_kernel() const;
  std::vector<KernelFilm> kernel_films() const;
  double value(const Surface& surface, const Vec3<double>& e) const;
  std::vector<std::size_t> requested() const;

  MapRequest request_;
  std::vector<double> wavelengths_nm_;  // those of the request, and between them those of the colour
  std::vector<std::shared_ptr<const Surface>> surfaces_;  // at each of them
  std::vector<RefractiveIndex> indices_;                  // those of the kernel, if it is what computes
  std::vector<KernelFilm> films_;                         // the same
  std::optional<SpectralWeights> weights_;
  std::vector<std::string> channels_;
};

/// Rows that OpenEXR compresses together at most.
inline constexpr int chunk_rows = 32;

/// Computes a whole map in memory, advancing `progress` by the number of its rows.
ExrImage compute_map(const DiscMapper& mapper, Progress& progress);

/// Everything about the file of a map but its pixels.
ExrHeader map_header(const DiscMapper& mapper, const Storage& storage);

/// Computes a map and writes it block by block, advancing `progress` by the number of its rows. While one
/// block is compressed and written, the next is computed.
/// @param block_rows rows of a block, a multiple of rows_per_chunk(); see set_exr_threads() for how many chunks are
/// compressed at a time
void write_map(AtomicFile& file, const DiscMapper& mapper, const Storage& storage, int block_rows,
               Progress& progress);

}  // namespace vcavity::tools
