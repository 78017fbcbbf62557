// SPDX-License-Identifier: BSD-3-Clause
#include "tools/commands/options.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <system_error>
#include <vcavity/groove/lobes.hpp>

#include "tools/support/text_file.hpp"
#include "tools/support/text_table.hpp"

namespace vcavity::tools {
namespace {

std::string in_words(const Interval& interval) {
  const bool open_low = interval.ends != Interval::Ends::closed;
  const bool open_high = interval.ends == Interval::Ends::open_both;
  const bool bounded = std::isfinite(interval.high);
  std::string text = std::string("a number ") + (open_low ? "above " : "from ") + exact(interval.low);
  if (bounded) text += (open_high ? " and below " : " to ") + exact(interval.high);
  return text;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (;;) {
    const auto end = text.find(separator);
    parts.push_back(text.substr(0, end));
    if (end == text.npos) return parts;
    text.remove_prefix(end + 1);
  }
}

/// @param value a double, or an optional one
template <class Value>
CLI::Option* add_checked_number(CLI::App& command, const std::string& name, Value& value,
                                const Interval& interval, const std::string& help) {
  return command.add_option_function<std::string>(
      name,
      [&value, name, interval](const std::string& word) { value = checked_number(word, name, interval); },
      help);
}

/// Refuses a list with nothing between two commas, or before the first or behind the last.
void check_part_of_list(std::string_view part, std::string_view option, std::string_view list) {
  if (part.empty()) throw unexpected(option, list, "something before and behind every comma");
}

}  // namespace

UsageError unexpected(std::string_view option, std::string_view word, const std::string& expected) {
  return UsageError(std::string(option) + ": '" + std::string(word) + "' is not accepted, expected " +
                    expected);
}

double checked_number(std::string_view word, std::string_view option, const Interval& interval) {
  const std::optional<double> value = parse_number(word);
  const bool inside =
      value && (interval.ends == Interval::Ends::closed ? *value >= interval.low : *value > interval.low) &&
      (interval.ends == Interval::Ends::open_both ? *value < interval.high : *value <= interval.high);
  if (!inside) throw unexpected(option, word, in_words(interval));
  return *value;
}

std::vector<double> checked_range(std::string_view words, std::string_view option, const Interval& interval) {
  const auto parts = split(words, ':');
  if (parts.size() != 3) throw unexpected(option, words, "LOW:HIGH:STEP");
  const double low = checked_number(parts[0], option, interval);
  const double high = checked_number(parts[1], option, interval);
  const double step = checked_number(parts[2], option,
                                     {0, std::numeric_limits<double>::infinity(), Interval::Ends::open_both});
  if (high < low) throw unexpected(option, words, "LOW:HIGH:STEP with LOW not above HIGH");
  constexpr double most_steps = 100'000;
  const double steps = std::floor((high - low) / step * (1 + 1e-12) + 1e-9);  // HIGH counts despite rounding
  if (steps > most_steps) throw unexpected(option, words, "at most 100000 steps");
  std::vector<double> values;
  // To 15 digits, as 0.1 + 0.2 is meant to be 0.3.
  for (int i = 0; i <= static_cast<int>(steps); ++i)
    values.push_back(std::clamp(parse_number(with_digits(low + i * step, 15)).value(), low, high));
  return values;
}

std::vector<double> checked_numbers(std::string_view words, std::string_view option,
                                    const Interval& interval) {
  std::vector<double> values;
  for (const std::string_view part : split(words, ',')) {
    if (!words.empty()) check_part_of_list(part, option, words);
    if (part.find(':') == part.npos) {
      values.push_back(checked_number(part, option, interval));
    } else {
      const std::vector<double> range = checked_range(part, option, interval);
      values.insert(values.end(), range.begin(), range.end());
    }
  }
  return values;
}

CLI::Option* add_number(CLI::App& command, const std::string& name, double& value, const Interval& interval,
                        const std::string& help) {
  return add_checked_number(command, name, value, interval, help);
}

CLI::Option* add_number(CLI::App& command, const std::string& name, std::optional<double>& value,
                        const Interval& interval, const std::string& help) {
  return add_checked_number(command, name, value, interval, help);
}

CLI::Option* add_numbers(CLI::App& command, const std::string& name, std::vector<double>& values,
                         const Interval& interval, const std::string& help) {
  return command.add_option_function<std::string>(
      name,
      [&values, name, interval](const std::string& words) {
        values = checked_numbers(words, name, interval);
      },
      help + "; a list A,B,C or a range LOW:HIGH:STEP");
}

CLI::Option* add_direction(CLI::App& command, const std::string& name, std::vector<double>& theta_phi_deg,
                           const std::string& help) {
  return command
      .add_option_function<std::string>(
          name,
          [&theta_phi_deg, name](const std::string& words) {
            const auto parts = split(words, ',');
            if (parts.size() != 2) throw unexpected(name, words, "two angles THETA,PHI");
            theta_phi_deg = {checked_number(parts[0], name, theta_range_deg),
                             checked_number(parts[1], name, azimuth_range_deg)};
          },
          help + "; THETA,PHI in degrees")
      ->type_name("THETA,PHI");
}

CLI::Option* add_count(CLI::App& command, const std::string& name, int& value, int low, int high,
                       const std::string& help) {
  return command.add_option_function<std::string>(
      name,
      [&value, name, low, high](const std::string& word) {
        const std::optional<double> number = parse_number(word);
        if (!number || *number != std::floor(*number) || *number < low || *number > high)
          throw unexpected(name, word,
                           "a whole number from " + std::to_string(low) + " to " + std::to_string(high));
        value = static_cast<int>(*number);
      },
      help);
}

CLI::Option* add_picture(CLI::App& command, const std::string& name, std::string& file,
                         const std::string& help) {
  return command
      .add_option_function<std::string>(
          name,
          [&file, name](const std::string& word) {
            if (!word.ends_with(".png") && !word.ends_with(".svg"))
              throw unexpected(name, word, "the name of a .png or .svg file");
            file = word;
          },
          help + "; PNG or SVG")
      ->type_name("FILE");
}

void add_apertures(CLI::App& command, std::vector<double>& apertures_deg) {
  add_numbers(command, "--aperture", apertures_deg, aperture_range_deg,
              "angles between the panels in degrees, above 0 to 180")
      ->type_name("DEG[,DEG...]");
}

void add_wavelength(CLI::App& command, double& wavelength_nm) {
  add_number(command, "--wavelength", wavelength_nm, wavelength_range_nm,
             "vacuum wavelength in nanometres (default " + exact(wavelength_nm) + ")")
      ->type_name("NM");
}

CLI::Option* add_wavelengths(CLI::App& command, std::vector<double>& wavelengths_nm) {
  return add_numbers(command, "--wavelength", wavelengths_nm, wavelength_range_nm,
                     "vacuum wavelengths in nanometres, each on its own (default " +
                         exact(default_wavelength_nm) + ")")
      ->type_name("NM[,NM...]");
}

void add_format(CLI::App& command, Format& format) {
  add_choice(command, "--format", format, {{"md", Format::md}, {"csv", Format::csv}, {"json", Format::json}},
             "how to print the results; md is Markdown (default md)");
}

namespace {

const std::string material_help =
    "a name (see 'vcavity_maps materials'), a file of refractiveindex.info, or an index such as 1.5 or "
    "0.1249+3.3391i";

}  // namespace

std::vector<std::string> split_list(const std::string& words, std::string_view option) {
  if (std::error_code ignored; std::filesystem::exists(words, ignored)) return {words};
  std::vector<std::string> parts(1);
  bool quoted = false;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool escapes =
        words[i] == '\\' && i + 1 < words.size() && (words[i + 1] == ',' || words[i + 1] == '"');
    if (escapes) {
      parts.back() += words[++i];
    } else if (words[i] == '"') {
      quoted = !quoted;
    } else if (words[i] == ',' && !quoted) {
      parts.emplace_back();
    } else {
      parts.back() += words[i];
    }
  }
  if (quoted) throw unexpected(option, words, "a second quotation mark");
  for (const std::string& part : parts) check_part_of_list(part, option, words);
  return parts;
}

void add_materials(CLI::App& command, std::vector<std::string>& specifications) {
  command
      .add_option_function<std::vector<std::string>>(
          "--material",
          [&specifications](const std::vector<std::string>& lists) {
            specifications.clear();
            for (const std::string& list : lists)
              for (std::string& one : split_list(list, "--material"))
                specifications.push_back(std::move(one));
          },
          material_help +
              "; several separated by commas, or repeat it. A comma in the name of a file is written \\,")
      ->type_name(materials_placeholder)
      ->allow_extra_args(false);
}

void add_missing_k(CLI::App& command, MissingExtinction& missing) {
  add_choice(command, "--missing-k", missing,
             {{"refuse", MissingExtinction::refused}, {"zero", MissingExtinction::zero}},
             "what k is where a file gives n but, having k elsewhere, no k: refuse the wavelength (default), "
             "or zero");
}

void add_polarization(CLI::App& command, Polarization& model) {
  add_choice(
      command, "--polarization", model,
      {{"none", Polarization::none}, {"separate", Polarization::separate}, {"full", Polarization::full}},
      "none: light is unpolarised at every bounce (the paper's model, default); separate: s and p on their "
      "own; full: exact");
}

void add_effects(CLI::App& command, EffectsOptions& effects) {
  CLI::Option* choice = add_choice(
      command, "--effects", effects.automatic, {{"given", false}, {"auto", true}},
      "given: as the other options say (default); auto: the full physics within --tolerance, and no "
      "more than that takes");
  choice->excludes("--polarization")->excludes("--max-bounces");
  command.add_flag("--explain", effects.explain, "say what --effects auto would choose, and stop")
      ->needs(choice);
}

void add_max_bounces(CLI::App& command, int& max_bounces) {
  add_count(command, "--max-bounces", max_bounces, 1, std::numeric_limits<int>::max(),
            "leave out light that needs more bounces (default: all bounces)")
      ->type_name("K");
}

}  // namespace vcavity::tools
