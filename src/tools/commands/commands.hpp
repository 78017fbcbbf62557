// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The commands of vcavity_maps. Each function adds one to the program, with its options, and runs it when
/// the user asks for it.

#include <CLI/CLI.hpp>

namespace vcavity::tools {

/// `paper`: the figures and tables of Saint-Pierre, Simonot and Hébert (2019), and a report on them.
void add_paper_command(CLI::App& program);

/// `map`: a hemisphere of directions as an OpenEXR image.
void add_map_command(CLI::App& program);

/// `table`: bi-hemispherical reflectance for apertures.
void add_table_command(CLI::App& program);

/// `direction`: everything about the light of one direction.
void add_direction_command(CLI::App& program);

/// `export`: the BRDF of a surface as a table for other programs.
void add_export_command(CLI::App& program);

/// `cost`: what accuracy costs in time.
void add_cost_command(CLI::App& program);

/// `materials`: the collection of refractive indices.
void add_materials_command(CLI::App& program);

/// `generate`, hidden: a man page, or completion for a shell, from the definitions of all other commands.
void add_generate_command(CLI::App& program);

}  // namespace vcavity::tools
