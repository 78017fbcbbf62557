// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The plug-in registers its variants in translation units of their own: those of Dr.Jit take long to compile.

#include <mitsuba/core/plugin.h>

#include <string_view>
#include <type_traits>

namespace vgroove {

/// @param name of the plug-in
/// @param register_plugin Mitsuba's function
void register_llvm_variants(std::string_view name, mitsuba::PluginRegisterFn register_plugin);

}  // namespace vgroove
