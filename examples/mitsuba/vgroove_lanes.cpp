// SPDX-License-Identifier: BSD-3-Clause

/// Registers the vectorised variants of `vgroove` of one backend of Dr.Jit, `VGROOVE_BACKEND`: LLVM for processors, CUDA
/// for NVIDIA's GPUs. The kernels of either are made at run time, so both compile like any C++.

#include "vgroove_lanes.hpp"
#include "make_rough_lanes.hpp"
#include "register.hpp"

template <JitBackend backend>
void vgroove::register_vectorised_variants(std::string_view name, mitsuba::PluginRegisterFn register_plugin) {
  using namespace mitsuba;
  const auto add = [&]<typename Float, typename Spectrum>(std::type_identity<BSDF<Float, Spectrum>>) {
    register_plugin(name, BSDF<Float, Spectrum>::Variant, ObjectType::BSDF,
                    [](void*, const Properties& props) -> ref<Object> {
                      const GrooveParameters<Float, Spectrum> parameters(props);
                      if (parameters.is_rough()) return make_rough_lanes(props, parameters);
                      return new VGrooveLanes<Float, Spectrum>(props, parameters);
                    });
  };
  using Float = drjit::DiffArray<backend, float>;
  using Wavelengths = Spectrum<Float, 4>;
  add(std::type_identity<BSDF<Float, Color<Float, 3>>>());
  add(std::type_identity<BSDF<Float, Wavelengths>>());
  add(std::type_identity<BSDF<Float, MuellerMatrix<Wavelengths>>>());
}

template void vgroove::register_vectorised_variants<JitBackend::VGROOVE_BACKEND>(std::string_view,
                                                                                 mitsuba::PluginRegisterFn);
