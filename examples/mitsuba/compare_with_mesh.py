#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Compares `vgroove` on a flat plate with grooves modelled as a mesh of Mitsuba's own `conductor`.

Both are seen from one direction under one patchy environment, so that wrong weights and wrong directions of lobes
show alike; in a polarised variant their Stokes parameters are compared. Prints a Markdown table: radiance of mesh and
plug-in, their difference in standard errors, and how much faster the plug-in reaches the same error. Ends with status 1
if the differences are larger than noise explains."""

import argparse
import math
import sys
import time

import mitsuba as mi
import numpy as np

import vgroove

# (material, aperture, tilt, θ, φ) in degrees; φ is measured from the direction across the grooves, to which they tilt.
CASES = [(material, aperture, 0, theta, phi)
         for material, aperture in [("Cu", 40), ("Cu", 60), ("Ag", 45), ("Cr", 90), ("Cu", 130), (1.5, 60), (1.5, 100)]
         for theta, phi in [(5, 20), (35, 0), (50, 60), (75, 30)]]
# The last one has a wall that overhangs.
TILTED_CASES = [(material, aperture, tilt, theta, phi)
                for material, aperture, tilt in [("Cu", 60, 25), ("Cr", 90, -30), (1.5, 50, 15), ("Ag", 70, 50)]
                for theta, phi in [(5, 20), (35, 180), (50, 60), (75, 150)]]
FALSE_ALARM_RATE = 1e-3  # of the whole table
SCALE = 1000  # panel width in units of the scene
FLAT_TOLERANCE = 1e-5  # of elements of Mueller matrices in float, after two rotations of their axes
BATCH = 250  # paths per rendering: Mitsuba adds them up in float, which loses digits when there are many
# Rays that meet the mesh within rounding of an edge go astray: moving the mesh sideways, which should change nothing,
# changes its radiance by up to this part of it.
MESH_ERROR = 2e-4
ROUNDING = 1e-5  # relative error of such a sum; where all light takes one way there is no other noise


def facet(material):
    """Mitsuba's parameters of a metal's name, or of the index of a dielectric."""
    if isinstance(material, str):
        return {"material": material}
    return {"eta": {"type": "spectrum", "value": material}, "k": {"type": "spectrum", "value": 0.0}}


def rims(aperture, tilt):
    """Where the panels of a groove end, across it, with their height; the apex is the origin."""
    depth = math.cos(aperture / 2)
    return -depth * math.tan(aperture / 2 - tilt), depth * math.tan(aperture / 2 + tilt), depth


def groove_mesh(aperture, tilt, material):
    """Five long grooves along x; the apex of the middle one is the origin."""
    low, high, depth = rims(aperture, tilt)
    half_length = 200.0
    vertices, faces = [], []
    for groove in range(-2, 3):
        for y0, z0, y1, z1 in [(low, depth, 0, 0), (0, 0, high, depth)]:
            first, shift = len(vertices), (high - low) * groove
            vertices += [(x, y + shift, z) for x in (-half_length, half_length) for y, z in ((y0, z0), (y1, z1))]
            faces += [(first, first + 2, first + 3), (first, first + 3, first + 1)]
    return vgroove.triangle_mesh("grooves", SCALE * np.array(vertices), faces,
                                 bsdf={"type": "conductor", **facet(material)})


def openings(aperture, tilt, count, length):
    """The transformation from Mitsuba's `rectangle` to the openings of the middle groove and its neighbours."""
    low, high, depth = rims(aperture, tilt)
    transform = mi.ScalarTransform4f()
    return transform.translate([0, SCALE * (low + high) / 2, SCALE * depth]) @ transform.scale(
        [SCALE * length, SCALE * count * (high - low) / 2, 1])


def plate(aperture, tilt, material):
    tilted = {"tilt": math.degrees(tilt)} if tilt else {}
    return {"type": "rectangle", "to_world": openings(aperture, tilt, 5, 200),
            "bsdf": {"type": "vgroove", "aperture": math.degrees(aperture), **tilted, **facet(material)}}


def scene(surface, aperture, tilt, theta, phi, sky):
    towards_viewer = [math.sin(theta) * math.sin(phi), math.sin(theta) * math.cos(phi), math.cos(theta)]
    path = {"type": "path", "max_depth": 100, "rr_depth": 100}
    return mi.load_dict({
        "type": "scene",
        "integrator": {"type": "stokes", "nested": path} if vgroove.is_polarized() else path,
        "surface": surface,
        "sky": {"type": "envmap", "bitmap": sky, "to_world": mi.ScalarTransform4f().rotate([1, 0, 0], 90)},
        "sensor": {"type": "distant", "direction": [-c for c in towards_viewer],
                   "target": {"type": "rectangle", "to_world": openings(aperture, tilt, 1, 0.1)},
                   "film": {"type": "hdrfilm", "width": 1, "height": 1, "rfilter": {"type": "box"},
                            "component_format": "float32", "pixel_format": "rgb"},
                   "sampler": {"type": "independent"}},
    })


def radiance(scene, samples, seed):
    """Means, standard errors and processor seconds; one mean over the colours, or one for each of I, Q, U, V."""
    start = time.process_time()
    pixels = np.array([np.ravel(mi.render(scene, spp=BATCH, seed=seed + batch)) for batch in range(samples // BATCH)],
                      dtype=float)
    seconds = time.process_time() - start
    colours = pixels[:, 3:] if vgroove.is_polarized() else pixels  # the stokes integrator puts the picture first
    means = colours.reshape(len(pixels), -1, 3).mean(axis=2)
    mean = means.mean(axis=0)
    noise = means.std(axis=0, ddof=1) / math.sqrt(len(means))
    return mean, np.maximum(noise, ROUNDING * mean[0]), seconds


def flat_difference(rng, trials=500):
    """Largest difference of an element between the Mueller matrices of `vgroove` with an aperture of 180° and of
    `conductor`, in both transport directions: their axes and signs must be the same."""
    largest = 0.0
    for material in ("Cu", 1.5):
        flat = mi.load_dict({"type": "vgroove", "aperture": 180.0, "rotation": 25.0, **facet(material)})
        conductor = mi.load_dict({"type": "conductor", **facet(material)})
        cos_theta, phi = rng.uniform(0.01, 1, trials), rng.uniform(0, 2 * math.pi, trials)
        sin_theta = np.sqrt(1 - cos_theta**2)
        wi = np.stack([sin_theta * np.cos(phi), sin_theta * np.sin(phi), cos_theta], axis=1)
        wavelengths, u = rng.uniform(400, 700, (trials, 4)), np.full((trials, 3), 0.5)
        for mode in (mi.TransportMode.Radiance, mi.TransportMode.Importance):
            weights = [vgroove.sampled(bsdf, wi, u, wavelengths, mode)[2] for bsdf in (flat, conductor)]
            largest = max(largest, np.abs(weights[0] - weights[1]).max())
    return largest


def numbers(values, form="{:.5f}"):
    return ", ".join(form.format(value) for value in values)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--variant", default="scalar_rgb", help="Mitsuba's variant; scalar_rgb by default")
    parser.add_argument("--samples", type=int, default=400_000, help="paths per number; 400000 by default")
    parser.add_argument("--tilted", action="store_true", help="grooves whose panels are not equally steep")
    parser.add_argument("--plug-in", metavar="FOLDER", default=None, help="where it was built; build/mitsuba by default")
    options = parser.parse_args()
    vgroove.start(options.variant, options.plug_in)

    patches = np.random.default_rng(1).uniform(0, 1, (16, 32, 3))
    sky = mi.Bitmap(patches.astype(np.float32))
    quantity = "I, Q, U, V" if vgroove.is_polarized() else "radiance"
    print(f"Mitsuba {mi.__version__}, {options.variant}, {options.samples} paths per number\n")
    print(f"| material | aperture |{' tilt |' if options.tilted else ''} θ | φ | {quantity}: mesh | plug-in | difference / σ | speed at equal error |")
    print("|---|---|---|---|---|---|---|---|" + ("---|" if options.tilted else ""))
    differences, speeds = [], []
    for number, (material, *angles) in enumerate(TILTED_CASES if options.tilted else CASES):
        aperture, tilt, theta, phi = map(math.radians, angles)
        seed = 1_000_000 * number
        mesh, mesh_error, mesh_time = radiance(
            scene(groove_mesh(aperture, tilt, material), aperture, tilt, theta, phi, sky), options.samples, seed)
        plug_in, plug_in_error, plug_in_time = radiance(
            scene(plate(aperture, tilt, material), aperture, tilt, theta, phi, sky), options.samples, seed + 500_000)
        sigma = np.sqrt(mesh_error**2 + plug_in_error**2 + (MESH_ERROR * mesh[0])**2)
        difference = (plug_in - mesh) / sigma
        differences += list(difference)
        speed = "–"
        if mesh_error[0] > ROUNDING * mesh[0] and plug_in_error[0] > ROUNDING * plug_in[0]:
            speeds.append(mesh_error[0]**2 * mesh_time / (plug_in_error[0]**2 * plug_in_time))
            speed = f"{speeds[-1]:.2g}"
        shown = angles if options.tilted else [angles[0], *angles[2:]]
        print(f"| {material} | {' | '.join(f'{angle}°' for angle in shown)} | {numbers(mesh)} ± {mesh_error[0]:.5f} "
              f"| {numbers(plug_in)} ± {plug_in_error[0]:.5f} | {numbers(difference, form='{:+.1f}')} | {speed} |",
              flush=True)

    # Wilson and Hilferty: the cube root of χ²/n is normally distributed.
    n = len(differences)
    chi2 = sum(d * d for d in differences)
    deviate = ((chi2 / n) ** (1 / 3) - (1 - 2 / (9 * n))) / math.sqrt(2 / (9 * n))
    p_value = math.erfc(deviate / math.sqrt(2)) / 2
    print(f"\nχ² = {chi2:.1f} for {n} numbers: p = {p_value:.2g}. "
          f"Largest difference {max(map(abs, differences)):.1f} σ. "
          f"Speed at equal error: {math.exp(np.mean(np.log(speeds))):.1f} (geometric mean).")
    if p_value < FALSE_ALARM_RATE:
        print("mesh and plug-in disagree", file=sys.stderr)
        return 1
    if vgroove.is_polarized():
        difference = flat_difference(np.random.default_rng(2))
        print(f"Largest difference of a Mueller matrix between vgroove at 180° and conductor: {difference:.1g}.")
        if not difference < FLAT_TOLERANCE:
            print("Mueller matrices of a flat surface disagree", file=sys.stderr)
            return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
