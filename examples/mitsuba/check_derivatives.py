#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Differentiates a rendered image with respect to what a `vgroove` is made of, and compares with finite differences.

A plate of grooves is rendered under a smooth sky of different brightness in different directions, so that weights,
reflectances and directions of lobes all count. The derivative of the mean radiance is taken forwards and backwards;
finite differences render with other random numbers. Both have noise, which is measured with several seeds. Prints a
Markdown table, and ends with status 1 if they differ by more than noise explains or are uncertain by more than a few
percent."""

import argparse
import sys

import mitsuba as mi
import numpy as np

import vgroove

# (name, surface, parameter, step of the finite difference)
CASES = [
    ("copper-like, 60°", {"aperture": 60.0}, "aperture", 1.0),
    ("copper-like, 100°", {"aperture": 100.0}, "aperture", 1.0),
    ("copper-like, 50°, spread by 6°", {"aperture": 50.0, "lobe_width": 6.0}, "aperture", 1.0),
    ("copper-like, 75°, turned by 30°", {"aperture": 75.0, "rotation": 30.0}, "rotation", 0.3),
    ("copper-like, 70°, tilted by 20°", {"aperture": 70.0, "tilt": 20.0}, "tilt", 0.5),
    ("copper-like, 60°", {"aperture": 60.0}, "eta", 0.03),
    ("copper-like, 60°", {"aperture": 60.0}, "k", 0.1),
    ("tinted, 45°", {"aperture": 45.0, "specular_reflectance": {"type": "uniform", "value": 0.7}},
     "specular_reflectance", 0.02),
    ("GGX 0.4", {"distribution": "ggx", "roughness": 0.4}, "roughness", 0.02),
    ("Beckmann 0.6", {"distribution": "beckmann", "roughness": 0.6}, "roughness", 0.02),
    ("GGX 0.2 across 0.7", {"distribution": "ggx", "alpha_u": 0.2, "alpha_v": 0.7}, "alpha_v", 0.03),
    ("GGX 0.2 across 0.7, turned by 30°", {"distribution": "ggx", "alpha_u": 0.2, "alpha_v": 0.7, "rotation": 30.0},
     "rotation", 1.0),
    ("brushed 0.5", {"distribution": "brushed", "roughness": 0.5, "concentration": 20.0}, "roughness", 0.03),
    ("GGX 1", {"distribution": "ggx", "roughness": 1.0}, "eta", 0.02),
    ("GGX 1", {"distribution": "ggx", "roughness": 1.0}, "k", 0.05),
    ("tinted, GGX 0.8", {"distribution": "ggx", "roughness": 0.8,
                         "specular_reflectance": {"type": "uniform", "value": 0.7}}, "specular_reflectance", 0.02),
]
INDEX = {"eta": {"type": "uniform", "value": 0.6}, "k": {"type": "uniform", "value": 2.6}}
SEEDS = 8
LARGEST_DEVIATION = 4.5  # in σ of the mean of the seeds, with 14 degrees of freedom
LARGEST_UNCERTAINTY = 0.03  # of the size of a derivative


def scene(surface):
    rows, columns = np.mgrid[0:32, 0:64]
    polar, azimuth = (rows + 0.5) * np.pi / 32, (columns + 0.5) * 2 * np.pi / 64
    sky = 1 + 0.5 * np.sin(polar) * np.sin(azimuth + 0.4) + 0.4 * np.cos(3 * azimuth) * np.sin(polar)**2
    return vgroove.plate(
        {"type": "vgroove", **INDEX, **surface}, 16, film={"rfilter": {"type": "box"}},
        integrator={"type": "direct", "emitter_samples": 0, "bsdf_samples": 1},
        sky={"type": "envmap", "bitmap": mi.Bitmap(np.repeat(sky[..., None], 3, 2).astype(np.float32)),
             "to_world": mi.ScalarTransform4f().rotate([1, 0, 0], 90)})


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--variant", default="llvm_ad_rgb", help="Mitsuba's variant; llvm_ad_rgb by default")
    parser.add_argument("--samples", type=int, default=2048, help="paths per pixel of 256; 2048 by default")
    parser.add_argument("--plug-in", metavar="FOLDER", default=None, help="where it was built; build/mitsuba by default")
    options = parser.parse_args()
    vgroove.start(options.variant, options.plug_in)
    import drjit as dr

    print("| surface | with respect to | forwards | backwards | finite difference | deviation / σ |\n"
          "|---|---|---|---|---|---|")
    failed = False
    for name, surface, parameter, step in CASES:
        plate = scene(surface)
        params = mi.traverse(plate)
        key = f"plate.bsdf.{parameter}.value"
        start = float(params[key][0])

        def mean(value, seed):
            params[key] = value
            params.update()
            return dr.mean(mi.render(plate, params, spp=options.samples, seed=seed), axis=None)

        def forwards(seed):
            value = mi.Float(start)
            dr.enable_grad(value)
            image = mean(value, seed)
            dr.forward(value)
            return dr.grad(image)

        def backwards(seed):
            value = mi.Float(start)
            dr.enable_grad(value)
            dr.backward(mean(value, seed))
            return dr.grad(value)

        def difference(seed):
            low, high = (np.ravel(mean(mi.Float(start + sign * step), seed))[0].astype(float) for sign in (-1, 1))
            return (high - low) / (2 * step)

        found = [np.array([np.ravel(derivative(seed))[0] for seed in seeds], dtype=float)
                 for derivative, seeds in ((forwards, range(SEEDS)), (backwards, range(1)),
                                           (difference, range(100, 100 + SEEDS)))]
        ahead, back, finite = (values.mean() for values in found)
        sigma = np.hypot(*(np.std(found[i], ddof=1) / SEEDS**0.5 for i in (0, 2)))
        deviation = (ahead - finite) / sigma
        print(f"| {name} | {parameter} | {ahead:.3e} | {back:.3e} | {finite:.3e} ± {sigma:.1e} | {deviation:+.1f} |",
              flush=True)
        failed |= not (abs(deviation) < LARGEST_DEVIATION and sigma < LARGEST_UNCERTAINTY * abs(ahead)
                       and abs(back - found[0][0]) < 1e-3 * abs(ahead))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
