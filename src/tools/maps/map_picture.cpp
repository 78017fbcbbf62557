// SPDX-License-Identifier: BSD-3-Clause
#include "tools/maps/map_picture.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <set>
#include <utility>
#include <vcavity/vcavity.hpp>

#include "tools/maps/bounce_zones.hpp"
#include "tools/materials/provenance.hpp"
#include "tools/support/error.hpp"
#include "tools/support/text_table.hpp"

namespace vcavity::tools {
namespace {

/// A disc from the image of a map.
template <class PixelColour>
DiscMap disc_of(const ExrImage& image, const std::string& label, PixelColour&& colour) {
  DiscMap disc{label, image.width, {}};
  const std::vector<float>& alpha = image.plane("A");
  for (std::size_t i = 0; i < alpha.size(); ++i) disc.pixels.push_back(alpha[i] > 0 ? colour(i) : Rgba8{});
  return disc;
}

/// How to speak of a quantity.
struct Wording {
  std::string title;
  std::string preposition;  ///< between it and the grooves
  std::string unit;         ///< behind its name on the colour bar
  double scale;             ///< what a value is multiplied by for the colour bar
};

Wording wording(const MapRequest& request) {
  if (request.light) return {"BRDF", "of", " in 1/sr", 1};
  switch (request.quantity) {
    case Quantity::bounces:
      return {"Number of bounces", "in", ", mean over the opening", 1};
    case Quantity::degree_of_polarization:
      return {"Degree of polarisation", "of", " in %", 100};
    case Quantity::absorptance:
      return {"Absorptance", "of", " in %", 100};
    case Quantity::reflectance:
      break;
  }
  return {"Reflectance", "of", " in %", 100};
}

std::string in_lower_case(std::string text) {
  // An abbreviation, such as BRDF, stays as it is.
  if (text.size() > 1 && std::isupper(static_cast<unsigned char>(text[1]))) return text;
  text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
  return text;
}

/// The point of a disc of radius 1 that shows the direction at θ' across the groove and ψ along it.
DiscPoint disc_point(double theta_across, double psi) {
  const Vec3<double> e{std::sin(psi), std::cos(psi) * std::sin(theta_across),
                       std::cos(psi) * std::cos(theta_across)};
  const auto point = project_to_disc(e);
  return {point.x / std::numbers::sqrt2, point.y / std::numbers::sqrt2};
}

DiscLine line_of(double theta_across) {
  constexpr int pieces = 96;
  DiscLine line;
  for (int i = 0; i <= pieces; ++i)
    line.push_back(disc_point(theta_across, std::numbers::pi * (static_cast<double>(i) / pieces - 0.5)));
  return line;
}

std::string counts(const BounceZone& zone) {
  const std::string least = std::to_string(zone.least);
  return zone.least == zone.most ? least : least + "–" + std::to_string(zone.most);
}

/// Lines between zones of different numbers of bounces, and the numbers. Where lines would merge some are
/// left out.
void add_contours(DiscMap& disc, const SurfaceDescription& surface) {
  if (!is_symmetric_groove(surface))
    throw UsageError("--contours: are known of symmetric grooves only, not of " + in_words(surface));
  constexpr double closest = 0.02;  // in radii
  constexpr double margin = 0.04;
  double last = -1;
  for (const BounceZone& zone : bounce_zones(Cavity<double>(radians(surface.aperture_deg)))) {
    const double left = disc_point(zone.low, 0).u;
    const double right = disc_point(zone.high, 0).u;
    if (zone.low > 0 && left - last > closest) {
      disc.contours.push_back(line_of(zone.low));
      disc.contours.push_back(line_of(-zone.low));
      last = left;
    }
    disc.notes.push_back({{(left + right) / 2, margin}, counts(zone), right - left - margin});
  }
}

/// Adds the luminance of a coloured image as channel Y.
void add_luminance(ExrImage& image) {
  const std::vector<float>&r = image.plane("R"), &g = image.plane("G"), &b = image.plane("B");
  ExrChannel luminance{"Y", {}};
  // The row of Y in the matrix from linear sRGB to XYZ; IEC 61966-2-1.
  for (std::size_t i = 0; i < r.size(); ++i)
    luminance.plane.push_back(0.2126f * r[i] + 0.7152f * g[i] + 0.0722f * b[i]);
  image.channels.push_back(std::move(luminance));
}

/// All values of Y inside the discs in ascending order.
std::vector<double> sorted_values(const std::vector<ExrImage>& images, double scale) {
  std::vector<double> values;
  for (const ExrImage& image : images) {
    const std::vector<float>&y = image.plane("Y"), &alpha = image.plane("A");
    for (std::size_t i = 0; i < y.size(); ++i)
      if (alpha[i] > 0) values.push_back(scale * static_cast<double>(y[i]));
  }
  std::sort(values.begin(), values.end());
  return values;
}

/// 1, 2 or 5 times a power of ten, so that some ten steps make the range.
double round_step(double range) {
  const double power = std::pow(10, std::floor(std::log10(range)));
  const double leading = range / power;
  return power * (leading < 2 ? 0.2 : leading < 5 ? 0.5 : 1);
}

/// A colour bar from and to round numbers. A few values that stand out, as at grazing incidence, do not
/// stretch it.
ColourBar bar_for(const std::vector<ExrImage>& images, const Wording& words) {
  const std::vector<double> values = sorted_values(images, words.scale);
  constexpr double usual_share = 0.96;
  constexpr double most_stretch = 1.3;
  const double usual = values[static_cast<std::size_t>(usual_share * static_cast<double>(values.size() - 1))];
  const double high = values.back() <= most_stretch * usual ? values.back() : usual;
  constexpr double far_from_zero =
      0.4;  // from this share of the highest value on the bar need not start at 0
  const double low = values.front() < far_from_zero * high ? 0 : values.front();

  const double least_range = 1e-3 * (high > 0 ? high : 1);
  const double step = round_step(std::max(high - low, least_range));
  constexpr double rounding = 1e-6;
  ColourBar bar;
  bar.low = step * std::floor(low / step + rounding);
  bar.high = std::max(step * std::ceil(high / step - rounding), bar.low + step);
  bar.label = in_lower_case(words.title) + words.unit;
  if (values.back() > bar.high * (1 + rounding))
    bar.label += " (last colour: " + with_digits(bar.high, 6) + " and above)";
  return bar;
}

std::string wavelengths_in_words(const std::vector<double>& wavelengths_nm) {
  if (wavelengths_nm.size() == 1) return exact(wavelengths_nm.front()) + " nm";
  return exact(wavelengths_nm.front()) + "–" + exact(wavelengths_nm.back()) + " nm";
}

/// What several maps have in common, and what distinguishes them.
class Labels {
 public:
  explicit Labels(const std::vector<MapRequest>& requests) {
    std::set<std::string> materials, wavelengths, films;
    for (const MapRequest& request : requests) {
      materials.insert(material_of(request.surface));
      wavelengths.insert(wavelengths_in_words(request.wavelengths_nm));
      films.insert(materials_in_words(request.surface.films));
    }
    several_materials_ = materials.size() > 1;
    several_wavelengths_ = wavelengths.size() > 1;
    several_films_ = films.size() > 1;
  }

  /// @param what is seen, with a preposition for the grooves
  std::string title(const MapRequest& any, const std::string& what) const {
    const bool spectral = any.quantity != Quantity::bounces;
    std::string text = what + " ";
    if (spectral && !several_materials_)
      text += grooves_in_words(any.surface);
    else
      text += "grooves";
    if (!several_films_ && !any.surface.films.empty())
      text += " under " + materials_in_words(any.surface.films);
    const bool of_red_green_and_blue = any.environment && any.wavelengths_nm.size() > 1;
    if (spectral && !several_wavelengths_ && !of_red_green_and_blue)
      text += ", " + wavelengths_in_words(any.wavelengths_nm);
    return text;
  }

  std::string label(const MapRequest& request) const {
    std::string text = in_words(request.surface);
    if (!several_films_ && !request.surface.films.empty()) {
      SurfaceDescription bare = request.surface;
      bare.films.clear();
      text = in_words(bare) + ", " + thicknesses_in_words(request.surface.films);
    }
    if (several_materials_) text = material_of(request.surface) + ", " + text;
    if (several_wavelengths_) text += ", " + wavelengths_in_words(request.wavelengths_nm);
    return text;
  }

  bool several_materials() const { return several_materials_; }

 private:
  bool several_materials_;
  bool several_wavelengths_;
  bool several_films_;
};

std::string light_in_words(const MapRequest& any) {
  if (any.quantity == Quantity::bounces) return "";
  if (any.light)
    return "Light from theta " + exact(any.light->theta) + "°, phi " + exact(any.light->phi) +
           "°, seen from every direction. ";
  if (!any.environment) return "Diffuse light, seen from every direction. ";
  std::string words = "The light of " + std::filesystem::path(any.environment->name()).filename().string();
  if (const auto& nm = any.wavelengths_nm; nm.size() > 1)
    words += ", R, G, B at " + exact(nm[0]) + ", " + exact(nm[1]) + ", " + exact(nm[2]) + " nm";
  return words + ", seen from every direction. ";
}

/// @param white the luminance that is drawn white, if that is not 1
std::vector<std::string> subtitle(const MapRequest& any, const Labels& labels, const PictureStyle& style,
                                  double white) {
  std::vector<std::string> lines;
  std::string line = light_in_words(any);
  if (white != 1) line += "White stands for a luminance of " + with_digits(white, 6) + " and above. ";
  const auto& roughness = any.surface.roughness;
  if (!roughness || roughness->distribution == Roughness::Distribution::brushed)
    line += "The grooves run upwards in the picture.";
  if (any.max_bounces != all_bounces)
    line += " At most " + std::to_string(any.max_bounces) + (any.max_bounces == 1 ? " bounce." : " bounces.");
  if (any.polarization != Polarization::none)
    line += std::string(" Polarisation: ") + name_of(any.polarization) + ".";
  lines.push_back(line);
  if (style.contours == PictureStyle::Contours::shown)
    lines.push_back("Bold lines: where the number of bounces changes (fewest–most over the opening).");
  if (!labels.several_materials() && any.quantity != Quantity::bounces)
    for (const Material& material : materials_of(any.surface))
      if (!material.constant()) lines.push_back(in_one_line(material));
  return lines;
}

}  // namespace

DiscMap scalar_disc(const ExrImage& image, const std::string& label, const ColourBar& bar, double scale) {
  const std::vector<float>& values = image.plane("Y");
  return disc_of(image, label, [&](std::size_t i) {
    return map_colour(bar.map, (scale * static_cast<double>(values[i]) - bar.low) / (bar.high - bar.low));
  });
}

DiscMap colour_disc(const ExrImage& image, const std::string& label, double white) {
  const std::vector<float>&r = image.plane("R"), &g = image.plane("G"), &b = image.plane("B");
  return disc_of(image, label, [&](std::size_t i) {
    return srgb_pixel(static_cast<double>(r[i]) / white, static_cast<double>(g[i]) / white,
                      static_cast<double>(b[i]) / white);
  });
}

Sheet map_sheet(std::vector<MapRequest> requests, const PictureStyle& style, Progress& progress) {
  const Labels labels(requests);
  const MapRequest& any = requests.front();
  const bool spectral =
      any.environment || (any.wavelengths_nm.size() > 1 && any.quantity != Quantity::bounces && !any.light);
  const bool in_colour = spectral && style.tone == PictureStyle::Tone::natural;
  Wording words = wording(any);
  if (spectral) words = {"Luminous reflectance", "of", " in %", 100};
  if (any.environment) words = {"Luminance", "reflected by", "", 1};

  std::vector<ExrImage> images;
  for (MapRequest& request : requests) {
    request.size = picture_size;
    request.spectrum = Spectrum::colour_only;
    request.viewing.rgb = RgbSpace::srgb;
    const DiscMapper mapper(request);
    if (spectral && !mapper.coloured())
      throw UsageError("a picture needs the reflectance at visible wavelengths, or a single --wavelength");
    images.push_back(compute_map(mapper, progress));
    if (spectral) add_luminance(images.back());
  }

  Sheet sheet;
  // A reflectance is seen beside a white of 1; the radiance of an environment may be of any size.
  const double white = in_colour && any.environment ? bar_for(images, words).high : 1;
  sheet.title = labels.title(any, (in_colour ? "Colour" : words.title) + " " + words.preposition);
  sheet.subtitle = subtitle(any, labels, style, white);
  if (!in_colour) sheet.colour_bar = bar_for(images, words);
  if (sheet.colour_bar && any.quantity == Quantity::reflectance &&
      style.tone == PictureStyle::Tone::natural) {
    sheet.colour_bar->map = ColourMap::grey;
    sheet.colour_bar->low = 0;
  }
  for (std::size_t i = 0; i < images.size(); ++i) {
    const std::string label = labels.label(requests[i]);
    sheet.discs.push_back(in_colour ? colour_disc(images[i], label, white)
                                    : scalar_disc(images[i], label, *sheet.colour_bar, words.scale));
    if (style.contours == PictureStyle::Contours::shown)
      add_contours(sheet.discs.back(), requests[i].surface);
  }
  sheet.grid = AngleGrid::shown;
  sheet.footnote = software() + ", " + command_line();
  if (images.size() == 1) sheet.width = 660;
  if (images.size() == 2) sheet.width = 960;
  return sheet;
}

}  // namespace vcavity::tools
