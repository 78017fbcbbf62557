// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// What the options of the commands have in common: checked numbers, lists and grids of them, output formats.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tools/materials/facet.hpp"
#include "tools/support/error.hpp"
#include "tools/support/report.hpp"

namespace vcavity::tools {

/// An interval that an option must lie in.
struct Interval {
  double low;
  double high;
  enum class Ends { closed, open_low, open_both } ends = Ends::closed;
};

inline constexpr Interval aperture_range_deg{0, 180, Interval::Ends::open_low};
inline constexpr Interval theta_range_deg{0, 90};
inline constexpr Interval azimuth_range_deg{-360, 360};
inline constexpr Interval wavelength_range_nm{0, 1e12, Interval::Ends::open_low};
inline constexpr Interval film_range_nm{0, 1e6};
inline constexpr int largest_map = 32768;  ///< pixels along one side

/// Wavelength at which tabulated materials are taken unless the user says otherwise; the paper's.
inline constexpr double default_wavelength_nm = 550;

/// The number that a word of the user stands for.
/// @param option its name, for the error
/// Throws UsageError "OPTION: 'WORD' ..., expected ..." unless it is a finite number inside the interval.
double checked_number(std::string_view word, std::string_view option, const Interval& interval);

/// Numbers separated by commas, each in the interval; `LOW:HIGH:STEP` stands for all of a range.
/// Throws UsageError as checked_number().
std::vector<double> checked_numbers(std::string_view words, std::string_view option,
                                    const Interval& interval);

/// The numbers of `LOW:HIGH:STEP`, HIGH included where the steps meet it. Throws UsageError as
/// checked_number().
std::vector<double> checked_range(std::string_view words, std::string_view option, const Interval& interval);

/// Adds an option with a number in an interval.
CLI::Option* add_number(CLI::App& command, const std::string& name, double& value, const Interval& interval,
                        const std::string& help);

/// Adds an option with an optional number in an interval.
CLI::Option* add_number(CLI::App& command, const std::string& name, std::optional<double>& value,
                        const Interval& interval, const std::string& help);

/// Adds an option with a list of numbers in an interval, see checked_numbers(), that replaces `values`.
CLI::Option* add_numbers(CLI::App& command, const std::string& name, std::vector<double>& values,
                         const Interval& interval, const std::string& help);

/// Adds an option with a direction on the hemisphere, `THETA,PHI` in degrees, that replaces `theta_phi_deg`.
CLI::Option* add_direction(CLI::App& command, const std::string& name, std::vector<double>& theta_phi_deg,
                           const std::string& help);

/// Adds an option with a whole number in [low, high].
CLI::Option* add_count(CLI::App& command, const std::string& name, int& value, int low, int high,
                       const std::string& help);

/// Adds an option with the name of a picture to write; what the help says about it ends in its two formats.
CLI::Option* add_picture(CLI::App& command, const std::string& name, std::string& file,
                         const std::string& help);

/// Adds --aperture, in degrees, for one or several.
void add_apertures(CLI::App& command, std::vector<double>& apertures_deg);

/// Adds --wavelength, in nanometres; `wavelength_nm` is its default.
void add_wavelength(CLI::App& command, double& wavelength_nm);

/// Adds --wavelength for one or several, each on its own.
CLI::Option* add_wavelengths(CLI::App& command, std::vector<double>& wavelengths_nm);

/// The error for a word that an option does not accept.
UsageError unexpected(std::string_view option, std::string_view word, const std::string& expected);

/// Adds an option that takes one of a few words, which the help and shell completion then know.
/// @param choices the words, without capitals, and what they stand for; see choices_of()
template <class Choice>
CLI::Option* add_choice(CLI::App& command, const std::string& name, Choice& value,
                        const std::vector<std::pair<std::string, Choice>>& choices, const std::string& help) {
  std::string words;
  for (const auto& [word, choice] : choices) words += (words.empty() ? "" : "|") + word;
  return command
      .add_option_function<std::string>(
          name,
          [&value, name, choices](const std::string& word) {
            std::string expected;
            for (const auto& [known, choice] : choices) {
              if (word == known) {
                value = choice;
                return;
              }
              expected += (expected.empty() ? "" : known == choices.back().first ? " or " : ", ") + known;
            }
            throw unexpected(name, word, expected);
          },
          help)
      ->type_name(words);
}

/// Adds --format.
void add_format(CLI::App& command, Format& format);

/// How the help shows the value of an option that takes a material, and of one that takes several.
inline constexpr const char* material_placeholder = "M";
inline constexpr const char* materials_placeholder = "M[,M...]";

/// The entries of a list with commas between them. A comma that belongs to an entry is written `\,`, or the entry stands
/// in double quotes; and the name of a file that exists is one entry, whatever is in it.
/// @param option its name, for the error
/// @throws UsageError for an entry that is empty, or a quotation mark without a second one
std::vector<std::string> split_list(const std::string& words, std::string_view option);

/// Adds --material for one or several.
void add_materials(CLI::App& command, std::vector<std::string>& specifications);

/// Adds --missing-k.
void add_missing_k(CLI::App& command, MissingExtinction& missing);

/// Adds --polarization.
void add_polarization(CLI::App& command, Polarization& model);

/// Whether the tool decides which effects to compute.
struct EffectsOptions {
  bool automatic = false;
  bool explain = false;
};

/// Adds --effects and --explain.
void add_effects(CLI::App& command, EffectsOptions& effects);

/// Adds --max-bounces; unlimited unless given.
void add_max_bounces(CLI::App& command, int& max_bounces);

}  // namespace vcavity::tools
