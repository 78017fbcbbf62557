#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that `vgroove` with textures renders at each point what it renders with the numbers of that point.

Textures of two different texels are compared with the constants of either, in samples of the BSDF and, where it has
any, in its values and densities. Ends with status 1 if one differs by more than rounding."""

import argparse
import math
import sys

import mitsuba as mi
import numpy as np

import vgroove

# (parameters, which of them is a texture, its two values)
CASES = [
    ({"material": "Cu"}, "aperture", (70.0, 33.0)),
    ({"material": "Cu"}, "aperture", (180.0, 7.0)),
    ({"material": "Cu", "tilt": 30.0}, "aperture", (90.0, 25.0)),
    ({"eta": 1.5, "aperture": 80.0}, "tilt", (-20.0, 45.0)),
    ({"material": "Ag", "aperture": 50.0}, "rotation", (10.0, 75.0)),
    ({"material": "Cu", "aperture": 60.0, "lobe_width": 8.0}, "aperture", (60.0, 100.0)),
    ({"material": "Au", "aperture": 60.0}, "specular_reflectance", (0.3, 0.9)),
    ({"k": 3.0}, "eta", (0.3, 1.2)),
    ({"material": "Cu", "distribution": "ggx"}, "roughness", (0.2, 0.7)),
    ({"material": "Cu", "distribution": "ggx", "roughness": 0.5}, "specular_reflectance", (0.3, 0.9)),
    ({"material": "Cu", "distribution": "beckmann", "alpha_v": 0.4}, "alpha_u", (0.2, 0.6)),
    ({"k": 3.0, "distribution": "brushed", "roughness": 0.4}, "eta", (0.3, 1.2)),
]
DIRECTIONS = 200
# Grooves made for a point by adding angles differ from those made of sines by some roundings for each bounce.
TOLERANCE = 5e-6


def uniform(name, value):
    """What stands for a number; spectra have another type than numbers."""
    return {"type": "uniform", "value": value} if name in ("eta", "specular_reflectance") else value


def two_texels(values):
    texels = np.array(values, np.float32)[None, :, None]
    return {"type": "bitmap", "bitmap": mi.Bitmap(texels), "raw": True, "filter_type": "nearest"}


def observed(bsdf, u, wi, wo, numbers):
    """All that a BSDF says at one point: samples, values, densities."""
    context, results = mi.BSDFContext(), []
    for direction, other, (first, *rest) in zip(wi.tolist(), wo.tolist(), numbers.tolist()):
        si = mi.SurfaceInteraction3f()
        si.wi, si.uv, si.wavelengths = direction, [u, 0.5], np.full(len(np.ravel(si.wavelengths)), 550.0, np.float32)
        sample, weight = bsdf.sample(context, si, first, rest)
        value, density = bsdf.eval_pdf(context, si, mi.Vector3f(other))
        results.append(np.concatenate([np.ravel(part) for part in (sample.wo, [sample.pdf], weight, value, [density])]))
    return np.array(results, dtype=float)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--variant", default="scalar_rgb", help="Mitsuba's scalar variant; scalar_rgb by default")
    parser.add_argument("--plug-in", metavar="FOLDER", default=None, help="where it was built; build/mitsuba by default")
    options = parser.parse_args()
    vgroove.start(options.variant, options.plug_in)
    rng = np.random.default_rng(11)

    def directions():
        z, azimuth = rng.uniform(0.05, 1, DIRECTIONS), rng.uniform(0, 2 * math.pi, DIRECTIONS)
        r = np.sqrt(1 - z * z)
        return np.stack([r * np.cos(azimuth), r * np.sin(azimuth), z], axis=1)

    failed = False
    for parameters, name, values in CASES:
        wi, wo, numbers = directions(), directions(), rng.uniform(size=(DIRECTIONS, 3))
        textured = mi.load_dict({"type": "vgroove", **parameters, name: two_texels(values)})
        worst = 0.0
        for u, value in zip((0.25, 0.75), values):
            constant = mi.load_dict({"type": "vgroove", **parameters, name: uniform(name, value)})
            expected, found = (observed(bsdf, u, wi, wo, numbers) for bsdf in (constant, textured))
            difference = np.abs(found - expected) / (1 + np.abs(expected))
            # A random number within rounding of the border between two lobes draws the other one.
            rows = np.sort(difference.max(axis=1))
            worst = max(worst, rows[-2])
        print(f"{options.variant}: {parameters}, {name} of a texture: differs from constants by {worst:.1g}", flush=True)
        failed |= not worst < TOLERANCE
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
