#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Compares the Mueller matrices of rough surfaces, after one bounce, with those of Mitsuba's `roughconductor`.

One bounce is a reflection in the plane of both directions, whatever the model of the facets' slopes and shadows: the
matrices of both must agree up to a factor, in both transport directions and however the grooves are turned. Ends with
status 1 if elements differ by more than rounding."""

import argparse
import math
import sys

import mitsuba as mi
import numpy as np

import vgroove

DIRECTIONS = 500
TOLERANCE = 4e-5  # of elements of matrices whose first one is 1, in float, after two rotations of their axes
LEAST = 1e-30  # smaller values have few digits in float
SURFACES = [
    {"distribution": "ggx", "roughness": 0.5},
    {"distribution": "ggx", "alpha_u": 0.3, "alpha_v": 0.6, "rotation": 35.0},
    {"distribution": "beckmann", "roughness": 0.4, "rotation": -70.0},
]


def directions(rng):
    z, azimuth = rng.uniform(0.1, 1, DIRECTIONS), rng.uniform(0, 2 * math.pi, DIRECTIONS)
    r = np.sqrt(1 - z * z)
    return np.stack([r * np.cos(azimuth), r * np.sin(azimuth), z], axis=1)


def matrices(bsdf, wi, wo, mode):
    """Mueller matrices at the wavelength 550 nm, of which the first element is 1, or none of which is a number."""
    context, result = mi.BSDFContext(mode), []
    for si, direction in zip(vgroove.interactions(wi, np.full((len(wi), 4), 550.0)), wo.tolist()):
        matrix = np.array(bsdf.eval(context, si, mi.Vector3f(direction)))
        matrix = matrix.reshape(4, 4, -1)[:, :, 0]
        result.append(matrix / matrix[0, 0] if matrix[0, 0] > LEAST else np.full((4, 4), np.nan))
    return np.array(result, dtype=float)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--plug-in", metavar="FOLDER", default=None, help="where it was built; build/mitsuba by default")
    options = parser.parse_args()
    vgroove.start("scalar_spectral_polarized", options.plug_in)
    rng = np.random.default_rng(4)
    failed = False
    for material in ("Cu", "Cr"):
        theirs = mi.load_dict({"type": "roughconductor", "material": material, "distribution": "ggx", "alpha": 0.5})
        for surface in SURFACES:
            ours = mi.load_dict({"type": "vgroove", "material": material, "max_bounces": 1, **surface})
            wi, wo = directions(rng), directions(rng)
            found = np.array([matrices(ours, wi, wo, mode) - matrices(theirs, wi, wo, mode)
                              for mode in (mi.TransportMode.Radiance, mi.TransportMode.Importance)])
            # Between some directions Beckmann's distribution has hardly any light.
            compared = np.isfinite(found).all(axis=(2, 3)).mean()
            largest = np.nanmax(np.abs(found))
            print(f"{material}, {surface}: Mueller matrices of one bounce differ by {largest:.1g} "
                  f"({compared:.0%} of the pairs compared)", flush=True)
            failed |= not (largest < TOLERANCE and compared > 0.8)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
