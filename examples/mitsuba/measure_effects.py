#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Measures what `vgroove` with a tolerance leaves out, the error that this makes, and the time that it saves.

For each surface, seen from many directions under one patchy sky of radiance 0 to 1, the radiance with the effects that
the tolerance calls for is compared with that of the full physics: the fields followed through all bounces, for rough
surfaces 4096 unpolarised ones. Grooves are compared lobe by lobe, without noise; rough surfaces with the same random
numbers, stratified. The times are those of rendering a plate of the surface, against effects = full. Ends with status 1 if a difference exceeds the tolerance."""

import argparse
import math
import sys

import mitsuba as mi
import numpy as np

# (what it is, parameters, tolerance)
CASES = [
    ("silver, 90°", {"material": "Ag", "aperture": 90.0}, 0.03),
    ("silver, 90°", {"material": "Ag", "aperture": 90.0}, 1e-4),
    ("copper, 60°", {"material": "Cu", "aperture": 60.0}, 0.05),
    ("gold, 20°", {"material": "Au", "aperture": 20.0}, 0.1),
    ("chromium, 10°", {"material": "Cr", "aperture": 10.0}, 0.1),
    ("chromium, 10°", {"material": "Cr", "aperture": 10.0}, 1e-3),
    ("tungsten, 45°", {"material": "W", "aperture": 45.0}, 0.1),
    ("glass 1.5, 60°", {"eta": 1.5, "aperture": 60.0}, 0.05),
    ("glass 1.5, 100°", {"eta": 1.5, "aperture": 100.0}, 0.1),
    ("a mirror, 40°", {"material": "none", "aperture": 40.0}, 1e-3),
    ("silver, GGX 0.3", {"material": "Ag", "distribution": "ggx", "roughness": 0.3}, 0.01),
    ("copper, GGX 1", {"material": "Cu", "distribution": "ggx", "roughness": 1.0}, 0.02),
    ("copper, Beckmann 0.5", {"material": "Cu", "distribution": "beckmann", "roughness": 0.5}, 0.02),
]
STRATA = 4096  # of the random number that chooses a lobe
ROUGH_SAMPLES = 4096


def full(parameters, **limit):
    """All that vgroove knows of a surface."""
    return mi.load_dict({"type": "vgroove", **parameters, **limit, "effects": "full"})


def sky(directions, patches):
    """Radiance from directions: constant on patches of the hemisphere."""
    rows, columns, _ = patches.shape
    row = np.clip((np.clip(directions[:, 2], 0, 1) * rows).astype(int), 0, rows - 1)
    azimuth = np.arctan2(directions[:, 1], directions[:, 0]) / (2 * np.pi) % 1
    return patches[row, np.minimum((azimuth * columns).astype(int), columns - 1)]


def radiance(bsdf, wi, patches, rough):
    si = mi.SurfaceInteraction3f()
    si.wi = wi
    context, directions, weights = mi.BSDFContext(), [], []
    if rough:
        side = round(ROUGH_SAMPLES ** 0.5)
        numbers = np.random.default_rng(7).uniform(size=(ROUGH_SAMPLES, 3)).astype(np.float32)
        cells = np.arange(ROUGH_SAMPLES)
        numbers[:, 1] = (cells // side + numbers[:, 1]) / side
        numbers[:, 2] = (cells % side + numbers[:, 2]) / side
        for u in numbers.tolist():
            drawn, weight = bsdf.sample(context, si, u[0], u[1:])
            if drawn.pdf > 0:
                directions.append(np.ravel(drawn.wo))
                weights.append(np.ravel(weight) / ROUGH_SAMPLES)
    else:
        lobes = {}
        for u in (np.arange(STRATA) + 0.5) / STRATA:
            drawn, weight = bsdf.sample(context, si, float(u), [0.5, 0.5])
            if drawn.pdf > 0:
                lobes.setdefault(tuple(np.ravel(drawn.wo)), np.ravel(weight) * drawn.pdf)
        directions, weights = list(lobes.keys()), list(lobes.values())
    if not weights:
        return np.zeros(3)
    return (np.array(weights) * sky(np.array(directions), patches)).sum(axis=0)


def chosen(bsdf):
    return next(line.split("=", 1)[1].strip(" ,") for line in str(bsdf).splitlines() if "effects =" in line)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--directions", type=int, default=60, help="per surface; 60 by default")
    parser.add_argument("--samples", type=int, default=64, help="paths per pixel of the timed pictures; 64 by default")
    parser.add_argument("--plug-in", metavar="FOLDER", default=None, help="where it was built; build/mitsuba by default")
    options = parser.parse_args()
    mi.set_variant("scalar_rgb")
    mi.set_log_level(mi.LogLevel.Error)
    import vgroove
    vgroove.load(options.plug_in)
    rng = np.random.default_rng(5)
    patches = rng.uniform(size=(8, 16, 3))
    print("| surface | tolerance | what is followed | error made | time saved |\n|---|---|---|---|---|")
    failed = False
    for name, parameters, tolerance in CASES:
        rough = "distribution" in parameters
        planned = mi.load_dict({"type": "vgroove", **parameters, "tolerance": tolerance})
        reference = full(parameters, **({"max_bounces": 4096} if rough else {}))
        largest = 0.0
        for _ in range(max(1, options.directions // (10 if rough else 1))):
            cos_theta, phi = rng.uniform(0.02, 1), rng.uniform(0, 2 * math.pi)
            sin_theta = math.sqrt(1 - cos_theta**2)
            wi = [sin_theta * math.cos(phi), sin_theta * math.sin(phi), cos_theta]
            difference = radiance(planned, wi, patches, rough) - radiance(reference, wi, patches, rough)
            largest = max(largest, np.abs(difference).max())
        ratio = vgroove.seconds(full(parameters), options.samples, 3) / vgroove.seconds(planned, options.samples, 3)
        print(f"| {name} | {tolerance:g} | {chosen(planned)} | {largest:.1g} | {ratio:.1f} × |", flush=True)
        failed |= not largest <= tolerance
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
