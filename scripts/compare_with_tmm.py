#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Compares thin films with the PyPI package tmm (S. J. Byrnes, 0.2.0), over random stacks.

    scripts/compare_with_tmm.py vcavity_maps [--stacks N] [--seed S]

Needs tmm and numpy. A groove of 180 degrees is a plane: the reflectance of one direction, and with --polarization
full the Mueller matrix, is that of the stack. tmm's r_p has the opposite sign, so that the phase between s and p is
compared with it turned. Prints the largest differences; fails when one exceeds 1e-11.
"""
import argparse
import json
import math
import random
import subprocess
import sys

from tmm import coh_tmm

LARGEST_DIFFERENCE = 1e-11
WAVELENGTH_NM = 550.0


def random_index(generator):
    """n and k of a dielectric, an absorbing medium or a metal."""
    kind = generator.randrange(3)
    if kind == 0:
        return round(generator.uniform(1.2, 3), 4), 0.0
    if kind == 1:
        return round(generator.uniform(1, 3), 4), round(math.exp(generator.uniform(-6, 0)), 6)
    return round(generator.uniform(0.05, 2), 4), round(generator.uniform(2, 7), 4)


def word(index):
    return f"{index[0]}+{index[1]}i"


def by_vcavity(program, films, substrate, theta_deg):
    """Reflectances of s and p light, and the sine and cosine part of what turns one into the other."""
    command = [program, "direction", "--aperture", "180", "--material", word(substrate), "--theta", repr(theta_deg)]
    command += ["--phi", "0", "--polarization", "full", "--format", "json", "--wavelength", repr(WAVELENGTH_NM)]
    for index, thickness_nm in films:
        command += ["--film", f"{word(index)}:{thickness_nm!r}"]
    answer = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
    m = answer["mueller"]
    one, two = m[0][0] + m[0][1], m[0][0] - m[0][1]
    # s is the axis along the groove, a; the mirror turns the sign of U and V.
    return one, two, m[2][2], m[2][3], answer["absorptance"]


def by_tmm(films, substrate, theta_deg):
    indices = [1.0] + [complex(*index) for index, _ in films] + [complex(*substrate)]
    thicknesses = [math.inf] + [thickness for _, thickness in films] + [math.inf]
    r_s, r_p = (
        coh_tmm(polarization, indices, thicknesses, math.radians(theta_deg), WAVELENGTH_NM)["r"]
        for polarization in "sp"
    )
    product = r_s * (-r_p).conjugate()
    absorbed = 1 - (abs(r_s) ** 2 + abs(r_p) ** 2) / 2
    return abs(r_s) ** 2, abs(r_p) ** 2, product.real, product.imag, absorbed


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", help="vcavity_maps")
    parser.add_argument("--stacks", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    generator = random.Random(options.seed)
    names = ["|r_s|^2", "|r_p|^2", "|Re r_s r_p*|", "|Im r_s r_p*|", "absorptance"]
    worst = [0.0] * len(names)
    for _ in range(options.stacks):
        films = [
            (random_index(generator), round(math.exp(generator.uniform(0, 6.5)), 3))
            for _ in range(generator.randrange(6))
        ]
        substrate = random_index(generator)
        theta_deg = round(generator.uniform(0, 89), 3)
        ours = by_vcavity(options.program, films, substrate, theta_deg)
        theirs = by_tmm(films, substrate, theta_deg)
        for i, (a, b) in enumerate(zip(ours, theirs)):
            # The sign of the mixed terms is one of the axes of the reflected light.
            difference = abs(abs(a) - abs(b)) if 2 <= i <= 3 else abs(a - b)
            worst[i] = max(worst[i], difference)
    for name, difference in zip(names, worst):
        print(f"{name}: largest difference {difference:.2g} over {options.stacks} stacks")
    if max(worst) > LARGEST_DIFFERENCE:
        sys.exit(f"differences above {LARGEST_DIFFERENCE}")


if __name__ == "__main__":
    main()
