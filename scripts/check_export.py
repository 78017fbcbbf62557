#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Lets other programs read what `vcavity_maps export` writes, and compares their numbers with those of `vcavity_maps
direction`: the reflectance of directions, and the BRDF of pairs away from the mirror direction.

BSDF XML is read by Radiance (`pip install pyradiance`), which knows the means over Klems' patches; `measured` by Mitsuba
(`pip install mitsuba`). Those that are installed are asked. A MERL file is looked up here, in the way of the reader that
comes with the MERL database."""

import argparse
import json
import math
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

SURFACE = ["--material", "Ag", "--distribution", "ggx", "--roughness", "0.6"]
PAIRS = [(0, 40, 90), (30, 40, 0), (40, 30, 90), (60, 20, 45), (20, 60, 0)]  # θ, θ and φ, degrees
# Next to the mirror direction the BRDF varies within a patch of Klems and within a cell of MERL.
NEXT_TO_MIRROR = [(30, 35, 170)]
# (azimuth, θ of the centre, of the lower and of the upper bound) of patches of Klems' basis, in degrees
PATCHES = [(0, 0, 0, 5), (0, 20, 15, 25), (90, 40, 35, 45), (0, 60, 55, 65), (0, 82, 75, 90)]
SAMPLES = 20_000
# Of reflectances and, relatively, of BRDFs: of Radiance with its patches, whose mean the BRDF is; of Mitsuba, between
# whose nodes it is linear; and of MERL, whose cells are steps.
TOLERANCES = {"Radiance": (1e-3, 0.03), "Mitsuba": (5e-3, 0.01), "MERL": (None, 0.03)}


class Check:
    def __init__(self, program):
        self.program, self.failed = program, False

    def direction(self, *options):
        command = [self.program, "direction", *SURFACE, *options, "--format", "json"]
        return json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)

    def reflectance(self, theta, phi=0):
        return self.direction("--theta", f"{theta:.6f}", "--phi", str(phi))["reflectance"]

    def export(self, path):
        subprocess.run([self.program, "export", *SURFACE, "--out", str(path)], check=True)
        return str(path)

    def compare(self, reader, name, theirs, ours, allowed):
        print(f"{name}: {reader} {theirs:.4f}, vcavity {ours:.4f}", flush=True)
        self.failed |= not abs(theirs - ours) <= allowed

    def compare_pairs(self, reader, brdf, pairs=PAIRS):
        """`brdf` takes the angles of a pair."""
        for theta, toward, phi in pairs:
            ours = self.direction("--theta", str(theta), "--phi", "0", "--toward", f"{toward},{phi}")["brdf"]
            self.compare(reader, f"BRDF from {theta}°, 0° to {toward}°, {phi}°", brdf(theta, toward, phi), ours,
                         TOLERANCES[reader][1] * ours)


def check_radiance(check, folder):
    from pyradiance import bsdf
    table = bsdf.load_file(check.export(folder / "surface.xml"))
    # The exterior of a BSDF lies at z < 0.
    for phi, centre, low, high in PATCHES:
        sines = np.sin(np.radians([low, high]))**2
        angles = np.degrees(np.arcsin(np.sqrt(sines[0] + (sines[1] - sines[0]) * (np.arange(4) + 0.5) / 4)))
        check.compare("Radiance", f"reflectance from {low}° to {high}°",
                      bsdf.direct_hemi(table, 180 - centre, phi, bsdf.SAMPLE_ALL),
                      np.mean([check.reflectance(theta, phi) for theta in angles]), TOLERANCES["Radiance"][0])
    check.compare_pairs("Radiance", lambda theta, toward, phi: bsdf.query(table, 180 - theta, 0, 180 - toward, phi)[1])


def vector(theta, phi):
    theta, phi = math.radians(theta), math.radians(phi)
    return [math.sin(theta) * math.cos(phi), math.sin(theta) * math.sin(phi), math.cos(theta)]


def check_mitsuba(check, folder):
    import mitsuba as mi
    mi.set_variant("scalar_spectral")
    measured = mi.load_dict({"type": "measured", "filename": check.export(folder / "surface.bsdf")})
    context, si = mi.BSDFContext(), mi.SurfaceInteraction3f()
    si.wavelengths = [550, 550, 550, 550]

    def brdf(theta, toward, phi):
        si.wi, wo = vector(theta, 0), vector(toward, phi)
        return measured.eval(context, si, wo)[0] / wo[2]

    numbers = np.random.default_rng(1).uniform(size=(SAMPLES, 3)).tolist()
    for theta in (2.5, 20, 40, 60, 80):
        si.wi = vector(theta, 10)
        drawn = [measured.sample(context, si, u[0], u[1:]) for u in numbers]
        mean = np.mean([weight[0] if sample.pdf > 0 else 0 for sample, weight in drawn])
        check.compare("Mitsuba", f"reflectance at {theta}°", mean, check.reflectance(theta), TOLERANCES["Mitsuba"][0])
    check.compare_pairs("Mitsuba", brdf, PAIRS + NEXT_TO_MIRROR)


def check_merl(check, folder):
    data = pathlib.Path(check.export(folder / "surface.binary")).read_bytes()
    theta_h, theta_d, phi_d = np.frombuffer(data, np.int32, 3)
    green = np.frombuffer(data, np.float64, offset=12).reshape(3, theta_h, theta_d, phi_d)[1] * 1.15 / 1500

    def brdf(theta, toward, phi):
        e, o = np.array(vector(theta, 0)), np.array(vector(toward, phi))
        h = (e + o) / np.linalg.norm(e + o)
        polar, azimuth = math.acos(h[2]), math.atan2(h[1], h[0])
        x, y = e[0] * math.cos(azimuth) + e[1] * math.sin(azimuth), e[1] * math.cos(azimuth) - e[0] * math.sin(azimuth)
        d = [x * math.cos(polar) - e[2] * math.sin(polar), y, e[2] * math.cos(polar) + x * math.sin(polar)]
        turned = math.atan2(d[1], d[0]) % math.pi
        return green[min(int(math.sqrt(polar / (math.pi / 2)) * theta_h), theta_h - 1),
                     min(int(math.acos(min(d[2], 1)) / (math.pi / 2) * theta_d), theta_d - 1),
                     min(int(turned / math.pi * phi_d), phi_d - 1)]

    check.compare_pairs("MERL", brdf)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", help="vcavity_maps")
    check = Check(parser.parse_args().program)
    with tempfile.TemporaryDirectory() as folder:
        for check_reader in (check_radiance, check_mitsuba, check_merl):
            try:
                check_reader(check, pathlib.Path(folder))
            except ImportError as error:
                print(f"left out: {error}")
    return 1 if check.failed else 0


if __name__ == "__main__":
    sys.exit(main())
