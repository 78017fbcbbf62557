// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <cmath>
#include <memory>
#include <sstream>
#include <string>
#include <vcavity/conventions.hpp>
#include <vector>

#include "tools/commands/commands.hpp"
#include "tools/commands/options.hpp"
#include "tools/commands/surface_options.hpp"
#include "tools/images/atomic_file.hpp"
#include "tools/materials/provenance.hpp"
#include "tools/support/error.hpp"

namespace vcavity::tools {
namespace {

struct ExportOptions {
  SurfaceOptions surfaces;
  std::vector<double> wavelengths_nm{default_wavelength_nm};
  std::string out;
};

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

/// Directions of one patch, each of the same part of its projected solid angle.
/// @param across as many in θ, and in φ
std::vector<Vec3<double>> directions_of(const KlemsRing& ring, int patch, int across) {
  const auto sine2 = [](int degrees_of) {
    const double sine = std::sin(radians(static_cast<double>(degrees_of)));
    return sine * sine;
  };
  const double low = sine2(ring.lower_deg), high = sine2(ring.upper_deg);
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

/// The mean BRDF from patch to patch. The basis of incident light numbers patches by the direction in which the light
/// travels, so that a mirror leads from a patch to the one of the same number.
std::vector<double> klems_matrix(const Surface& surface) {
  constexpr int across_from = 2, across_to = 4;
  const auto from = patches_of_hemisphere(across_from), to = patches_of_hemisphere(across_to);
  std::vector<double> matrix;
  for (const auto& leaving : to) {
    for (const auto& travelling : from) {
      double sum = 0;
      for (const Vec3<double>& t : travelling) {
        for (const Vec3<double>& o : leaving) {
          const auto brdf = surface.brdf({-t.x, -t.y, t.z}, o);
          if (!brdf)
            throw UsageError("export: a mirror has no BRDF; a rough or a matte surface can be exported");
          sum += brdf->value.unpolarized;
        }
      }
      matrix.push_back(sum / static_cast<double>(travelling.size() * leaving.size()));
    }
  }
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

/// The file that Radiance and WINDOW read: "BSDF XML".
std::string radiance_xml(const SurfaceAtWavelength& at, const std::vector<double>& matrix) {
  std::ostringstream text;
  text << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<WindowElement xmlns=\"http://windows.lbl.gov\" "
          "xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" "
          "xsi:schemaLocation=\"http://windows.lbl.gov/BSDF-v1.4.xsd\">\n"
       << "  <WindowElementType>System</WindowElementType>\n  <FileType>BSDF</FileType>\n  <Optical>\n    "
          "<Layer>\n      <Material>\n"
       << "        <Name>" << escaped(material_of(at.surface) + ", " + in_words(at.surface)) << ", "
       << at.wavelength_nm << " nm</Name>\n        <Manufacturer>"
       << escaped(software() + ": " + command_line())
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

void run_export(const ExportOptions& options) {
  const auto surfaces = surfaces_at(options.surfaces, options.wavelengths_nm);
  if (surfaces.size() != 1)
    throw UsageError("export writes one surface at one wavelength; take one value of each option");
  AtomicFile file(options.out);
  const auto surface =
      make_surface(surfaces[0].surface, surfaces[0].wavelength_nm, {Polarization::none, all_bounces});
  file.write(radiance_xml(surfaces[0], klems_matrix(*surface)));
  file.commit();
}

}  // namespace

void add_export_command(CLI::App& program) {
  const auto options = std::make_shared<ExportOptions>();
  CLI::App* command = program.add_subcommand(
      "export",
      "the BRDF as a table for other programs: BSDF XML of Radiance and WINDOW, in Klems' full basis");
  add_surface_options(*command, options->surfaces);
  add_wavelengths(*command, options->wavelengths_nm);
  command->add_option("--out", options->out, "file to write, such as surface.xml")
      ->required()
      ->type_name("FILE");
  command->callback([options] { run_export(*options); });
}

}  // namespace vcavity::tools
