// SPDX-License-Identifier: BSD-3-Clause
#include <tbb/parallel_for.h>
#include <tbb/parallel_for_each.h>

#include <array>
#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <vcavity/conventions.hpp>
#include <vector>

#include "tools/commands/bsdf_files.hpp"
#include "tools/images/progress.hpp"
#include "tools/materials/provenance.hpp"
#include "tools/support/error.hpp"

namespace vcavity::tools {
namespace {

/// A ring of Klems' basis of 145 patches of the hemisphere (J. H. Klems, ASHRAE Transactions 100, 1994, the
/// "full" basis of LBNL's WINDOW).
struct KlemsRing {
  int centre_deg, lower_deg, upper_deg, patches;
};

constexpr std::array<KlemsRing, 9> klems_full{{{0, 0, 5, 1},
                                               {10, 5, 15, 8},
                                               {20, 15, 25, 16},
                                               {30, 25, 35, 20},
                                               {40, 35, 45, 24},
                                               {50, 45, 55, 24},
                                               {60, 55, 65, 24},
                                               {70, 65, 75, 16},
                                               {82, 75, 90, 12}}};

double sine_squared(int angle_deg) {
  const double sine = std::sin(radians(static_cast<double>(angle_deg)));
  return sine * sine;
}

/// Directions of one patch, each of the same part of its projected solid angle.
/// @param across as many in θ, and in φ
std::vector<Vec3<double>> directions_of(const KlemsRing& ring, int patch, int across) {
  const double low = sine_squared(ring.lower_deg), high = sine_squared(ring.upper_deg);
  const double width = 2 * pi<double>() / ring.patches;
  std::vector<Vec3<double>> result;
  for (int i = 0; i < across; ++i) {
    const double s2 = low + (high - low) * (i + 0.5) / across;
    for (int j = 0; j < across; ++j) {
      const double phi = width * (patch - 0.5 + (j + 0.5) / across);
      result.push_back({std::sqrt(s2) * std::cos(phi), std::sqrt(s2) * std::sin(phi), std::sqrt(1 - s2)});
    }
  }
  return result;
}

/// All patches, in the order of the basis.
std::vector<std::vector<Vec3<double>>> patches_of_hemisphere(int across) {
  std::vector<std::vector<Vec3<double>>> result;
  for (const KlemsRing& ring : klems_full)
    for (int patch = 0; patch < ring.patches; ++patch) result.push_back(directions_of(ring, patch, across));
  return result;
}

/// The projected solid angle of a patch.
double projected_solid_angle(const KlemsRing& ring) {
  return pi<double>() / ring.patches * (sine_squared(ring.upper_deg) - sine_squared(ring.lower_deg));
}

/// The number of the patch that holds a direction.
std::size_t patch_of(const Vec3<double>& direction) {
  const double s2 = direction.x * direction.x + direction.y * direction.y;
  std::size_t first = 0;
  for (const KlemsRing& ring : klems_full) {
    if (s2 < sine_squared(ring.upper_deg) || ring.upper_deg == 90) {
      const double turns = std::atan2(direction.y, direction.x) / (2 * pi<double>());
      const auto number = static_cast<int>(std::floor(turns * ring.patches + 0.5));
      return first + static_cast<std::size_t>((number + ring.patches) % ring.patches);
    }
    first += static_cast<std::size_t>(ring.patches);
  }
  return 0;
}

/// The BRDF from one direction to all patches, averaged over these.
///
/// Near the mirror direction the BRDF of a rough surface has a peak that may be narrower than the distance of the points
/// of a patch. So what they miss of the reflectance of the direction, which is known, belongs to the patch of the mirror
/// direction; where they find more than there is, a peak has met one of them by chance, and all is scaled.
std::vector<double> patch_means(const Surface& surface, const Vec3<double>& e, double reflectance,
                                const std::vector<std::vector<Vec3<double>>>& patches,
                                const std::vector<double>& solid_angles) {
  std::vector<double> means;
  double found = 0;
  for (std::size_t i = 0; i < patches.size(); ++i) {
    double sum = 0;
    for (const Vec3<double>& o : patches[i]) sum += surface.brdf(e, o)->value.unpolarized;
    means.push_back(sum / static_cast<double>(patches[i].size()));
    found += means[i] * solid_angles[i];
  }
  const std::size_t mirror = patch_of({-e.x, -e.y, e.z});
  const double missed = (reflectance - found) / solid_angles[mirror];
  if (means[mirror] + missed >= 0)
    means[mirror] += missed;
  else
    for (double& mean : means) mean *= reflectance / found;
  return means;
}

/// The mean BRDF from patch to patch, whose hemispherical reflectances are the means of those of the surface. The basis of
/// incident light numbers patches by the direction in which the light travels, so that a mirror leads from a patch to the
/// one of the same number.
/// @return for each patch that light leaves to, in their order, the BRDF from each that it comes from
std::vector<double> klems_matrix(const Surface& surface, bool is_isotropic) {
  constexpr int across_from = 2, across_to = 4;
  const auto from = patches_of_hemisphere(across_from), to = patches_of_hemisphere(across_to);
  std::vector<double> solid_angles;
  for (const KlemsRing& ring : klems_full)
    solid_angles.insert(solid_angles.end(), static_cast<std::size_t>(ring.patches),
                        projected_solid_angle(ring));
  // Each takes as long as many BRDFs. Isotropic surfaces have one for all patches of a ring.
  std::map<double, double> reflectances;
  if (is_isotropic)
    for (const KlemsRing& ring : klems_full)
      for (const Vec3<double>& e : directions_of(ring, 0, across_from)) reflectances[e.z] = 0;
  Progress progress(reflectances.size() + from.size());
  tbb::parallel_for_each(reflectances.begin(), reflectances.end(), [&](auto& of_cosine) {
    const double cosine = of_cosine.first;
    of_cosine.second = surface.reflectance({0, std::sqrt(1 - cosine * cosine), cosine}).unpolarized;
    progress.advance();
  });
  const auto reflectance_of = [&](const Vec3<double>& e) {
    return is_isotropic ? reflectances.at(e.z) : surface.reflectance(e).unpolarized;
  };
  std::vector<double> matrix(from.size() * to.size(), 0);
  tbb::parallel_for(std::size_t{0}, from.size(), [&](std::size_t column) {
    for (const Vec3<double>& travelling : from[column]) {
      const Vec3<double> e{-travelling.x, -travelling.y, travelling.z};
      const auto means = patch_means(surface, e, reflectance_of(e), to, solid_angles);
      for (std::size_t row = 0; row < to.size(); ++row)
        matrix[row * from.size() + column] += means[row] / static_cast<double>(from[column].size());
    }
    progress.advance();
  });
  return matrix;
}

std::string angle_basis() {
  std::ostringstream text;
  text << "        <AngleBasis>\n          <AngleBasisName>LBNL/Klems Full</AngleBasisName>\n";
  for (const KlemsRing& ring : klems_full)
    text << "          <AngleBasisBlock>\n            <Theta>" << ring.centre_deg << "</Theta>\n"
         << "            <nPhis>" << ring.patches << "</nPhis>\n            <ThetaBounds>\n"
         << "              <LowerTheta>" << ring.lower_deg << "</LowerTheta>\n              <UpperTheta>"
         << ring.upper_deg << "</UpperTheta>\n            </ThetaBounds>\n          </AngleBasisBlock>\n";
  text << "        </AngleBasis>\n";
  return text.str();
}

/// XML without what XML would read.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text)
    result += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
  return result;
}

}  // namespace

std::string bsdf_xml(const ExportedSurface& surface) {
  if (surface.spectrum.size() != 1)
    throw UsageError("export: BSDF XML is written at one wavelength; take one value of --wavelength");
  const std::vector<double> matrix = klems_matrix(*surface.spectrum[0], surface.is_isotropic);
  std::ostringstream text;
  text << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<WindowElement xmlns=\"http://windows.lbl.gov\" "
          "xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" "
          "xsi:schemaLocation=\"http://windows.lbl.gov/BSDF-v1.4.xsd\">\n"
       << "  <WindowElementType>System</WindowElementType>\n  <FileType>BSDF</FileType>\n  <Optical>\n    "
          "<Layer>\n      <Material>\n"
       << "        <Name>" << escaped(surface.name) << ", " << surface.wavelengths_nm[0]
       << " nm</Name>\n        <Manufacturer>" << escaped(software() + ": " + command_line())
       << "</Manufacturer>\n        <DeviceType>Other</DeviceType>\n      </Material>\n      "
          "<DataDefinition>\n"
       << "        <IncidentDataStructure>Columns</IncidentDataStructure>\n"
       << angle_basis() << "      </DataDefinition>\n      <WavelengthData>\n"
       << "        <LayerNumber>System</LayerNumber>\n        <Wavelength "
          "unit=\"Integral\">Visible</Wavelength>\n"
       << "        <SourceSpectrum>CIE Illuminant D65 1nm.ssp</SourceSpectrum>\n"
       << "        <DetectorSpectrum>ASTM E308 1931 Y.dsp</DetectorSpectrum>\n        <WavelengthDataBlock>\n"
       << "          <WavelengthDataDirection>Reflection Front</WavelengthDataDirection>\n"
       << "          <ColumnAngleBasis>LBNL/Klems Full</ColumnAngleBasis>\n"
       << "          <RowAngleBasis>LBNL/Klems Full</RowAngleBasis>\n"
       << "          <ScatteringDataType>BRDF</ScatteringDataType>\n          <ScatteringData>\n";
  text.precision(6);
  const std::size_t columns =
      static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(matrix.size()))));
  for (std::size_t i = 0; i < matrix.size(); ++i)
    text << matrix[i] << (i + 1 == matrix.size() ? "\n" : (i + 1) % columns == 0 ? ",\n" : ", ");
  text << "          </ScatteringData>\n        </WavelengthDataBlock>\n      </WavelengthData>\n    "
          "</Layer>\n"
          "  </Optical>\n</WindowElement>\n";
  return text.str();
}

}  // namespace vcavity::tools
