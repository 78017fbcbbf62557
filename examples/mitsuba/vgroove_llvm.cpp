// SPDX-License-Identifier: BSD-3-Clause

/// Registers the vectorised variants of `vgroove` that run on processors through LLVM.

#include "make_rough_lanes.hpp"
#include "register.hpp"
#include "vgroove_lanes.hpp"

void vgroove::register_llvm_variants(std::string_view name, mitsuba::PluginRegisterFn register_plugin) {
  using namespace mitsuba;
  const auto add = [&]<typename Float, typename Spectrum>(std::type_identity<BSDF<Float, Spectrum>>) {
    register_plugin(name, BSDF<Float, Spectrum>::Variant, ObjectType::BSDF,
                    [](void*, const Properties& props) -> ref<Object> {
                      const GrooveParameters<Float, Spectrum> parameters(props);
                      if (parameters.is_rough()) return make_rough_lanes(props, parameters);
                      return new VGrooveLanes<Float, Spectrum>(props, parameters);
                    });
  };
  using Float = drjit::DiffArray<JitBackend::LLVM, float>;
  using Wavelengths = Spectrum<Float, 4>;
  add(std::type_identity<BSDF<Float, Color<Float, 3>>>());
  add(std::type_identity<BSDF<Float, Wavelengths>>());
  add(std::type_identity<BSDF<Float, MuellerMatrix<Wavelengths>>>());
}
