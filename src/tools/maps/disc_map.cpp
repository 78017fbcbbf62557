// SPDX-License-Identifier: BSD-3-Clause
#include "tools/maps/disc_map.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <future>
#include <glm/vec3.hpp>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <span>
#include <utility>
#include <vcavity/vcavity.hpp>

#include "tools/maps/colour_grid.hpp"
#include "tools/materials/provenance.hpp"
#include "tools/support/error.hpp"
#include "tools/support/report.hpp"
#include "tools/support/text_table.hpp"

namespace vcavity::tools {
namespace {

std::string in_words(const MapRequest& request) {
  if (request.light)
    return "bidirectional reflectance distribution function in 1/sr for light from theta " +
           exact(request.light->theta) + " and phi " + exact(request.light->phi) + " degrees";
  switch (request.quantity) {
    case Quantity::bounces:
      return "number of bounces, mean over the opening in Y";
    case Quantity::degree_of_polarization:
      return "degree of polarisation under unpolarised diffuse light";
    case Quantity::absorptance:
      return "directional absorptance, which is the directional emissivity";
    default:
      return "hemispherical-directional reflectance factor";
  }
}

std::string in_words(const Viewing& viewing) {
  return std::string("linear ") + (viewing.rgb == RgbSpace::rec2020 ? "Rec. 2020" : "sRGB") +
         " of the spectrum under " + load_light(viewing.light).name + ", " +
         (viewing.observer == Observer::cie_1964_10deg ? "CIE 1964 10" : "CIE 1931 2") +
         " degree observer; neither clipped nor adapted to another white";
}

/// A grid with what its colour needs in between.
std::vector<double> refined_grid(const MapRequest& request, const LightModel& light) {
  return refined(request.wavelengths_nm, [&](double wavelength_nm) {
    const auto surface = make_surface(request.surface, wavelength_nm, light);
    constexpr double slanting = std::numbers::sqrt2 / 2;
    return std::pair(surface->reflectance({0, 0, 1}).unpolarized,
                     surface->reflectance({slanting, 0, slanting}).unpolarized);
  });
}

std::string listed(const std::vector<double>& numbers) {
  std::vector<std::string> words;
  for (const double number : numbers) words.push_back(exact(number));
  return joined(words, " ");
}

/// "tilt_deg" as "tiltDeg".
std::string attribute_name(const std::string& field) {
  std::string name;
  for (std::size_t i = 0; i < field.size(); ++i) {
    const bool starts_word = i > 0 && field[i - 1] == '_';
    if (field[i] != '_')
      name += starts_word ? static_cast<char>(std::toupper(static_cast<unsigned char>(field[i]))) : field[i];
  }
  return name;
}

/// What the surface is, as attributes.
ExrAttributes shape_attributes(const SurfaceDescription& surface) {
  ExrAttributes attributes;
  const nlohmann::ordered_json fields = fields_of(surface);
  for (const auto& [field, value] : fields.items()) {
    if (value.is_number())
      attributes[attribute_name(field)] = value.get<double>();
    else
      attributes[attribute_name(field)] = text_of(value);
  }
  std::vector<std::string> sources;
  for (const Material& material : materials_of(surface)) sources.push_back(material.reference());
  if (!sources.empty()) attributes["materialSource"] = joined(sources, "; ");
  return attributes;
}

}  // namespace

std::optional<Vec3<double>> pixel_direction(int column, int row, int size) {
  const double scale = std::numbers::sqrt2 / size;
  return direction_on_disc(Vec2<double>{scale * (2 * column + 1 - size), scale * (size - 1 - 2 * row)});
}

DiscMapper::DiscMapper(MapRequest request) : request_(std::move(request)) {
  if (request_.quantity == Quantity::degree_of_polarization && request_.polarization == Polarization::none)
    throw UsageError("--quantity dop: light without polarisation, expected --polarization separate or full");
  const LightModel light{request_.polarization, request_.max_bounces};
  const bool coloured =
      request_.quantity == Quantity::reflectance && !request_.environment && !request_.light;
  wavelengths_nm_ = coloured && request_.colour_grid == ColourGrid::refined ? refined_grid(request_, light)
                                                                            : request_.wavelengths_nm;
  for (const double wavelength_nm : wavelengths_nm_)
    surfaces_.push_back(make_surface(request_.surface, wavelength_nm, light));
  check();
  if (by_kernel()) {
    for (const auto& surface : surfaces_) indices_.push_back(surface->index().value());
    if (has_films(request_.surface.films)) films_ = kernel_films();
  }
  if (request_.quantity == Quantity::bounces) {
    channels_ = {"Y", "bounces.least", "bounces.most", "A"};
  } else if (request_.environment) {
    channels_ = {"R", "G", "B", "A"};
  } else if (surfaces_.size() == 1) {
    channels_ = {"Y", "A"};
  } else {
    if (request_.quantity == Quantity::reflectance && !request_.light &&
        std::any_of(wavelengths_nm_.begin(), wavelengths_nm_.end(), is_visible)) {
      weights_.emplace(wavelengths_nm_, load_light(request_.viewing.light), request_.viewing.observer);
      channels_ = {"R", "G", "B"};
    }
    channels_.push_back("A");
    if (request_.spectrum == Spectrum::written)
      for (const double wavelength_nm : request_.wavelengths_nm)
        channels_.push_back(spectral_channel_name(wavelength_nm));
  }
}

ExrAttributes DiscMapper::attributes() const {
  ExrAttributes result = shape_attributes(request_.surface);
  result["software"] = software();
  result["command"] = command_line();
  result["projection"] = std::string(
      "Lambert azimuthal equal-area, disc of radius sqrt(2); u to the right across the groove, v upwards "
      "along it");
  const bool limited = request_.max_bounces != all_bounces;
  result["maxBounces"] = limited ? std::to_string(request_.max_bounces) : std::string("all");
  result["quantity"] = in_words(request_);
  result["units"] = std::string(request_.light ? "1/sr" : "1");
  if (request_.quantity == Quantity::bounces) return result;
  result["arithmetic"] = std::string(request_.precision == Precision::single_precision ? "float" : "double");
  result["polarization"] = std::string(name_of(request_.polarization));
  if (request_.environment) {
    result["quantity"] = std::string("radiance reflected from the environment");
    result["units"] = std::string("those of the environment");
    result["environment"] = request_.environment->name();
  }
  if (!request_.environment && surfaces_.size() > 1 && request_.spectrum == Spectrum::written)
    result.insert(spectral_layout_version());
  if (weights_) result["colour"] = in_words(request_.viewing);
  if (surfaces_.size() == 1) {
    result["wavelengthNm"] = request_.wavelengths_nm.front();
    if (const auto index = surfaces_.front()->index()) {
      result["refractiveIndexN"] = index->n;
      result["extinctionK"] = index->k;
    }
  } else {
    std::vector<std::string> n, k;
    for (const std::size_t i : requested()) {
      const auto index = surfaces_[i]->index();
      if (!index) continue;
      n.push_back(exact(index->n));
      k.push_back(exact(index->k));
    }
    result["wavelengthsNm"] = listed(request_.wavelengths_nm);
    if (wavelengths_nm_.size() > request_.wavelengths_nm.size())
      result["colourWavelengthsNm"] = listed(wavelengths_nm_);
    if (!n.empty()) result["refractiveIndicesN"] = joined(n, " ");
    if (!k.empty()) result["extinctionsK"] = joined(k, " ");
  }
  return result;
}

// Which of the wavelengths were asked for.
std::vector<std::size_t> DiscMapper::requested() const {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < wavelengths_nm_.size(); ++i)
    if (std::binary_search(request_.wavelengths_nm.begin(), request_.wavelengths_nm.end(),
                           wavelengths_nm_[i]))
      places.push_back(i);
  return places;
}

// What cannot be computed for this surface. A surface has it in all directions or in none.
void DiscMapper::check() const {
  const Vec3<double> up{0, 0, 1};
  const Surface& surface = *surfaces_.front();
  if (request_.light && !surface.brdf(up, up))
    throw UsageError("--theta: a mirror has no BRDF, expected a surface that scatters light");
  if (request_.environment && surface.lobes(up).empty())
    throw UsageError("--environment: is reflected by mirrors only, not by a surface that scatters light");
  if (request_.quantity == Quantity::bounces && surface.lobes(up).empty())
    throw UsageError("--quantity bounces: is known of mirrors only, not of a surface that scatters light");
  if (request_.quantity == Quantity::degree_of_polarization && !surface.reflectance(up).diattenuation)
    throw UsageError("--quantity dop: light reflected by this surface has no known polarisation");
}

// The one place where the fast way parts from the general one.
bool DiscMapper::by_kernel() const {
  if (!is_symmetric_groove(request_.surface) || request_.environment || request_.light) return false;
  return has_films(request_.surface.films) ? request_.quantity == Quantity::reflectance
                                           : request_.quantity != Quantity::bounces;
}

// The films as the kernel takes them.
std::vector<KernelFilm> DiscMapper::kernel_films() const {
  std::vector<KernelFilm> films;
  for (const FilmLayer& layer : request_.surface.films) {
    KernelFilm film;
    for (const double wavelength_nm : wavelengths_nm_) {
      film.indices.push_back(layer.material.at(wavelength_nm));
      film.thicknesses.push_back(layer.thickness_nm / wavelength_nm);
    }
    films.push_back(std::move(film));
  }
  return films;
}

// What the kernel computes, for any surface.
double DiscMapper::value(const Surface& surface, const Vec3<double>& e) const {
  if (request_.light) {
    const Vec3<double> light = direction(radians(request_.light->theta), radians(request_.light->phi));
    return surface.brdf(light, e)->value.unpolarized;
  }
  const Reflected reflected = surface.reflectance_in_maps(e);
  if (request_.quantity == Quantity::degree_of_polarization) return *reflected.diattenuation;
  if (request_.quantity == Quantity::reflectance) return reflected.unpolarized;
  return surface.absorptance(e).value_or(1 - reflected.unpolarized);
}

// For each direction the values at all wavelengths; for the kernel all have e.y ≥ 0.
std::vector<double> DiscMapper::spectra(const Directions& directions) const {
  std::vector<double> values(directions.size() * surfaces_.size());
  if (by_kernel()) {
    run_kernel({radians(request_.surface.aperture_deg), request_.quantity, request_.polarization,
                request_.max_bounces, indices_, directions, values, films_},
               request_.precision);
  } else {
    auto next = values.begin();
    for (std::size_t i = 0; i < directions.size(); ++i)
      for (const auto& surface : surfaces_) *next++ = value(*surface, directions[i]);
  }
  return values;
}

Xyz DiscMapper::colour(const Vec3<double>& e) const {
  return weights_->colour(spectra({{e.x}, {by_kernel() ? std::abs(e.y) : e.y}, {e.z}}));
}

// A viewer looks along the lobes of his own direction, by reciprocity: each shows a part of the opening as
// wide as its weight, and in it the environment behind the lobe.
glm::dvec3 DiscMapper::reflected_radiance(const Vec3<double>& e) const {
  glm::dvec3 sum(0.0);
  for (std::size_t channel = 0; channel < 3; ++channel) {
    if (channel >= surfaces_.size()) break;
    for (const SurfaceLobe& lobe : surfaces_[channel]->lobes(e)) {
      const glm::dvec3 reflected =
          lobe.weight * lobe.throughput.unpolarized * request_.environment->radiance(lobe.direction);
      if (surfaces_.size() == 1)
        sum += reflected;
      else
        sum[static_cast<int>(channel)] += reflected[static_cast<int>(channel)];
    }
  }
  return sum;
}

// What the kernels do not compute.
// `put(channel, pixel, value)` takes the values.
template <class Put>
void DiscMapper::put_from_lobes(const Vec3<double>& e, std::size_t pixel, const Put& put) const {
  if (request_.environment) {
    const glm::dvec3 radiance = reflected_radiance(e);
    put(0, pixel, radiance.x);
    put(1, pixel, radiance.y);
    put(2, pixel, radiance.z);
    put(3, pixel, 1);
    return;
  }
  int least = std::numeric_limits<int>::max();
  int most = 0;
  double mean = 0;
  for (const SurfaceLobe& lobe : surfaces_.front()->lobes(e)) {
    least = std::min(least, lobe.bounces);
    most = std::max(most, lobe.bounces);
    mean += lobe.weight * lobe.bounces;
  }
  put(0, pixel, mean);
  put(1, pixel, least);
  put(2, pixel, most);
  put(3, pixel, 1);
}

template <class Put>
void DiscMapper::put_spectra(std::span<const double> spectra, std::size_t pixels, const Put& put) const {
  const std::size_t wavelengths = surfaces_.size();
  std::size_t channel = 0;
  const auto put_wavelengths = [&] {
    for (const std::size_t i : requested()) {
      for (std::size_t pixel = 0; pixel < pixels; ++pixel)
        put(channel, pixel, spectra[pixel * wavelengths + i]);
      ++channel;
    }
  };
  if (wavelengths == 1) put_wavelengths();
  if (weights_) {
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
      const LinearRgb colour = to_linear_rgb(
          weights_->colour(spectra.subspan(pixel * wavelengths, wavelengths)), request_.viewing.rgb);
      put(0, pixel, colour.r);
      put(1, pixel, colour.g);
      put(2, pixel, colour.b);
    }
    channel = 3;
  }
  for (std::size_t pixel = 0; pixel < pixels; ++pixel) put(channel, pixel, 1);
  ++channel;
  if (wavelengths > 1 && request_.spectrum == Spectrum::written) put_wavelengths();
}

Planes DiscMapper::rows(int first_row, int rows, Planes planes) const {
  const int size = request_.size;
  const auto at = [size](int row, int column) {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(size) + static_cast<std::size_t>(column);
  };
  planes.resize(channels_.size());
  for (std::vector<float>& plane : planes) plane.resize(at(rows, 0));
  // A symmetric groove is its own mirror image: the right half of a row tells the left half, unless the light differs.
  const bool mirrored = is_symmetric_groove(request_.surface) && !request_.environment;
  const bool from_lobes = request_.environment || request_.quantity == Quantity::bounces;
  tbb::parallel_for(0, rows, [&](int row) {
    Directions directions;
    std::vector<int> columns;
    for (int column = mirrored ? size / 2 : 0; column < size; ++column) {
      if (const auto e = pixel_direction(column, first_row + row, size)) {
        directions.push_back(*e);
        columns.push_back(column);
      }
    }
    for (std::vector<float>& plane : planes) std::fill_n(&plane[at(row, 0)], size, 0.0f);
    const auto put = [&](std::size_t channel, std::size_t pixel, double value) {
      float* const values = &planes[channel][at(row, 0)];
      values[columns[pixel]] = static_cast<float>(value);
      if (mirrored) values[size - 1 - columns[pixel]] = static_cast<float>(value);
    };
    if (from_lobes) {
      for (std::size_t pixel = 0; pixel < directions.size(); ++pixel)
        put_from_lobes(directions[pixel], pixel, put);
    } else {
      put_spectra(spectra(directions), directions.size(), put);
    }
  });
  return planes;
}

ExrImage compute_map(const DiscMapper& mapper, Progress& progress) {
  const int size = mapper.request().size;
  ExrImage image{size, size, {}, mapper.attributes()};
  for (const std::string& channel : mapper.channels()) image.channels.push_back({channel, {}});
  Planes planes;
  for (int row = 0; row < size; row += chunk_rows) {
    const int rows = std::min(chunk_rows, size - row);
    planes = mapper.rows(row, rows, std::move(planes));
    for (std::size_t i = 0; i < planes.size(); ++i)
      image.channels[i].plane.insert(image.channels[i].plane.end(), planes[i].begin(), planes[i].end());
    progress.advance(static_cast<std::uint64_t>(rows));
  }
  return image;
}

ExrHeader map_header(const DiscMapper& mapper, const Storage& storage) {
  const int size = mapper.request().size;
  const bool rec2020 = mapper.coloured() && mapper.request().viewing.rgb == RgbSpace::rec2020;
  return {size,
          size,
          mapper.channels(),
          mapper.attributes(),
          storage.number,
          storage.compression,
          rec2020 ? ExrPrimaries::rec2020 : ExrPrimaries::rec709};
}

void write_map(AtomicFile& file, const DiscMapper& mapper, const Storage& storage, int block_rows,
               Progress& progress) {
  ExrWriter writer(file, map_header(mapper, storage));
  const int size = mapper.request().size;
  const auto rows_of_block = [&](int row) { return std::min(block_rows, size - row); };
  const auto compute = [&](int row, Planes memory) {
    return std::async(std::launch::async,
                      [&mapper, row, rows = rows_of_block(row), memory = std::move(memory)]() mutable {
                        return mapper.rows(row, rows, std::move(memory));
                      });
  };
  std::future<Planes> computed = compute(0, {});
  Planes planes;
  for (int row = 0; row < size; row += rows_of_block(row)) {
    const int rows = rows_of_block(row);
    Planes written = std::exchange(planes, computed.get());
    if (row + rows < size) computed = compute(row + rows, std::move(written));
    writer.write_rows(rows, std::vector<std::span<const float>>(planes.begin(), planes.end()));
    progress.advance(static_cast<std::uint64_t>(rows));
  }
  writer.finish();
}

}  // namespace vcavity::tools
