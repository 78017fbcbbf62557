// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// OpenEXR images: named planes of floats with the provenance of the numbers in the attributes.
///
/// Rows run from top to bottom, the planes are independent of each other (no "RGBA" assumed). RGB images are
/// linear with the primaries and white of Rec. 709 (that of sRGB) unless asked otherwise, and say so in the
/// attribute `chromaticities`. Pixels that mean nothing, such as those outside a disc, hold 0 in every
/// channel, `A` included.

#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "tools/images/atomic_file.hpp"

namespace vcavity::tools {

/// What an image says about itself: command line, version, material and its source, angles, wavelengths,
/// units.
using ExrAttributes = std::map<std::string, std::variant<std::string, float, double>>;

/// How numbers are stored. A half has 11 significant bits and no value above 65504.
enum class ExrNumber { float32, float16 };

/// Lossless compression only: the numbers are the result. For maps of floats `piz` is both faster and smaller than
/// `zip`.
enum class ExrCompression { none, rle, zips, zip, piz };

/// How many rows OpenEXR compresses together.
constexpr int rows_per_chunk(ExrCompression compression) {
  return compression == ExrCompression::piz ? 32 : compression == ExrCompression::zip ? 16 : 1;
}

/// The primaries of the channels R, G, B; their white is D65.
enum class ExrPrimaries { rec709, rec2020 };

/// Everything about an image but its pixels.
struct ExrHeader {
  int width = 0;
  int height = 0;
  std::vector<std::string> channels;
  ExrAttributes attributes;
  ExrNumber number = ExrNumber::float32;
  ExrCompression compression = ExrCompression::piz;
  ExrPrimaries primaries = ExrPrimaries::rec709;
};

/// One named channel of an image, row by row from the top.
struct ExrChannel {
  std::string name;
  std::vector<float> plane;
};

/// An image in memory.
struct ExrImage {
  int width = 0;
  int height = 0;
  std::vector<ExrChannel> channels;
  ExrAttributes attributes;

  /// The plane of the channel `name`. Throws std::out_of_range if there is none.
  const std::vector<float>& plane(const std::string& name) const;
};

/// Writes an image block by block, so that memory is bounded by the block and not by the image.
///
///     AtomicFile file("map.exr");
///     ExrWriter writer(file, {.width = 512, .height = 512, .channels = {"R", "G", "B", "A"}});
///     while (writer.rows_left() > 0) writer.write_rows(16, planes_of_the_next_16_rows);
///     writer.finish();
///     file.commit();
class ExrWriter {
 public:
  /// Writes the header. `file` must outlive the writer.
  /// Throws std::invalid_argument for an empty image or a channel without a name or named twice.
  ExrWriter(AtomicFile& file, const ExrHeader& header);
  ~ExrWriter();

  /// Rows not written yet.
  int rows_left() const;

  /// Writes the next `rows` rows. `planes` holds one block of rows × width values for each channel, in the
  /// order of the header. Fast if `rows` is a multiple of 32, the largest number of rows that OpenEXR
  /// compresses together.
  void write_rows(int rows, std::span<const std::span<const float>> planes);

  /// Completes the image. Throws std::logic_error if rows are missing.
  void finish();

 private:
  struct Output;
  std::unique_ptr<Output> output_;
};

/// Writes an image completely or not at all; size, channels and attributes come from `image`.
void write_exr(const std::filesystem::path& path, const ExrImage& image,
               ExrNumber number = ExrNumber::float32, ExrCompression compression = ExrCompression::piz);

/// Reads everything about an image but its pixels; the channels come in alphabetical order.
/// Throws std::runtime_error "cannot read 'PATH': REASON", also for an image that ExrHeader cannot describe.
ExrHeader read_exr_header(const std::filesystem::path& path);

/// Reads all channels as floats and the attributes of type string, float and double.
/// Throws std::runtime_error "cannot read 'PATH': REASON".
ExrImage read_exr(const std::filesystem::path& path);

/// Lets OpenEXR compress on `count` threads; 0 compresses on the calling thread.
void set_exr_threads(int count);

/// The channel name of a reflectance at a wavelength in nm: "T.550,000000nm".
/// Fichet, Pacanowski, Wilkie, "An OpenEXR Layout for Spectral Images", JCGT 10(3), 2021.
std::string spectral_channel_name(double wavelength_nm);

/// The attribute that marks a spectral image, with its value: {"spectralLayoutVersion", "1.0"}. Same source.
ExrAttributes::value_type spectral_layout_version();

}  // namespace vcavity::tools
