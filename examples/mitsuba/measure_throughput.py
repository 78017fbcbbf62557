#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Measures what a direction costs in the kernels of a vectorised variant: how long `sample` and `eval_pdf` take for millions
of directions at once, spread evenly over the hemisphere, and how long a picture of a plate in an even sky takes for each
path, of as many. Prints a Markdown table, in nanoseconds, and as multiples of what Mitsuba's `roughconductor` takes, GGX of
roughness 0.3.

Counted is the time of the kernels alone, the least of several runs. They are compiled before, once for each kind of
surface. Recording them takes Dr.Jit some milliseconds for each rendering, whatever the number of directions."""

import argparse

import mitsuba as mi
import numpy as np

import vgroove

SIDE = 512  # pixels of the picture
REFERENCE = ("roughconductor, GGX 0.3", {"type": "roughconductor", "distribution": "ggx", "alpha": 0.3})
SURFACES = [
    ("90°", {"aperture": 90.0}),
    ("45°", {"aperture": 45.0}),
    ("10°", {"aperture": 10.0}),
    ("45°, fields followed", {"aperture": 45.0, "polarized": True}),
    ("70°, tilted by 20°", {"aperture": 70.0, "tilt": 20.0}),
    ("45°, spread by 5°", {"aperture": 45.0, "lobe_width": 5.0}),
    ("GGX 0.3, 1 bounce", {"distribution": "ggx", "roughness": 0.3, "max_bounces": 1}),
    ("GGX 0.3, 8 bounces", {"distribution": "ggx", "roughness": 0.3, "max_bounces": 8}),
    ("GGX 0.3", {"distribution": "ggx", "roughness": 0.3}),
    ("Beckmann 0.3", {"distribution": "beckmann", "roughness": 0.3}),
    ("brushed 0.3", {"distribution": "brushed", "roughness": 0.3}),
]


def directions(rng, count):
    """As many unit vectors above the horizon, evenly spread over solid angle."""
    z, azimuth = rng.uniform(0, 1, count), rng.uniform(0, 2 * np.pi, count)
    across = np.sqrt(1 - z * z)
    return np.stack([across * np.cos(azimuth), across * np.sin(azimuth), z]).astype(np.float32)


def least_time(call, runs):
    """Seconds in kernels, the least of several runs after one that compiles them."""
    import drjit as dr
    times = []
    with dr.scoped_set_flag(dr.JitFlag.KernelHistory, True):
        for run in range(runs + 1):
            dr.kernel_history_clear()
            dr.eval(call(run))
            dr.sync_thread()
            times.append(sum(kernel["execution_time"] for kernel in dr.kernel_history([dr.KernelType.JIT])) / 1e3)
    return min(times[1:])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--variant", default="llvm_ad_rgb", help="Mitsuba's variant; llvm_ad_rgb by default")
    parser.add_argument("--directions", type=int, default=1_000_000, help="in each kernel; 1000000 by default")
    parser.add_argument("--runs", type=int, default=5, help="of which the least time counts; 5 by default")
    parser.add_argument("--plug-in", metavar="FOLDER", default=None, help="where it was built; build/mitsuba by default")
    options = parser.parse_args()
    vgroove.start(options.variant, options.plug_in)
    import drjit as dr

    rng = np.random.default_rng(4)
    si = dr.zeros(mi.SurfaceInteraction3f, options.directions)
    si.wi = mi.Vector3f(directions(rng, options.directions))
    si.wavelengths = dr.full(type(si.wavelengths), 550)
    wo = mi.Vector3f(directions(rng, options.directions))
    u_lobe = mi.Float(rng.uniform(size=options.directions).astype(np.float32))
    u = mi.Point2f(rng.uniform(size=(2, options.directions)).astype(np.float32))
    dr.eval(si, wo, u_lobe, u)
    context = mi.BSDFContext()

    samples = max(1, options.directions // SIDE**2)
    print(f"{options.variant}, {options.directions} directions\n\n"
          "| copper | sample | × | eval_pdf | × | path | × |\n|---|---|---|---|---|---|---|")
    reference = {}
    for name, parameters in [REFERENCE, *SURFACES]:
        surface = {"type": "vgroove", "material": "Cu", **parameters}
        bsdf = mi.load_dict(surface)
        picture = vgroove.plate(surface, SIDE, integrator={"type": "path", "max_depth": 2}, sky={"type": "constant"})
        calls = {"sample": (options.directions, lambda run: bsdf.sample(context, si, u_lobe, u)),
                 "eval_pdf": (options.directions, lambda run: bsdf.eval_pdf(context, si, wo)),
                 "path": (samples * SIDE**2, lambda run: mi.render(picture, spp=samples, seed=run))}
        if "aperture" in parameters and "lobe_width" not in parameters:
            del calls["eval_pdf"]  # mirror directions have no value
        each = {what: least_time(call, options.runs) / count for what, (count, call) in calls.items()}
        reference = reference or each
        cells = [f"{1e9 * each[what]:.3g} ns | {each[what] / reference[what]:.1f}" if what in each else "– | –"
                 for what in reference]
        print(f"| {name} | {' | '.join(cells)} |", flush=True)


if __name__ == "__main__":
    main()
