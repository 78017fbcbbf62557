#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Compares `vgroove` in the vectorised variants with the same in the scalar ones, value by value: BSDF, density, and what is
drawn from the same random numbers, without polarisation, which rough surfaces of vectorised ones do not follow. Prints a
Markdown table, and ends with status 1 where they differ by more than rounding.

Where a random number lies at the border between two ways of the light, rounding decides which one is drawn: a few draws
in a thousand may differ. Lobes of parallel grooves come in another order, so any number of draws may; those that do not have
the same weights."""

import argparse
import math
import re
import sys

import mitsuba as mi
import numpy as np

import vgroove

DIRECTIONS = 2000
LARGEST_DEVIATION = 3e-5  # of values and densities, relative to the larger one, but for one direction in a hundred
LARGEST_OF_ALL = 1e-3  # next to the mirror direction, where the azimuth of the grooves has few digits
LARGEST_ANGLE = 1e-3  # between directions drawn, in radians
MOST_OTHERS = 2e-3  # part of the draws from rough surfaces that may differ
CASES = [
    {"distribution": "ggx", "roughness": 0.3},
    {"distribution": "ggx", "roughness": 1.0, "max_bounces": 5},
    {"distribution": "ggx", "alpha_u": 0.2, "alpha_v": 0.6, "rotation": 30.0},
    {"distribution": "beckmann", "roughness": 0.05},
    {"distribution": "beckmann", "roughness": 0.8},
    {"distribution": "brushed", "roughness": 0.4, "concentration": 20.0, "rotation": -50.0},
    {"distribution": "ggx", "roughness": "texture"},
    {"aperture": 60.0, "lobe_width": 10.0},
    {"aperture": 35.0, "lobe_width": 25.0, "rotation": 20.0, "max_bounces": 3},
    {"aperture": 70.0, "lobe_width": 10.0, "tilt": 20.0},
    {"aperture": 50.0},
    {"aperture": 100.0, "tilt": -30.0},
]


def directions(rng, count):
    """Unit vectors above the horizon, half of them within a few degrees of it."""
    z = np.where(rng.uniform(size=count) < 0.5, rng.uniform(0, 1, count), 10.0**-rng.uniform(1, 3, count))
    azimuth, across = rng.uniform(0, 2 * math.pi, count), np.sqrt(1 - z**2)
    return np.stack([across * np.cos(azimuth), across * np.sin(azimuth), z], axis=1).astype(np.float32)


def found(surface, wi, wo, u, uv, wavelengths):
    """Values, densities, directions drawn, their densities and weights in the variant that is set."""
    if surface.get("roughness") == "texture":
        ramp = mi.TensorXf(np.linspace(0.1, 1, 16, dtype=np.float32).reshape(1, 16, 1))
        surface = {**surface, "roughness": {"type": "bitmap", "raw": True, "filter_type": "nearest", "data": ramp}}
    bsdf = mi.load_dict({"type": "vgroove", "material": "Cu", "polarized": False, **surface})
    context, si = mi.BSDFContext(), vgroove.interactions(wi, wavelengths)
    if vgroove.is_vectorised():
        si.uv = mi.Point2f(uv.T)
        value, density = bsdf.eval_pdf(context, si, mi.Vector3f(wo.T))
        drawn, weight = bsdf.sample(context, si, mi.Float(u[:, 0]), mi.Point2f(u[:, 1:].T))
        last = [np.moveaxis(np.array(x), -1, 0) for x in (value, weight)]
        return [last[0], np.array(density), np.array(drawn.wo).T, np.array(drawn.pdf), last[1]]
    rows = []
    for one, direction, numbers, point in zip(si, wo.tolist(), u.tolist(), uv.tolist()):
        one.uv = point
        value, density = bsdf.eval_pdf(context, one, direction)
        drawn, weight = bsdf.sample(context, one, numbers[0], numbers[1:])
        rows.append([np.array(value), density, np.ravel(drawn.wo), drawn.pdf, np.array(weight)])
    return [np.array(column) for column in zip(*rows)]


def deviation(a, b):
    """The largest relative difference of arrays that have the directions in their first dimension."""
    a, b = (np.asarray(x, float).reshape(len(x), -1) for x in (a, b))
    size = np.maximum(np.maximum(np.abs(a).max(1), np.abs(b).max(1)), 1e-20)
    return np.abs(a - b).max(1) / size


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--variant", default="llvm_ad_rgb", help="Mitsuba's variant; llvm_ad_rgb by default")
    parser.add_argument("--plug-in", metavar="FOLDER", default=None, help="where it was built; build/mitsuba by default")
    options = parser.parse_args()
    rng = np.random.default_rng(7)
    wi, wo = directions(rng, DIRECTIONS), directions(rng, DIRECTIONS)
    u, uv = rng.uniform(size=(DIRECTIONS, 3)).astype(np.float32), rng.uniform(size=(DIRECTIONS, 2)).astype(np.float32)
    wavelengths = rng.uniform(380, 780, (DIRECTIONS, 4)) if "spectral" in options.variant else None
    results = []
    for variant in (options.variant, re.sub("^(llvm|cuda)_ad", "scalar", options.variant)):
        vgroove.start(variant, options.plug_in)
        results.append([found(case, wi, wo, u, uv, wavelengths) for case in CASES])
    print(f"{options.variant}\n\n| surface | value | density | other draws | weight |\n|---|---|---|---|---|")
    failed = False
    for case, vectorised, scalar in zip(CASES, *results):
        value, density = (deviation(vectorised[i], scalar[i]) for i in (0, 1))
        there, here = vectorised[3] > 0, scalar[3] > 0
        same = np.where(here, np.linalg.norm(vectorised[2] - scalar[2], axis=1) < LARGEST_ANGLE, True) & (there == here)
        weight = np.quantile(np.abs(vectorised[4] - scalar[4]).reshape(DIRECTIONS, -1).max(1)[same], 0.999)
        largest = vectorised[4].max()
        most_others = MOST_OTHERS if "distribution" in case else 1
        name = ", ".join(f"{key} {value}" for key, value in case.items())
        print(f"| {name} | {value.max():.1e} | {density.max():.1e} | {1 - same.mean():.1e} | {weight:.1e} |", flush=True)
        failed |= not (all(np.quantile(x, 0.99) < LARGEST_DEVIATION and x.max() < LARGEST_OF_ALL
                           for x in (value, density))
                       and 1 - same.mean() < most_others and weight < LARGEST_DEVIATION and largest < 1 + 1e-6)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
