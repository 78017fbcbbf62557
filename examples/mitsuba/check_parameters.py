#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that `vgroove` accepts what its documentation says and refuses the rest with a text that tells why."""

import math
import sys

import mitsuba as mi

import vgroove

ACCEPTED = [
    {},
    {"material": "none"},
    {"k": 3.0},
    {"material": "Cu"},
    {"material": "Cu", "tolerance": 0.01},
    {"material": "Cu", "effects": "full", "max_bounces": 2},
    {"material": "Cu", "effects": "paper"},
    {"material": "Cu", "effects": "auto", "tolerance": 1e-6},
    {"material": "Cu", "groove_axis": [0.0, 1.0, 1.0], "specular_reflectance": 0.5},
    {"material": "Cu", "aperture": {"type": "checkerboard", "color0": 30.0, "color1": 90.0}, "tolerance": 0.01},
    {"eta": {"type": "mesh_attribute", "name": "vertex_n"}, "k": 3.0, "tolerance": 0.01},
    {"material": "Cu", "rotation": {"type": "mesh_attribute", "name": "vertex_angle"}, "tolerance": 0.01},
    {"material": "Cu", "aperture": {"type": "mesh_attribute", "name": "vertex_aperture"}, "tolerance": 0.01},
    {"material": "Cu", "aperture": 180.0, "rotation": -30.0, "max_bounces": 1, "polarized": True, "lobe_width": 2.0},
    {"material": "Cu", "aperture": 60.0, "tilt": -59.9, "tolerance": 0.01},
    {"material": "Cu", "aperture": 60.0, "tilt": {"type": "checkerboard", "color0": 0.1, "color1": 0.9}, "tolerance": 0.01},
    {"material": "Cu", "aperture": {"type": "checkerboard", "color0": 3.0, "color1": 9.0}, "tilt": 80.0, "lobe_width": 2.0},
    {"material": "Cu", "aperture": 60.0, "tilt": {"type": "mesh_attribute", "name": "vertex_tilt"}, "tolerance": 0.01},
    {"material": "Cu", "specular_reflectance": {"type": "checkerboard", "color0": 0.1}, "tolerance": 0.01},
    {"eta": 1.5},
    {"eta": {"type": "spectrum", "value": 0.2}, "k": {"type": "spectrum", "value": 3.9}, "max_bounces": -1},
    {"material": "Cu", "distribution": "ggx", "roughness": 0.5},
    {"material": "Cu", "distribution": "ggx", "polarized": True},
    {"material": "Cu", "distribution": "beckmann", "alpha_u": 0.5, "alpha_v": 0.1, "max_bounces": 3},
    {"material": "Cu", "distribution": "brushed", "roughness": {"type": "checkerboard", "color0": 0.1}, "concentration": 0.0},
]
REFUSED = [
    ({"material": "Cu", "eta": 1.5}, "either a material or eta and k"),
    ({"material": "none", "aperture": 200.0}, "aperture must lie in [1e-06, 180], not be 200"),
    ({"material": "Cu", "aperture": 0.0}, "aperture must lie in [1e-06, 180], not be 0"),
    ({"material": "Cu", "aperture": math.nan}, "aperture must lie in [1e-06, 180], not be nan"),
    ({"aperture": {"type": "checkerboard", "color0": 0.0, "color1": 0.9}}, "aperture must lie in [1e-06, 180], not be 0"),
    ({"aperture": {"type": "checkerboard", "color0": 1e-8, "color1": 0.9}}, "aperture must lie in"),
    ({"aperture": 60.0, "tilt": 60.0}, "tilt of grooves of aperture 60 must lie in [-59.99, 59.99], not be 60"),
    ({"aperture": 60.0, "tilt": -100.0}, "tilt must lie in [-90, 90], not be -100"),
    ({"aperture": 60.0, "tilt": math.nan}, "tilt must lie in [-90, 90], not be nan"),
    ({"aperture": 180.0, "tilt": 0.0}, "tilted grooves must have an aperture of at most 179.98, not 180"),
    ({"aperture": {"type": "checkerboard", "color0": 20.0, "color1": 100.0}, "tilt": 45.0}, "of aperture 100 must lie in"),
    ({"material": "Cu", "distribution": "ggx", "tilt": 5.0}, "aperture, tilt and lobe_width are for parallel grooves"),
    ({"material": "Cu", "rotation": math.inf}, "rotation must lie in"),
    ({"material": "Cu", "groove_axis": [0.0, 0.0, 0.0]}, "groove_axis must be a direction"),
    ({"material": "Cu", "tolerance": 0.0}, "tolerance must be positive, not 0"),
    ({"material": "Cu", "effects": "all"}, "effects must be full, paper or auto, not all"),
    ({"material": "Cu", "effects": "full", "tolerance": 0.1}, "tolerance is for effects = auto, not full"),
    ({"material": "Cu", "effects": "paper", "polarized": True}, "either effects or polarized"),
    ({"material": "Cu", "tolerance": 0.1, "max_bounces": 2}, "either tolerance or max_bounces"),
    ({"material": "Cu", "max_bounces": 0}, "must be positive or -1, not 0"),
    ({"material": "Cu", "lobe_width": -1.0}, "the width of a lobe"),
    ({"material": "Cu", "distribution": "phong"}, "must be ggx, beckmann or brushed, not phong"),
    ({"material": "Cu", "roughness": 0.5}, "give a distribution"),
    ({"material": "Cu", "distribution": "ggx", "aperture": 60.0}, "aperture, tilt and lobe_width are for parallel grooves"),
    ({"material": "Cu", "distribution": "ggx", "alpha_u": 0.5}, "either a roughness or both alpha_u and alpha_v"),
    ({"material": "Cu", "distribution": "ggx", "roughness": 0.0}, "roughness must lie in [0.001, 10], not be 0"),
    ({"material": "Cu", "distribution": "brushed", "alpha_u": 0.5, "alpha_v": 0.5}, "brushed takes a roughness"),
    ({"material": "Cu", "distribution": "brushed", "concentration": -1.0}, "concentration"),
    ({"material": "unobtainium"}, "unobtainium"),
    ({"material": "Cu", "apperture": 60.0}, "apperture"),
]


# Of the vectorised variants only.
REFUSED_VECTORISED = [
    ({"material": "Cu", "aperture": 1.0}, "an aperture must not be less than 2"),
    ({"material": "Cu", "distribution": "ggx", "polarized": True}, "do not follow polarisation in vectorised variants"),
]


VARIANTS = ("scalar_rgb", "scalar_spectral", "scalar_spectral_polarized", "llvm_ad_rgb", "llvm_ad_spectral",
            "llvm_ad_spectral_polarized")


def main():
    """Arguments: the folder of the plug-in, and the variants, all of its usual ones by default."""
    for variant in sys.argv[2:] or VARIANTS:
        try:
            mi.set_variant(variant)
        except ImportError as error:
            print(f"left out: {variant} does not start: {error}")
            continue
        vgroove.load(sys.argv[1] if len(sys.argv) > 1 else None)
        vectorised = vgroove.is_vectorised()
        for parameters in ACCEPTED:
            scalar_only = "mesh_attribute" in str(parameters.get("aperture")) or (
                "distribution" in parameters and "polarized" in parameters)
            if not (vectorised and scalar_only):
                mi.load_dict({"type": "vgroove", **parameters})
        for parameters, reason in REFUSED + (REFUSED_VECTORISED if vectorised else []):
            try:
                mi.load_dict({"type": "vgroove", **parameters})
            except RuntimeError as error:
                if reason not in str(error):
                    raise SystemExit(f"{variant}: {parameters} was refused, but with: {error}")
            else:
                raise SystemExit(f"{variant}: {parameters} was accepted")


if __name__ == "__main__":
    main()
