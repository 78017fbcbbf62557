// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "tools/commands/bsdf_files.hpp"
#include "tools/commands/commands.hpp"
#include "tools/commands/options.hpp"
#include "tools/commands/surface_options.hpp"
#include "tools/images/atomic_file.hpp"
#include "tools/support/error.hpp"

namespace vcavity::tools {
namespace {

struct ExportOptions {
  SurfaceOptions surfaces;
  std::vector<double> wavelengths_nm{default_wavelength_nm};
  std::string out;
};

bool is_isotropic(const SurfaceDescription& surface) {
  return surface.roughness && surface.roughness->distribution != Roughness::Distribution::brushed &&
         surface.roughness->along_x == surface.roughness->along_y;
}

void run_export(ExportOptions options) {
  std::sort(options.wavelengths_nm.begin(), options.wavelengths_nm.end());
  const auto surfaces = surfaces_at(options.surfaces, options.wavelengths_nm);
  if (surfaces.size() != options.wavelengths_nm.size())
    throw UsageError("export writes one surface; take one value of each option but --wavelength");
  const auto write = [&] {
    const std::string extension = std::filesystem::path(options.out).extension().string();
    if (extension == ".xml") return bsdf_xml;
    if (extension == ".bsdf") return measured_tensors;
    if (extension == ".binary") return merl_binary;
    throw UsageError("export writes .xml (Radiance), .bsdf (Mitsuba) and .binary (MERL), not '" +
                     options.out + "'");
  }();
  const SurfaceDescription& description = surfaces[0].surface;
  ExportedSurface exported{material_of(description) + ", " + in_words(description),
                           is_isotropic(description),
                           options.wavelengths_nm,
                           {}};
  for (const SurfaceAtWavelength& at : surfaces)
    exported.spectrum.push_back(
        make_surface(at.surface, at.wavelength_nm, {Polarization::none, all_bounces}));
  const Vec3<double> up{0, 0, 1};
  if (!exported.spectrum.front()->brdf(up, up))
    throw UsageError("export: a mirror has no BRDF, expected a rough or a matte surface");
  AtomicFile file(options.out);
  file.write(write(exported));
  file.commit();
}

}  // namespace

void add_export_command(CLI::App& program) {
  const auto options = std::make_shared<ExportOptions>();
  CLI::App* command = program.add_subcommand(
      "export",
      "the BRDF as a table for other programs: BSDF XML of Radiance and WINDOW in Klems' full basis (.xml), "
      "Mitsuba's `measured` (.bsdf), the format of the MERL database (.binary)");
  add_surface_options(*command, options->surfaces);
  add_wavelengths(*command, options->wavelengths_nm);
  command->add_option("--out", options->out, "file to write, such as surface.xml")
      ->required()
      ->type_name("FILE");
  command->callback([options] { run_export(*options); });
}

}  // namespace vcavity::tools
