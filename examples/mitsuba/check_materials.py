#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that `vgroove` renders whatever `conductor` renders: every material that Mitsuba ships, and indices that end
inside the visible range, vanish, or lie far outside what any medium has.

A flat surface (180°) must reflect as `conductor` does, over all wavelengths that the variant may ask for. Where data
end `conductor` has no index and reflects all light, but nothing in polarised variants, and no number at normal
incidence; `vgroove` is a mirror in all of them. A groove of 60° must give numbers between
0 and 1 from any direction, including with effects = auto and with fields followed; and so must a rough surface."""

import argparse
import math
import pathlib

import mitsuba as mi
import numpy as np

import vgroove

TOLERANCE = 1e-4  # of a reflectance in float; Mitsuba's formula has the rounding error
WEIGHT_ROUNDING = 1e-5  # of weights, which no reflectance may exceed
ROUGH = {"distribution": "ggx", "roughness": 0.6}
GRAZING = 1e-3  # smallest cosine tried: below it Mitsuba's own formula loses digits on strong metals


def materials():
    folder = pathlib.Path(mi.__file__).parent / "data" / "ior"
    return [{"material": path.name[:-len(".eta.spd")]} for path in sorted(folder.glob("*.eta.spd"))]


def unusual():
    def spectrum(low, high, value):
        return {"type": "irregular", "wavelengths": f"{low}, {high}", "values": f"{value}, {value}"}

    yield {}
    yield {"material": "none"}
    yield {"k": {"type": "uniform", "value": 3.0}}
    for eta, k in [(0.0, 0.0), (0.0, 1.0), (1.0, 0.0), (1e-9, 1e-9), (1e9, 1e9), (1e-3, 1e4)]:
        yield {"eta": {"type": "uniform", "value": eta}, "k": {"type": "uniform", "value": k}}
    if not mi.variant().endswith("polarized"):  # `conductor` amplifies there
        yield {"eta": {"type": "uniform", "value": -0.05}, "k": {"type": "uniform", "value": 4.1}}
    if "spectral" in mi.variant():
        yield {"eta": spectrum(380, 780, 0.2), "k": spectrum(380, 780, 3.9)}
        yield {"eta": spectrum(500, 510, 1.5), "k": spectrum(600, 610, 2.0)}
    yield {"material": "Cu", "specular_reflectance": {"type": "uniform", "value": 0.4}}


def unpolarized(weights):
    """The reflectance of unpolarised light, of an array of spectra."""
    return weights[:, 0, 0] if vgroove.is_polarized() else weights


def cases(rng):
    """Directions and wavelengths: all that the variant may ask for, 4 at a time, each from several directions."""
    spectral = "spectral" in mi.variant()
    grid = np.arange(360, 831, 5.0) if spectral else np.zeros(4)
    wi, wavelengths = [], []
    for start in range(0, len(grid), 4):
        for cos_theta in (1.0, 0.999, *rng.uniform(GRAZING, 1, 2), GRAZING):
            sin_theta, phi = math.sqrt(1 - cos_theta**2), rng.uniform(0, 2 * math.pi)
            wi.append([sin_theta * math.cos(phi), sin_theta * math.sin(phi), cos_theta])
            wavelengths.append(np.resize(grid[start:start + 4], 4))
    return np.array(wi), np.array(wavelengths) if spectral else None


def check(parameters, rng):
    """The largest difference from `conductor`, where that gives a number."""
    flat = mi.load_dict({"type": "vgroove", "aperture": 180.0, **parameters})
    try:
        conductor = mi.load_dict({"type": "conductor", **parameters})
    except RuntimeError:  # k = 0 at all wavelengths of a file is refused in spectral variants
        conductor = None
    grooves = [mi.load_dict({"type": "vgroove", "aperture": 60.0, **parameters, **effects})
               for effects in ({"effects": "paper"}, {"effects": "full"}, {"tolerance": 0.01})]
    grooves += [mi.load_dict({"type": "vgroove", **ROUGH, **parameters, "effects": effects})
                for effects in (("paper",) if vgroove.is_vectorised() else ("paper", "full"))]
    wi, wavelengths = cases(rng)
    u = rng.uniform(size=(len(wi), 3))
    ours = unpolarized(vgroove.sampled(flat, wi, u, wavelengths)[2])
    if not np.all(np.isfinite(ours)):
        raise SystemExit(f"{mi.variant()}: {parameters}: not a number from a flat surface")
    for groove in grooves:
        weights = unpolarized(vgroove.sampled(groove, wi, u, wavelengths)[2])
        if not np.all((weights >= 0) & (weights <= 1 + WEIGHT_ROUNDING)):
            raise SystemExit(f"{mi.variant()}: {parameters}: {weights.min()} to {weights.max()} from a groove")
    if conductor is None:
        return 0.0
    theirs = unpolarized(vgroove.sampled(conductor, wi, u, wavelengths)[2])
    numbers = np.isfinite(theirs)
    if vgroove.is_polarized():
        numbers &= theirs > 0
    return np.abs(ours - theirs)[numbers].max(initial=0)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--variant", default="scalar_rgb", help="Mitsuba's variant; scalar_rgb by default")
    parser.add_argument("--plug-in", metavar="FOLDER", default=None, help="where it was built; build/mitsuba by default")
    options = parser.parse_args()
    vgroove.start(options.variant, options.plug_in)
    mi.set_log_level(mi.LogLevel.Error)
    rng = np.random.default_rng(3)
    worst = [(check(parameters, rng), parameters) for parameters in (*materials(), *unusual())]
    largest, parameters = max(worst, key=lambda pair: pair[0])
    print(f"{options.variant}: {len(worst)} materials; largest difference from conductor {largest:.1g}, {parameters}")
    for difference, parameters in worst:
        if not difference < TOLERANCE:
            raise SystemExit(f"{options.variant}: {parameters} differs from conductor by {difference:.3g}")


if __name__ == "__main__":
    main()
