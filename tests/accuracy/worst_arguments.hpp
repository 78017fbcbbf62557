// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The file of the worst arguments that searches have found.

#include <cstdlib>
#include <istream>
#include <ostream>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

#include "accuracy/subject.hpp"

namespace vcavity::test {

template <class Real>
std::string type_name() {
  if constexpr (std::is_same_v<Real, float>) return "float";
  if constexpr (std::is_same_v<Real, double>) return "double";
  return "long double";
}

/// One row of the file of worst arguments: `function;type;argument argument …`, the arguments as hexadecimal
/// floating-point numbers, which lose nothing.
template <class Real>
void write_row(std::ostream& out, const Subject<Real>& subject, const std::vector<Real>& arguments) {
  out << subject.name << ';' << type_name<Real>() << ';';
  std::ostringstream numbers;
  numbers << std::hexfloat;
  for (std::size_t i = 0; i < arguments.size(); ++i)
    numbers << (i == 0 ? "" : " ") << static_cast<long double>(arguments[i]);
  out << numbers.str() << '\n';
}

struct Row {
  std::string function;
  std::string type;
  std::vector<long double> arguments;
};

/// The rows of a file of worst arguments; lines that start with # are comments.
inline std::vector<Row> read_rows(std::istream& in) {
  std::vector<Row> rows;
  std::string line;
  while (std::getline(in, line)) {
    if (line.empty() || line.front() == '#') continue;
    std::istringstream fields(line);
    Row row;
    std::getline(fields, row.function, ';');
    std::getline(fields, row.type, ';');
    std::string number;
    while (fields >> number) row.arguments.push_back(std::strtold(number.c_str(), nullptr));
    rows.push_back(row);
  }
  return rows;
}

}  // namespace vcavity::test
