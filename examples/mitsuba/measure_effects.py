#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Measures what `vgroove` with a tolerance leaves out, the error that this makes in pictures, and the time that it saves.

Plates and spheres are rendered under skies of radiance 0 to 1, once with the effects that the tolerance calls for and
once with the full physics: the fields followed through all bounces, of rough surfaces through 4096. Both pictures have the
same random numbers. The error is the largest difference of a pixel, with its standard error, beside the bound that the
plan promises; the times are those of rendering a plate of the surface, against effects = full. Ends with status 1 if a
difference exceeds the bound, or the bound the tolerance, by more than noise explains."""

import argparse
import re
import sys

import mitsuba as mi
import numpy as np

import vgroove

VARIANTS = ("scalar_rgb", "scalar_spectral", "scalar_spectral_polarized", "llvm_ad_rgb", "llvm_ad_spectral",
            "llvm_ad_spectral_polarized")


def between(low, high):
    return {"type": "checkerboard", "color0": low, "color1": high,
            "to_uv": mi.ScalarTransform3f().scale([4, 4])}


# (what it is, parameters, shape, sky, tolerance); textures are made when the variant is known
CASES = [
    ("silver, 90°", lambda: {"material": "Ag", "aperture": 90.0}, "plate", "patches", 0.03),
    ("silver, 90°", lambda: {"material": "Ag", "aperture": 90.0}, "plate", "patches", 1e-4),
    ("silver, 80° to 140°", lambda: {"material": "Ag", "aperture": between(80.0, 140.0)}, "sphere", "patches", 0.03),
    ("copper, 60°", lambda: {"material": "Cu", "aperture": 60.0}, "sphere", "window", 0.05),
    ("gold, 130°, tilted by 20°", lambda: {"material": "Au", "aperture": 130.0, "tilt": 20.0}, "sphere", "patches", 0.02),
    ("chromium, 10°", lambda: {"material": "Cr", "aperture": 10.0}, "plate", "even", 0.1),
    ("glass 1.5, 60°", lambda: {"eta": 1.5, "aperture": 60.0}, "sphere", "window", 0.05),
    ("glass 1.5, 100°", lambda: {"eta": 1.5, "aperture": 100.0}, "sphere", "patches", 0.1),
    ("a mirror, 40°", lambda: {"material": "none", "aperture": 40.0}, "plate", "patches", 1e-3),
    ("tinted aluminium, 100°", lambda: {"material": "Al", "aperture": 100.0, "specular_reflectance": {
        "type": "uniform", "value": 0.5}}, "sphere", "window", 0.01),
    ("silver, GGX 0.3", lambda: {"material": "Ag", "distribution": "ggx", "roughness": 0.3}, "sphere", "patches", 0.01),
    ("copper, GGX 1", lambda: {"material": "Cu", "distribution": "ggx", "roughness": 1.0}, "sphere", "even", 0.02),
    ("copper, GGX 1", lambda: {"material": "Cu", "distribution": "ggx", "roughness": 1.0}, "sphere", "even", 0.08),
    ("copper, Beckmann 0.5", lambda: {"material": "Cu", "distribution": "beckmann", "roughness": 0.5}, "sphere", "window",
     0.02),
    ("gold, GGX 0.2 to 0.5", lambda: {"material": "Au", "distribution": "ggx", "roughness": between(0.2, 0.5)}, "sphere",
     "patches", 0.02),
]
SIDE = 6  # pixels of a picture
BATCHES = 12
BRIGHTEST = 0.8  # of a sky: the spectra of Mitsuba's skies are those of daylight, 1.2 times as bright in the blue
LARGEST_DEVIATION = 4.5  # σ with 11 degrees of freedom, of the largest of 36 pixels of 15 surfaces in 6 variants


def full(parameters, **limit):
    """All that vgroove knows of a surface."""
    return {"type": "vgroove", **parameters, **limit, "effects": "full"}


def sky(kind):
    """An environment of radiance 0 to 1."""
    if kind == "even":
        return {"type": "constant", "radiance": {"type": "uniform", "value": 1.0}}
    if kind == "window":
        pixels = np.zeros((32, 64))
        pixels[5:9, 20:26] = 1
    else:
        pixels = np.random.default_rng(5).uniform(size=(16, 32))
    return {"type": "envmap", "bitmap": mi.Bitmap(np.repeat(BRIGHTEST * pixels[..., None], 3, 2).astype(np.float32)),
            "to_world": mi.ScalarTransform4f().rotate([1, 0, 0], 90)}


def scene(bsdf, shape, light):
    # Means of components over wavelengths that are never negative do not exceed the largest of them; colours do.
    pixel_format = "luminance" if "spectral" in mi.variant() else "rgb"
    return mi.load_dict({
        "type": "scene", "surface": {"type": "rectangle" if shape == "plate" else "sphere", "bsdf": bsdf}, "sky": sky(light),
        "integrator": {"type": "direct", "emitter_samples": 1, "bsdf_samples": 1},
        "sensor": {"type": "perspective", "fov": 22.0,
                   "to_world": mi.ScalarTransform4f().look_at([2, -3, 4], [0, 0, 0], [0, 0, 1]),
                   "film": {"type": "hdrfilm", "width": SIDE, "height": SIDE, "rfilter": {"type": "box"},
                            "component_format": "float32", "pixel_format": pixel_format},
                   "sampler": {"type": "independent"}}})


def error_of(planned, reference, shape, light, samples):
    """Differences of the pixels of two pictures, and their standard errors."""
    scenes = [scene(bsdf, shape, light) for bsdf in (planned, reference)]
    differences = []
    for seed in range(BATCHES):
        pictures = [np.array(mi.render(one, spp=samples, seed=seed), dtype=float) for one in scenes]
        differences.append(pictures[0] - pictures[1])
    differences = np.array(differences)
    return differences.mean(axis=0), differences.std(axis=0, ddof=1) / BATCHES**0.5


def chosen(bsdf):
    """What a plan follows, and its bound; None where it calls for fields that the variant does not follow."""
    text = next(line.split("=", 1)[1].strip(" ,") for line in str(bsdf).splitlines() if "effects =" in line)
    bound = re.search(r" \(error below ([0-9.e+-]+)\)", text)
    return (text.replace(bound[0], ""), float(bound[1])) if bound else (text, None)


def measure(variant, options):
    """Prints the table of a variant; whether a bound was exceeded, or None if the variant does not start."""
    try:
        mi.set_variant(variant)
    except ImportError as error:
        print(f"{variant} is left out: {error}", file=sys.stderr)
        return None
    mi.set_log_level(mi.LogLevel.Error)
    vgroove.load(options.plug_in)
    print(f"\n`{variant}`:\n\n| surface | shape, sky | tolerance | what is followed | bound | error made | time saved |\n"
          "|---|---|---|---|---|---|---|")
    exceeded = False
    for name, make, shape, light, tolerance in CASES:
        parameters = make()
        rough = "distribution" in parameters
        planned = mi.load_dict({"type": "vgroove", **parameters, "tolerance": tolerance})
        followed, bound = chosen(planned)
        reference = mi.load_dict(full(parameters, **({"max_bounces": 4096} if rough else {})))
        mean, sigma = error_of(planned, reference, shape, light, options.samples)
        worst = np.unravel_index(np.argmax(np.abs(mean)), mean.shape)
        if bound is not None:
            excess = np.abs(mean) - LARGEST_DEVIATION * sigma - bound
            exceeded |= not (excess.max() <= 0 and bound <= tolerance)
        # Vectorised variants need more paths to be busy with them.
        timed = max(1, options.samples // (2 if vgroove.is_vectorised() else 8))
        of_full, of_planned = vgroove.least_seconds([mi.load_dict(full(parameters)), planned], timed, 5)
        ratio = of_full / of_planned
        print(f"| {name} | {shape}, {light} | {tolerance:g} | {followed} | {'none' if bound is None else f'{bound:.2g}'} | {abs(mean[worst]):.1g} ± "
              f"{sigma[worst]:.1g} | {ratio:.1f} × |", flush=True)
    return exceeded


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--variant", action="append", help="Mitsuba's variant; may be repeated; all that start by default")
    parser.add_argument("--samples", type=int, default=64, help="paths per pixel of each of 12 pictures; 64 by default")
    parser.add_argument("--plug-in", metavar="FOLDER", default=None, help="where it was built; build/mitsuba by default")
    options = parser.parse_args()
    results = [measure(variant, options) for variant in options.variant or VARIANTS]
    if all(result is None for result in results):
        return 77
    return 1 if any(results) else 0


if __name__ == "__main__":
    sys.exit(main())
