// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <system_error>
#include <tuple>
#include <utility>
#include <vcavity/vcavity.hpp>

#include "tools/commands/commands.hpp"
#include "tools/commands/options.hpp"
#include "tools/commands/paper_tables.hpp"
#include "tools/images/colour_map.hpp"
#include "tools/images/sheet.hpp"
#include "tools/maps/disc_map.hpp"
#include "tools/maps/map_picture.hpp"
#include "tools/materials/catalogue.hpp"
#include "tools/materials/provenance.hpp"
#include "tools/support/text_table.hpp"

namespace vcavity::tools {
namespace {

constexpr std::array<int, 6> apertures_deg{45, 60, 90, 120, 150, 180};  // Fig. 5
constexpr int paper_fig6_aperture_deg = 45;

struct PaperOptions {
  std::filesystem::path out = "paper";
  int size = 512;
};

/// Copper from 400 to 700 nm in steps of 5 nm.
std::vector<double> visible_grid_nm() {
  std::vector<double> result;
  for (int nm = 400; nm <= 700; nm += 5) result.push_back(nm);
  return result;
}

struct NamedMap {
  std::string file;
  std::string label;
  DiscMapper mapper;
};

DiscMapper mapper_for(const char* material, int aperture_deg, int size, std::vector<double> wavelengths_nm,
                      int max_bounces = all_bounces) {
  return DiscMapper({{load_material(material), static_cast<double>(aperture_deg)},
                     std::move(wavelengths_nm),
                     size,
                     max_bounces,
                     Quantity::reflectance,
                     Spectrum::colour_only});
}

std::string in_degrees(int angle_deg) {
  return std::to_string(angle_deg) + "°";
}

/// The CIE lightness L* of every pixel of a grey map, relative to a perfect reflector.
void add_lightness(ExrImage& image) {
  const Xyz white{1, 1, 1};
  ExrChannel lightness{"CIELAB.L", {}};
  for (const float y : image.plane("Y")) {
    const double luminance = static_cast<double>(y);
    lightness.plane.push_back(static_cast<float>(to_lab({luminance, luminance, luminance}, white).lightness));
  }
  image.channels.push_back(std::move(lightness));
}

/// Everything that `paper` writes.
class Paper {
 public:
  explicit Paper(const PaperOptions& options)
      : folder_(options.out), size_(options.size), progress_(static_cast<std::uint64_t>(14 * options.size)) {
    std::error_code error;
    std::filesystem::create_directories(folder_, error);
    if (error) throw std::runtime_error("cannot write '" + folder_.string() + "': " + error.message());
  }

  void write() {
    AtomicFile report(folder_ / "report.md");
    draw_glass();
    draw_copper();
    draw_silver();
    const PaperTables tables = compute_paper_tables();
    write_text(folder_ / "table1.md", to_markdown(tables.table1));
    write_text(folder_ / "table2.md", to_markdown(tables.table2));
    write_text(folder_ / "table1.csv", to_csv(tables.table1, tables.provenance));
    write_text(folder_ / "table2.csv", to_csv(tables.table2, tables.provenance));
    report.write(paper_report(tables));
    report.commit();
    std::cout << "The figures, tables and report.md are in " << folder_.string() << '\n';
  }

 private:
  ExrImage computed(const DiscMapper& mapper) { return compute_map(mapper, progress_); }

  void save(const Sheet& sheet, const char* name) {
    AtomicFile file(folder_ / name);
    write_sheet(file, sheet);
    file.commit();
  }

  void draw_glass() {
    Sheet sheet;
    sheet.title = "Hemispherical-directional reflectance of glass grooves, n = 1.5";
    sheet.subtitle = {"Diffuse light, seen from every direction: the grooves run upwards in the picture."};
    sheet.colour_bar =
        ColourBar{ColourMap::viridis, 0, 10, "reflectance in % (10 and above in the last colour)"};
    for (const int aperture_deg : apertures_deg) {
      ExrImage image = computed(mapper_for(paper_glass_index, aperture_deg, size_, {default_wavelength_nm}));
      add_lightness(image);
      write_exr(folder_ / ("fig5_glass_" + std::to_string(aperture_deg) + "deg.exr"), image);
      sheet.discs.push_back(scalar_disc(image, "aperture " + in_degrees(aperture_deg), *sheet.colour_bar));
    }
    sheet.grid = AngleGrid::shown;
    sheet.footnote = footnote();
    save(sheet, "fig5_glass.png");
  }

  void draw_copper() {
    const Material copper = load_material("Cu");
    Sheet sheet;
    sheet.title = "Colour of copper grooves in diffuse daylight";
    sheet.subtitle = {"Spectrum 400-700 nm in steps of 5 nm, CIE 1931 2° observer, D65, sRGB. " +
                      in_one_line(copper)};
    for (const int aperture_deg : apertures_deg) {
      const ExrImage image = computed(mapper_for("Cu", aperture_deg, size_, visible_grid_nm()));
      write_exr(folder_ / ("fig5_copper_" + std::to_string(aperture_deg) + "deg.exr"), image);
      sheet.discs.push_back(colour_disc(image, "aperture " + in_degrees(aperture_deg)));
    }
    sheet.grid = AngleGrid::shown;
    sheet.footnote = footnote();
    save(sheet, "fig5_copper.png");
  }

  void draw_silver() {
    Sheet sheet;
    sheet.title = "Silver grooves of 45° at 550 nm";
    sheet.subtitle = {"n = 0.1249 + 3.3391i; hemispherical-directional reflectance"};
    sheet.colour_bar = ColourBar{ColourMap::viridis, 0, 100, "reflectance in %"};
    for (const auto& [most, name, label] : {std::tuple(1, "one_bounce", "one bounce only"),
                                            std::tuple(all_bounces, "all_bounces", "all bounces")}) {
      const ExrImage image = computed(
          mapper_for(paper_silver_index, paper_fig6_aperture_deg, size_, {default_wavelength_nm}, most));
      write_exr(folder_ / (std::string("fig6_silver_45deg_") + name + ".exr"), image);
      sheet.discs.push_back(scalar_disc(image, label, *sheet.colour_bar));
    }
    sheet.grid = AngleGrid::shown;
    sheet.footnote = footnote();
    sheet.width = 900;
    save(sheet, "fig6_silver.png");
  }

  static std::string footnote() { return software() + ", " + command_line(); }

  std::filesystem::path folder_;
  int size_;
  Progress progress_;
};

}  // namespace

void add_paper_command(CLI::App& program) {
  auto options = std::make_shared<PaperOptions>();
  CLI::App* command = program.add_subcommand(
      "paper",
      "the figures and tables of Saint-Pierre, Simonot & Hebert (2019), computed exactly, and a report");
  command->add_option("--out", options->out, "the folder to write into, made if missing (default paper)")
      ->type_name("DIR");
  add_count(*command, "--size", options->size, 16, 4096, "pixels along one side of a map (default 512)")
      ->type_name("N");
  command->callback([options] { Paper(*options).write(); });
}

}  // namespace vcavity::tools
