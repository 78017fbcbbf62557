// SPDX-License-Identifier: BSD-3-Clause

/// `vgroove`: a BSDF plug-in for Mitsuba 3, specular V-grooves with all their bounces.
///
/// Parameters:
///  - `material`     name of one of Mitsuba's materials ("Cu", "Ag", …), "none" for a perfect mirror, the default; or
///  - `eta`, `k`     spectra of the index n + ik; k = 0, the default next to eta, reflects like a dielectric
///  - `specular_reflectance`  factor on the reflectance of each bounce, up to 1, also a texture; 1 by default
///  - `aperture`     angle between the panels in degrees, in [1e-6, 180], a number or a texture; 60 by default
///  - `tilt`         of the bisector of the panels in degrees, from the normal towards the direction across the groove,
///                   below (180 − aperture)/2 either way, a number or a texture; 0 by default
///  - `rotation`     degrees from the axis of reference to the groove, counter-clockwise about the normal, a number or a
///                   texture; 0 by default
///  - `groove_axis`  axis of reference in the world, as far as it lies in the surface; ∂p/∂u by default
///  - `max_bounces`  light that needs more bounces is lost; −1, the default, follows all
///  - `polarized`    whether fields are followed through the groove, or light counts as unpolarised at
///                   each bounce; true in polarised variants, false, like Mitsuba, in others; rough surfaces in scalar
///                   variants only
///  - `effects`      full: fields and all bounces; paper: no fields, all bounces; auto: what `tolerance` calls for
///  - `tolerance`    largest error of the radiance, for light of radiance 1, that may come from what is left out;
///                   0.001 by default with effects = auto, which it implies
///  - `distribution` ggx, beckmann or brushed: patches of grooves of many apertures and directions, instead of an
///                   aperture (rough_bsdf.hpp); brushed ones run along the axis of reference
///  - `roughness`    or `alpha_u`, `alpha_v`: as renderers define it, a number or a texture, in [0.001, 10]; 0.3
///  - `concentration` κ of the azimuths of brushed grooves about that axis, in [0, 1e6]; 100 by default
///  - `lobe_width`   spread of each mirror direction in degrees (spread_bsdf.hpp); 0 by default
///
/// One-sided, like `conductor`. Built for the scalar variants, for those of LLVM, and on request for those of CUDA.

#include <mitsuba/core/plugin.h>

#include <type_traits>

#include "register.hpp"
#include "vgroove_bsdf.hpp"

/// Registers the variants; Mitsuba calls it when it loads the plug-in.
extern "C" MI_EXPORT void init_plugin(std::string_view name, mitsuba::PluginRegisterFn register_plugin) {
  using namespace mitsuba;
  const auto add = [&]<typename Float, typename Spectrum>(std::type_identity<BSDF<Float, Spectrum>>) {
    register_plugin(name, BSDF<Float, Spectrum>::Variant, ObjectType::BSDF,
                    [](void*, const Properties& props) -> ref<Object> {
                      const GrooveParameters<Float, Spectrum> parameters(props);
                      return with_types(parameters, [&]<class... Types>(Types...) -> ref<Object> {
                        return new VGroove<Float, Spectrum, Types...>(props, parameters);
                      });
                    });
  };
  using Wavelengths = Spectrum<float, 4>;
  add(std::type_identity<BSDF<float, Color<float, 3>>>());
  add(std::type_identity<BSDF<float, Wavelengths>>());
  add(std::type_identity<BSDF<float, MuellerMatrix<Wavelengths>>>());
  vgroove::register_vectorised_variants<JitBackend::LLVM>(name, register_plugin);
#ifdef VGROOVE_WITH_CUDA
  vgroove::register_vectorised_variants<JitBackend::CUDA>(name, register_plugin);
#endif
}
