#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Measures what a surface could save if it knew the lights of its scene.

Under an even sky the albedo is all that counts, and every direction that is drawn may have its weight: what that would
save is the noise of the weights, printed as their standard deviation over their mean, and as the paths per pixel with which
it is 1/255 of the radiance. And where there is no small light, lobes need no width: printed is the time of a plate with a
width of 3° over that of mirror directions. Two Markdown tables."""

import argparse
import math

import mitsuba as mi
import numpy as np

import vgroove

SURFACES = [
    ("copper, 60°", {"material": "Cu", "aperture": 60.0}),
    ("silver, 90°", {"material": "Ag", "aperture": 90.0}),
    ("glass 1.5, 60°", {"eta": 1.5, "aperture": 60.0}),
    ("copper, 60°, tilted by 20°", {"material": "Cu", "aperture": 60.0, "tilt": 20.0}),
    ("copper, GGX 0.3", {"material": "Cu", "distribution": "ggx", "roughness": 0.3}),
    ("copper, GGX 1", {"material": "Cu", "distribution": "ggx", "roughness": 1.0}),
]
VIEWS = 20
STEP = 1 / 255  # of a picture's brightness


def noise_of_weights(bsdf, samples, rng):
    """Root mean square over views of the standard deviation of weights over their mean, in the worst colour."""
    squares = []
    for _ in range(VIEWS):
        z, azimuth = rng.uniform(0.05, 1), rng.uniform(0, 2 * math.pi)
        wi = [math.sqrt(1 - z * z) * math.cos(azimuth), math.sqrt(1 - z * z) * math.sin(azimuth), z]
        weights = vgroove.sampled(bsdf, np.tile(wi, (samples, 1)), rng.uniform(size=(samples, 3)))[2]
        squares.append((weights.var(axis=0) / weights.mean(axis=0)**2).max())
    return math.sqrt(np.mean(squares))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--samples", type=int, default=2000, help="directions drawn per view; 2000 by default")
    parser.add_argument("--plug-in", metavar="FOLDER", default=None, help="where it was built; build/mitsuba by default")
    options = parser.parse_args()
    vgroove.start("scalar_rgb", options.plug_in)
    rng = np.random.default_rng(8)
    print("| surface under an even sky | noise of a path | paths until it is 1/255 |\n|---|---|---|")
    for name, parameters in SURFACES:
        noise = noise_of_weights(mi.load_dict({"type": "vgroove", **parameters}), options.samples, rng)
        print(f"| {name} | {noise:.3f} | {max(1, math.ceil((noise / STEP)**2))} |", flush=True)
    print("\n| surface | time with lobes of 3° / mirror directions |\n|---|---|")
    for name, parameters in SURFACES:
        if "distribution" not in parameters:
            narrow, wide = (mi.load_dict({"type": "vgroove", **parameters, **width}) for width in ({}, {"lobe_width": 3.0}))
            of_narrow, of_wide = vgroove.least_seconds([narrow, wide], 8, 7)
            print(f"| {name} | {of_wide / of_narrow:.1f} |", flush=True)


if __name__ == "__main__":
    main()
