#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs Mitsuba's own test of BSDFs, `mitsuba.chi2`, on the rough finishes of `vgroove`: whether the directions that it
samples have the density that it states, for several distributions, roughnesses and angles of incidence. The density
must also integrate to 1 less the light that the bounce limit loses, and no weight may exceed 1.

Next to the mirror direction the density of rough surfaces grows like 1/|h|, h being the horizontal part of the sum of
both directions. Its integrals over cells of the sphere, for which the test has a trapezoidal rule, are therefore taken
in the coordinates of the grooves, ψ and θ', in which it is finite: dω = |h| dψ dθ'.

Mitsuba runs the test in a vectorised variant and needs LLVM for it. The plug-in is called in a scalar one, and in all
vectorised ones of LLVM; with --backend cuda in those of CUDA alone."""

import argparse
import math
import sys

import drjit as dr
import mitsuba as mi
import numpy as np

import vgroove

FALSE_ALARM_RATE = 1e-3  # of all tests together
# (parameters, θ, φ) in degrees
CASES = [
    ({"distribution": "ggx", "roughness": 0.15}, 30, 20),
    ({"distribution": "ggx", "roughness": 0.3}, 0, 0),
    ({"distribution": "ggx", "roughness": 0.3}, 60, 100),
    ({"distribution": "ggx", "roughness": 0.3}, 85, 45),
    ({"distribution": "ggx", "roughness": 1.0}, 0, 0),
    ({"distribution": "ggx", "roughness": 1.0}, 50, 70),
    ({"distribution": "ggx", "alpha_u": 0.2, "alpha_v": 0.7, "rotation": 30.0}, 45, 10),
    ({"distribution": "beckmann", "roughness": 0.2}, 10, 200),
    ({"distribution": "beckmann", "roughness": 0.6}, 70, 300),
    ({"distribution": "beckmann", "alpha_u": 0.8, "alpha_v": 0.3}, 30, 60),
    ({"distribution": "brushed", "roughness": 0.4, "concentration": 5.0}, 40, 30),
    ({"distribution": "brushed", "roughness": 0.6, "concentration": 20.0, "rotation": -50.0}, 60, 80),
    ({"lobe_width": 10.0, "aperture": 70.0}, 20, 40),
    ({"lobe_width": 10.0, "aperture": 70.0, "tilt": 20.0}, 40, 120),
    ({"lobe_width": 15.0, "aperture": 50.0, "tilt": -50.0, "rotation": 30.0}, 60, 250),
]

COLOURS = ("rgb", "spectral", "spectral_polarized")
VECTORISED_CASES = [
    ({"lobe_width": 10.0, "aperture": 70.0}, 20, 40),
    ({"lobe_width": 5.0, "aperture": 35.0, "rotation": 20.0}, 55, 250),
    ({"lobe_width": 25.0, "aperture": 120.0, "material": "Cu"}, 75, 100),
    ({"lobe_width": 10.0, "aperture": 70.0, "tilt": 20.0}, 40, 120),
    ({"lobe_width": 15.0, "aperture": 50.0, "tilt": -50.0, "rotation": 30.0}, 60, 250),
    ({"distribution": "ggx", "roughness": 0.3}, 0, 0),
    ({"distribution": "ggx", "alpha_u": 0.2, "alpha_v": 0.7, "rotation": 30.0}, 60, 10),
    ({"distribution": "beckmann", "roughness": 0.6}, 85, 300),
    ({"distribution": "brushed", "roughness": 0.5, "concentration": 20.0, "rotation": -50.0}, 40, 80),
]


class GrooveDomain:
    """Directions o as seen in the groove that leads light from e to them: the azimuth ψ in [0, π) of the direction across
    it, and the angle θ' of o from the normal in the plane across it."""

    def __init__(self, e):
        self.e = [float(component) for component in e]

    def bounds(self):
        return mi.ScalarBoundingBox2f([-math.pi / 2, 0], [math.pi / 2, math.pi])

    def aspect(self):
        return 1

    def map_forward(self, p):
        sin_psi, cos_psi = dr.sincos(p.y)
        along = self.e[0] * sin_psi - self.e[1] * cos_psi
        radius = dr.safe_sqrt(1 - along * along)
        across = radius * dr.sin(p.x)
        return mi.Vector3f(across * cos_psi - along * sin_psi, across * sin_psi + along * cos_psi,
                           radius * dr.cos(p.x))

    def map_backward(self, o):
        psi = dr.atan2(o.y + self.e[1], o.x + self.e[0])
        psi = dr.select(psi < 0, psi + math.pi, psi)
        return mi.Vector2f(dr.atan2(o.x * dr.cos(psi) + o.y * dr.sin(psi), o.z), psi)

    def tilt(self, o):
        return (dr.square(o[0] + self.e[0]) + dr.square(o[1] + self.e[1]))**0.5


def domain_of(parameters, e):
    return GrooveDomain(e) if "distribution" in parameters else mi.chi2.SphericalDomain()


def weighted(domain, pdf):
    """The density per coordinates of the domain."""
    return (lambda wo: domain.tilt(wo) * pdf(wo)) if isinstance(domain, GrooveDomain) else pdf


def scalar_functions(parameters, theta, phi):
    """`sample` and `pdf` of the plug-in for arrays, by a loop over the scalar variant."""
    bsdf = mi.load_dict({"type": "vgroove", "material": "none", **parameters})
    context, si, Point2f, Vector3f = mi.BSDFContext(), mi.SurfaceInteraction3f(), mi.Point2f, mi.Vector3f
    si.wi = [math.sin(theta) * math.cos(phi), math.sin(theta) * math.sin(phi), math.cos(theta)]
    largest = [0.0]

    def sample(u):
        directions, weights = np.zeros((u.shape[1], 3)), np.zeros(u.shape[1])
        for i, (u_lobe, *u_direction) in enumerate(u.T.tolist()):
            drawn, weight = bsdf.sample(context, si, u_lobe, Point2f(u_direction))
            if drawn.pdf > 0:
                directions[i], weights[i] = drawn.wo, 1
                largest[0] = max(largest[0], max(weight))
            else:
                directions[i] = 0, 0, 1
        return directions.T, weights

    def pdf(wo):
        return np.array([bsdf.pdf(context, si, Vector3f(direction)) for direction in wo.T.tolist()])

    return sample, pdf, largest, np.array(si.wi)


def vectorised_functions(parameters, theta, phi):
    """`sample` and `pdf` of the plug-in in the vectorised variant that is set."""
    bsdf = mi.load_dict({"type": "vgroove", **parameters})
    context, si = mi.BSDFContext(), dr.zeros(mi.SurfaceInteraction3f)
    si.wi = [math.sin(theta) * math.cos(phi), math.sin(theta) * math.sin(phi), math.cos(theta)]
    si.wavelengths = dr.full(type(si.wavelengths), 550)

    largest = [0.0]

    def sample(u):
        drawn, weight = bsdf.sample(context, si, u.x, mi.Point2f(u.y, u.z))
        unpolarized = mi.unpolarized_spectrum(weight)
        largest[0] = max(largest[0], float(np.max(np.array(dr.max(unpolarized, axis=0)))))
        return drawn.wo, dr.select(drawn.pdf > 0, mi.Float(1), 0)

    return sample, lambda wo: bsdf.pdf(context, si, wo), largest, np.ravel(si.wi)


def check_vectorised(samples, test_count):
    """How many of the tests in the vectorised variant that is set have failed."""
    import mitsuba.chi2
    failed = 0
    for parameters, theta, phi in VECTORISED_CASES:
        sample, pdf, largest, e = vectorised_functions(parameters, math.radians(theta), math.radians(phi))
        domain = domain_of(parameters, e)
        test = mi.chi2.ChiSquareTest(domain=domain, sample_func=sample, pdf_func=weighted(domain, pdf), sample_dim=3,
                                     sample_count=samples, res=51, ires=8)
        passed = test.run(significance_level=FALSE_ALARM_RATE, test_count=test_count, quiet=True)
        name = ", ".join(f"{key} {value}" for key, value in parameters.items())
        print(f"{'passed' if passed else 'FAILED'}  {mi.variant()}: {name}, θ = {theta}°, φ = {phi}°: "
              f"p = {test.p_value:.2g}, density integrates to {test.pdf_sum[0]:.4f}, largest weight {largest[0]:.6f}",
              flush=True)
        if not passed or largest[0] > 1 + 1e-6:
            print(test.messages, file=sys.stderr)
            failed += 1
    return failed


def check_scalar(variant_of_test, options, test_count):
    """How many of the tests of the scalar variant have failed, which are run in another one."""
    mi.set_variant("scalar_rgb")
    vgroove.load(options.plug_in)
    functions = [scalar_functions(parameters, math.radians(theta), math.radians(phi))
                 for parameters, theta, phi in CASES]
    mi.set_variant(variant_of_test)
    import mitsuba.chi2
    failed = 0
    for (parameters, theta, phi), (sample, pdf, largest, e) in zip(CASES, functions):

        def sample_arrays(u, sample=sample):
            directions, weights = sample(np.array(u))
            return mi.Vector3f(directions.astype(np.float32)), mi.Float(weights.astype(np.float32))

        def pdf_array(wo, pdf=pdf):
            return mi.Float(pdf(np.array(wo)).astype(np.float32))

        domain = domain_of(parameters, e)
        test = mi.chi2.ChiSquareTest(domain=domain, sample_func=sample_arrays, pdf_func=weighted(domain, pdf_array),
                                     sample_dim=3, sample_count=options.samples, res=51, ires=8)
        passed = test.run(significance_level=FALSE_ALARM_RATE, test_count=test_count, quiet=True)
        name = ", ".join(f"{key} {value}" for key, value in parameters.items())
        print(f"{'passed' if passed else 'FAILED'}  {name}, θ = {theta}°, φ = {phi}°: p = {test.p_value:.2g}, "
              f"density integrates to {test.pdf_sum[0]:.4f}, largest weight {largest[0]:.6f}", flush=True)
        if not passed or largest[0] > 1 + 1e-6:
            print(test.messages, file=sys.stderr)
            failed += 1
    return failed


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--samples", type=int, default=200_000, help="directions per test; 200000 by default")
    parser.add_argument("--backend", default="llvm", choices=["llvm", "cuda"],
                        help="what the vectorised variants run on; llvm by default")
    parser.add_argument("--plug-in", metavar="FOLDER", default=None, help="where it was built; build/mitsuba by default")
    options = parser.parse_args()
    variants = [f"{options.backend}_ad_{colours}" for colours in COLOURS]
    vgroove.start(variants[0], options.plug_in)
    scalar_too = options.backend == "llvm"
    test_count = len(variants) * len(VECTORISED_CASES) + (len(CASES) if scalar_too else 0)
    failed = 0
    for variant in variants:
        mi.set_variant(variant)
        vgroove.load(options.plug_in)
        failed += check_vectorised(options.samples, test_count)
    if scalar_too:
        failed += check_scalar(variants[0], options, test_count)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
