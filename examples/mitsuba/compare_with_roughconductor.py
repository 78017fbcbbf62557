#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Compares rough `vgroove` with Mitsuba's `roughconductor`, which follows one bounce: how much light they reflect, from
silver-like facets that reflect everything ("none"), and how long a rendering takes. Prints a Markdown table."""

import argparse
import math

import mitsuba as mi
import numpy as np

import vgroove

ROUGHNESSES = (0.05, 0.1, 0.3, 0.6, 1.0)
ANGLES_DEG = (0, 60)


def albedo(bsdf, theta, samples):
    """The mean weight of sampled directions: what is seen in a sky of radiance 1."""
    wi = np.tile([math.sin(theta), 0, math.cos(theta)], (samples, 1))
    return np.mean(vgroove.sampled(bsdf, wi, np.random.default_rng(1).uniform(size=(samples, 3)))[2])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--samples", type=int, default=20_000, help="directions per number; 20000 by default")
    parser.add_argument("--variant", default="scalar_rgb", choices=["scalar_rgb", "llvm_ad_rgb"],
                        help="Mitsuba's variant; scalar_rgb by default")
    parser.add_argument("--plug-in", metavar="FOLDER", default=None, help="where it was built; build/mitsuba by default")
    options = parser.parse_args()
    vgroove.start(options.variant, options.plug_in)
    print("| GGX roughness | θ | roughconductor | vgroove, 1 bounce | vgroove | copper: time of vgroove / roughconductor |")
    print("|---|---|---|---|---|---|")
    for roughness in ROUGHNESSES:
        ours = {"type": "vgroove", "distribution": "ggx", "roughness": roughness}
        theirs = {"type": "roughconductor", "distribution": "ggx", "alpha": roughness}
        of_ours, of_theirs = vgroove.least_seconds(
            [mi.load_dict({**surface, "material": "Cu"}) for surface in (ours, theirs)], 32, 4)
        ratio = of_ours / of_theirs
        for angle in ANGLES_DEG:
            values = [albedo(mi.load_dict({"material": "none", **bsdf}), math.radians(angle), options.samples)
                      for bsdf in (theirs, {**ours, "max_bounces": 1}, ours)]
            print(f"| {roughness} | {angle}° | " + " | ".join(f"{value:.3f}" for value in values)
                  + f" | {ratio:.1f} |", flush=True)


if __name__ == "__main__":
    main()
