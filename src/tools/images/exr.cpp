// SPDX-License-Identifier: BSD-3-Clause
#include "tools/images/exr.hpp"

#include <ImfChannelList.h>
#include <ImfChromaticities.h>
#include <ImfDoubleAttribute.h>
#include <ImfFloatAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <ImfThreading.h>

#if __has_include(<malloc.h>)
#include <malloc.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <optional>
#include <set>
#include <stdexcept>

#include "tools/support/text_table.hpp"

namespace vcavity::tools {
namespace {

// OpenEXR writes through the AtomicFile, which knows how to report a full disk.
class Stream : public Imf::OStream {
 public:
  explicit Stream(AtomicFile& file) : OStream(file.target().c_str()), file_(file) {}
  void write(const char data[], int size) override { file_.write(data, static_cast<std::size_t>(size)); }
  std::uint64_t tellp() override { return file_.position(); }
  void seekp(std::uint64_t position) override { file_.seek(position); }

 private:
  AtomicFile& file_;
};

Imf::Compression imf_compression(ExrCompression compression) {
  switch (compression) {
    case ExrCompression::none:
      return Imf::NO_COMPRESSION;
    case ExrCompression::rle:
      return Imf::RLE_COMPRESSION;
    case ExrCompression::zips:
      return Imf::ZIPS_COMPRESSION;
    case ExrCompression::zip:
      return Imf::ZIP_COMPRESSION;
    case ExrCompression::piz:
      return Imf::PIZ_COMPRESSION;
  }
  throw std::invalid_argument("unknown ExrCompression");
}

ExrCompression known_compression(Imf::Compression compression) {
  for (const auto known : {ExrCompression::none, ExrCompression::rle, ExrCompression::zips,
                           ExrCompression::zip, ExrCompression::piz})
    if (imf_compression(known) == compression) return known;
  throw std::runtime_error("its compression is not one of ours");
}

ExrNumber common_number(const Imf::ChannelList& channels) {
  std::set<Imf::PixelType> types;
  for (auto it = channels.begin(); it != channels.end(); ++it) types.insert(it.channel().type);
  if (types == std::set{Imf::FLOAT}) return ExrNumber::float32;
  if (types == std::set{Imf::HALF}) return ExrNumber::float16;
  throw std::runtime_error("its channels are neither all floats nor all halves");
}

// Imf's default is Rec. 709. The others: ITU-R BT.2020-2, table 3.
Imf::Chromaticities chromaticities(ExrPrimaries primaries) {
  if (primaries == ExrPrimaries::rec709) return {};
  return {{0.708f, 0.292f}, {0.170f, 0.797f}, {0.131f, 0.046f}, {0.3127f, 0.3290f}};
}

void insert_attributes(Imf::Header& header, const ExrAttributes& attributes) {
  for (const auto& [name, value] : attributes) {
    if (const auto* text = std::get_if<std::string>(&value)) header.insert(name, Imf::StringAttribute(*text));
    if (const auto* number = std::get_if<float>(&value)) header.insert(name, Imf::FloatAttribute(*number));
    if (const auto* number = std::get_if<double>(&value)) header.insert(name, Imf::DoubleAttribute(*number));
  }
}

ExrAttributes extract_attributes(const Imf::Header& header) {
  ExrAttributes attributes;
  for (auto it = header.begin(); it != header.end(); ++it) {
    const Imf::Attribute& value = it.attribute();
    if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&value))
      attributes[it.name()] = text->value();
    if (const auto* number = dynamic_cast<const Imf::FloatAttribute*>(&value))
      attributes[it.name()] = number->value();
    if (const auto* number = dynamic_cast<const Imf::DoubleAttribute*>(&value))
      attributes[it.name()] = number->value();
  }
  return attributes;
}

void validate(const ExrHeader& header) {
  if (header.width < 1 || header.height < 1)
    throw std::invalid_argument("an EXR image needs at least one pixel, not " + std::to_string(header.width) +
                                " x " + std::to_string(header.height));
  if (header.channels.empty()) throw std::invalid_argument("an EXR image needs a channel");
  std::set<std::string> names;
  for (const auto& name : header.channels)
    if (name.empty() || !names.insert(name).second)
      throw std::invalid_argument("an EXR channel needs a name of its own, not '" + name + "'");
}

Imf::Header imf_header(const ExrHeader& header) {
  validate(header);
  Imf::Header result(header.width, header.height);
  result.compression() = imf_compression(header.compression);
  const auto type = header.number == ExrNumber::float16 ? Imf::HALF : Imf::FLOAT;
  for (const auto& name : header.channels) result.channels().insert(name, Imf::Channel(type));
  const bool rgb = result.channels().findChannel("R") && result.channels().findChannel("G") &&
                   result.channels().findChannel("B");
  if (rgb) Imf::addChromaticities(result, chromaticities(header.primaries));
  insert_attributes(result, header.attributes);
  return result;
}

}  // namespace

const std::vector<float>& ExrImage::plane(const std::string& name) const {
  for (const auto& channel : channels)
    if (channel.name == name) return channel.plane;
  throw std::out_of_range("the EXR image has no channel '" + name + "'");
}

struct ExrWriter::Output {
  AtomicFile& file;
  ExrHeader header;
  Stream stream;
  std::optional<Imf::OutputFile> image;
  int rows_written = 0;

  // Runs an OpenEXR operation. If the file failed meanwhile then that is the error to report, not OpenEXR's
  // account of it.
  template <class Operation>
  void guard(Operation operation) {
    try {
      operation();
    } catch (const std::exception& error) {
      file.check();
      throw std::runtime_error("cannot write '" + file.target().string() + "': " + error.what());
    }
    file.check();
  }
};

namespace {

// No file says infinity where the result is a number too large for it.
void check_range(const AtomicFile& file, const ExrHeader& header, std::size_t channel,
                 std::span<const float> values) {
  const bool halves = header.number == ExrNumber::float16;
  const float largest = halves ? static_cast<float>(HALF_MAX) : std::numeric_limits<float>::max();
  for (const float value : values)
    if (!(std::abs(value) <= largest))
      throw std::runtime_error("cannot write '" + file.target().string() + "': channel '" +
                               header.channels[channel] + "' has the value " + exact(value) + ", " +
                               (halves ? "--precision half" : "a float") + " holds none beyond " +
                               exact(largest));
}

// OpenEXR allocates and frees the buffers of every chunk anew; glibc would return their memory to the kernel
// each time, and fetch it page by page.
void keep_freed_memory() {
#ifdef M_TRIM_THRESHOLD
  constexpr int threshold = 32 << 20;  // the largest for M_MMAP_THRESHOLD
  mallopt(M_MMAP_THRESHOLD, threshold);
  mallopt(M_TRIM_THRESHOLD, 4 * threshold);
#endif
}

}  // namespace

ExrWriter::ExrWriter(AtomicFile& file, const ExrHeader& header)
    : output_(new Output{file, header, Stream(file), std::nullopt}) {
  keep_freed_memory();
  const Imf::Header imf = imf_header(header);
  output_->guard([&] { output_->image.emplace(output_->stream, imf, Imf::globalThreadCount()); });
}

ExrWriter::~ExrWriter() = default;

int ExrWriter::rows_left() const {
  return output_->header.height - output_->rows_written;
}

void ExrWriter::write_rows(int rows, std::span<const std::span<const float>> planes) {
  const ExrHeader& header = output_->header;
  const auto width = static_cast<std::size_t>(header.width);
  const std::size_t pixels = width * static_cast<std::size_t>(rows);
  if (rows < 1 || rows > rows_left())
    throw std::logic_error(std::to_string(rows) + " rows do not fit, " + std::to_string(rows_left()) +
                           " are left");
  if (planes.size() != header.channels.size())
    throw std::logic_error("write_rows needs one plane for each channel");

  const bool halves = header.number == ExrNumber::float16;
  for (std::size_t c = 0; c < planes.size(); ++c) check_range(output_->file, header, c, planes[c]);
  const std::size_t value_size = halves ? sizeof(half) : sizeof(float);
  std::vector<half> converted(halves ? pixels * planes.size() : 0);
  const Imath::V2i origin(0, output_->rows_written);
  Imf::FrameBuffer buffer;
  for (std::size_t c = 0; c < planes.size(); ++c) {
    if (planes[c].size() != pixels)
      throw std::logic_error("channel '" + header.channels[c] + "' has " + std::to_string(planes[c].size()) +
                             " values, expected " + std::to_string(pixels));
    half* const block = converted.data() + (halves ? c * pixels : 0);
    if (halves) std::copy(planes[c].begin(), planes[c].end(), block);
    const void* values = halves ? static_cast<const void*>(block) : planes[c].data();
    buffer.insert(header.channels[c], Imf::Slice::Make(halves ? Imf::HALF : Imf::FLOAT, values, origin,
                                                       header.width, rows, value_size));
  }
  output_->guard([&] {
    output_->image->setFrameBuffer(buffer);
    output_->image->writePixels(rows);
  });
  output_->rows_written += rows;
}

void ExrWriter::finish() {
  if (rows_left() > 0)
    throw std::logic_error(std::to_string(rows_left()) + " rows of the EXR image are missing");
  output_->guard([&] { output_->image.reset(); });  // writes the table of offsets
}

void write_exr(const std::filesystem::path& path, const ExrImage& image, ExrNumber number,
               ExrCompression compression) {
  ExrHeader header{image.width, image.height, {}, image.attributes, number, compression};
  std::vector<std::span<const float>> planes;
  for (const auto& channel : image.channels) {
    header.channels.push_back(channel.name);
    planes.emplace_back(channel.plane);
  }
  AtomicFile file(path);
  ExrWriter writer(file, header);
  writer.write_rows(image.height, planes);
  writer.finish();
  file.commit();
}

ExrHeader read_exr_header(const std::filesystem::path& path) try {
  const Imf::InputFile input(path.c_str());
  const Imf::Header& header = input.header();
  const Imath::V2i largest = header.dataWindow().size();
  ExrHeader result{largest.x + 1,
                   largest.y + 1,
                   {},
                   extract_attributes(header),
                   common_number(header.channels()),
                   known_compression(header.compression())};
  for (auto it = header.channels().begin(); it != header.channels().end(); ++it)
    result.channels.emplace_back(it.name());
  if (Imf::hasChromaticities(header) && Imf::chromaticities(header) == chromaticities(ExrPrimaries::rec2020))
    result.primaries = ExrPrimaries::rec2020;
  return result;
} catch (const std::exception& error) {
  throw std::runtime_error("cannot read '" + path.string() + "': " + error.what());
}

ExrImage read_exr(const std::filesystem::path& path) try {
  Imf::InputFile input(path.c_str(), Imf::globalThreadCount());
  const Imath::Box2i window = input.header().dataWindow();
  ExrImage image{window.size().x + 1, window.size().y + 1, {}, extract_attributes(input.header())};
  const std::size_t pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);

  const Imf::ChannelList& list = input.header().channels();
  for (auto it = list.begin(); it != list.end(); ++it) {
    if (it.channel().xSampling != 1 || it.channel().ySampling != 1)
      throw std::runtime_error("channel '" + std::string(it.name()) + "' is subsampled");
    image.channels.push_back({it.name(), std::vector<float>(pixels)});
  }
  Imf::FrameBuffer buffer;
  for (auto& channel : image.channels)
    buffer.insert(channel.name, Imf::Slice::Make(Imf::FLOAT, channel.plane.data(), window));
  input.setFrameBuffer(buffer);
  input.readPixels(window.min.y, window.max.y);
  return image;
} catch (const std::exception& error) {
  throw std::runtime_error("cannot read '" + path.string() + "': " + error.what());
}

void set_exr_threads(int count) {
  Imf::setGlobalThreadCount(count);
}

std::string spectral_channel_name(double wavelength_nm) {
  std::string name = "T." + std::to_string(wavelength_nm) + "nm";
  std::replace(name.begin() + 2, name.end(), '.', ',');
  return name;
}

ExrAttributes::value_type spectral_layout_version() {
  return {"spectralLayoutVersion", "1.0"};
}

}  // namespace vcavity::tools
