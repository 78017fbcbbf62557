// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// The plug-in registers its variants in translation units of their own: those of Dr.Jit take long to compile.

#include <mitsuba/core/plugin.h>

#include <string_view>
#include <type_traits>

namespace vgroove {

/// @tparam backend of Dr.Jit: LLVM, or CUDA where the plug-in is built with it
/// @param name of the plug-in
/// @param register_plugin Mitsuba's function
template <JitBackend backend>
void register_vectorised_variants(std::string_view name, mitsuba::PluginRegisterFn register_plugin);

}  // namespace vgroove
