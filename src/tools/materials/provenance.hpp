// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Where numbers come from: what every output says about itself.

#include <string>
#include <vector>

#include "tools/materials/material.hpp"
#include "tools/support/report.hpp"

namespace vcavity::tools {

/// Remembers the command line for provenance; called once by main().
void remember_command_line(int argc, const char* const* argv);

/// The command line, with the program's name in place of its path.
const std::string& command_line();

/// "vcavity 1.2.3"
std::string software();

/// Material and source in one line, such as "Cu-Johnson: P. B. Johnson and R. W. Christy, ...".
std::string in_one_line(const Material& material);

/// Says in a report what it is computed from and by which command; each material once.
void tell_origin(Report& report, const std::vector<Material>& materials);

/// The lines with which every CSV starts.
std::vector<std::string> provenance_lines(const Material& material);

}  // namespace vcavity::tools
