// SPDX-License-Identifier: BSD-3-Clause
#include "tools/materials/refractiveindex_info.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <utility>
#include <vector>

#include "tools/materials/dispersion_formula.hpp"
#include "tools/materials/tabulated.hpp"
#include "tools/support/text_file.hpp"
#include "tools/support/utf8.hpp"

namespace vcavity::tools {
namespace {

namespace fs = std::filesystem;

int line_of(const YAML::Node& node) {
  return node.Mark().line + 1;
}

/// Text without HTML tags and line breaks.
std::string plain_text(const std::string& html) {
  std::string text;
  for (std::size_t i = 0; i < html.size(); ++i) {
    const bool tag = html[i] == '<' && i + 1 < html.size() &&
                     (html[i + 1] == '/' || std::isalpha(static_cast<unsigned char>(html[i + 1])));
    const auto close = tag ? html.find('>', i) : html.npos;
    if (close != html.npos) {
      i = close;
    } else if (!std::isspace(static_cast<unsigned char>(html[i]))) {
      text += html[i];
    } else if (!text.empty() && text.back() != ' ') {
      text += ' ';
    }
  }
  if (text.ends_with(' ')) text.pop_back();
  return text;
}

/// Reads the entries of DATA, one after the other, into n and k.
class DataReader {
 public:
  explicit DataReader(const fs::path& file) : file_(file) {}

  void read(const YAML::Node& entry) {
    if (!entry.IsMap())
      throw malformed(file_, line_of(entry), "expected an entry with the keys 'type' and 'data'");
    const YAML::Node type = scalar(entry, "type");
    const auto words = split_words(type.Scalar());
    if (words.size() == 2 && words[0] == "tabulated") {
      if (words[1] == "nk") return read_table(entry, {&n_, &k_});
      if (words[1] == "n") return read_table(entry, {&n_});
      if (words[1] == "k") return read_table(entry, {&k_});
      if (words[1] == "n2") return;  // the nonlinear index: of no use here, and no harm
    }
    if (words.size() == 2 && words[0] == "formula" && words[1].size() == 1 &&
        most_coefficients(words[1][0] - '0')) {
      return read_formula(entry, words[1][0] - '0');
    }
    throw malformed(file_, line_of(type),
                    "unknown type '" + type.Scalar() + "', expected tabulated nk, n or k, or formula 1 to 9");
  }

  std::optional<OpticalConstant> n() const { return n_; }
  std::optional<OpticalConstant> k() const { return k_; }

  /// Which of two sources of n counts; empty if there is one.
  const std::string& preference() const { return preference_; }

 private:
  YAML::Node scalar(const YAML::Node& entry, const std::string& key) const {
    const YAML::Node value = entry[key];
    if (!value) throw malformed(file_, line_of(entry), "the entry has no '" + key + "'");
    if (!value.IsScalar()) throw malformed(file_, line_of(value), "'" + key + "' is not a single text");
    return value;
  }

  enum class Source { table, formula };

  /// Of a table and a formula for n, the table counts.
  void set(std::optional<OpticalConstant>& constant, OpticalConstant value, Source source) {
    if (constant && &constant == &n_ && source != source_of_n_) {
      const bool is_table = source == Source::table;
      const int table = is_table ? value.line : constant->line;
      const int formula = is_table ? constant->line : value.line;
      preference_ = "n from the table on line " + std::to_string(table) + ", not from the formula on line " +
                    std::to_string(formula);
      if (!is_table) return;
      constant.reset();
    }
    if (&constant == &n_) source_of_n_ = source;
    if (constant) {
      throw malformed(file_, value.line,
                      std::string(&constant == &n_ ? "n" : "k") + " was already given by the entry on line " +
                          std::to_string(constant->line));
    }
    constant = std::move(value);
  }

  /// @param columns what the columns after that of the wavelength hold
  void read_table(const YAML::Node& entry, const std::vector<std::optional<OpticalConstant>*>& columns) {
    const YAML::Node data = scalar(entry, "data");
    // yaml-cpp marks a block ("|") where its indicator stands, the line above its content; such texts carry
    // the tag "!".
    const int first_line = line_of(data) + (data.Tag() == "!" ? 1 : 0);
    const auto rows = parse_rows(data.Scalar(), 1 + columns.size(), file_, first_line);
    if (rows.empty()) throw malformed(file_, line_of(data), "the table is empty");
    for (std::size_t column = 0; column < columns.size(); ++column) {
      set(*columns[column], tabulated(rows, column + 1, 1, file_, line_of(entry)), Source::table);
    }
  }

  void read_formula(const YAML::Node& entry, int formula) {
    const YAML::Node coefficient_text = scalar(entry, "coefficients");
    const auto coefficients = parse_numbers(coefficient_text.Scalar(), file_, line_of(coefficient_text));
    const std::size_t most = *most_coefficients(formula);
    if (coefficients.empty() || coefficients.size() > most) {
      throw malformed(file_, line_of(coefficient_text),
                      "formula " + std::to_string(formula) + " takes 1 to " + std::to_string(most) +
                          " coefficients, found " + std::to_string(coefficients.size()));
    }
    if (const auto strength = incomplete_term(formula, coefficients)) {
      throw malformed(file_, line_of(coefficient_text),
                      "the list of coefficients ends in the middle of the term that begins with C" +
                          std::to_string(*strength));
    }
    const YAML::Node range_text = scalar(entry, entry["range"] ? "range" : "wavelength_range");
    const auto range = parse_numbers(range_text.Scalar(), file_, line_of(range_text));
    if (range.size() != 2 || !(0 < range[0] && range[0] <= range[1])) {
      throw malformed(file_, line_of(range_text),
                      "'" + range_text.Scalar() + "' is not a range of two increasing wavelengths above 0");
    }
    const auto index = [formula, coefficients](double wavelength_um) {
      return index_from_formula(formula, coefficients, wavelength_um);
    };
    set(n_, {.at = index, .range = {range[0], range[1]}, .file = file_, .line = line_of(entry)},
        Source::formula);
  }

  const fs::path& file_;
  std::optional<OpticalConstant> n_;
  std::optional<OpticalConstant> k_;
  Source source_of_n_ = Source::table;
  std::string preference_;
};

Material read_document(const YAML::Node& root, const fs::path& file, std::string name,
                       MissingExtinction missing) {
  if (!root.IsMap() || !root["DATA"])
    throw malformed(file, 1, "not a file of refractiveindex.info: there is no key DATA");
  const auto text_at = [&root](const char* key) {
    return root[key] && root[key].IsScalar() ? plain_text(root[key].Scalar()) : std::string();
  };

  const YAML::Node data = root["DATA"];
  DataReader reader(file);
  if (data.IsSequence()) {
    for (const YAML::Node& entry : data) reader.read(entry);
  } else {
    reader.read(data);
  }
  if (!reader.n()) {
    throw malformed(file, line_of(data),
                    reader.k() ? "k is given but n is not" : "DATA gives no refractive index n");
  }
  std::string comments = text_at("COMMENTS");
  if (!reader.preference().empty()) comments += (comments.empty() ? "" : "; ") + reader.preference();
  return Material({.name = std::move(name),
                   .file = file,
                   .reference = text_at("REFERENCES"),
                   .comments = std::move(comments),
                   .n = *reader.n(),
                   .k = reader.k()},
                  missing);
}

}  // namespace

Material read_refractiveindex_info(const fs::path& file, std::string name, MissingExtinction missing) {
  const std::string text = read_text(file);
  if (const auto place = first_not_utf8(text))
    throw malformed(file,
                    1 + static_cast<int>(std::count(
                            text.begin(), text.begin() + static_cast<std::ptrdiff_t>(*place), '\n')),
                    "the text is not UTF-8 but perhaps Latin-1; 'iconv -f latin1 -t utf8' converts it");
  try {
    const YAML::Node root = YAML::Load(text);
    return read_document(root, file, std::move(name), missing);
  } catch (const YAML::Exception& error) {
    throw malformed(file, error.mark.line + 1, error.msg);
  }
}

}  // namespace vcavity::tools
