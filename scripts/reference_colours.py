#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Prints the colour of one spectrum as another implementation, the PyPI package `colour-science`, integrates it.

    python3 -m venv venv && venv/bin/pip install colour-science==0.4.7
    venv/bin/python scripts/reference_colours.py

The numbers are those of tests/tools/spectral_weights_test.cpp: the reflectance is 0.5 + 0.4 sin(wavelength / 50 nm),
sampled from 380 to 780 nm in steps of 5 nm; XYZ with Y = 1 for a perfect reflector, and L*a*b*.
"""

import colour
import numpy

GRID = colour.SpectralShape(380, 780, 5)
OBSERVERS = ("CIE 1931 2 Degree Standard Observer", "CIE 1964 10 Degree Standard Observer")


def tristimulus(values, observer, illuminant):
    spectrum = colour.SpectralDistribution(values, GRID.wavelengths)
    functions = colour.MSDS_CMFS[observer].copy().align(GRID)
    light = colour.SDS_ILLUMINANTS[illuminant].copy().align(GRID)
    return colour.sd_to_XYZ(spectrum, functions, light, method="Integration") / 100


def main():
    reflectance = 0.5 + 0.4 * numpy.sin(GRID.wavelengths / 50)
    for illuminant in ("D65", "A", "E"):
        for observer in OBSERVERS:
            xyz = tristimulus(reflectance, observer, illuminant)
            white = tristimulus(numpy.ones(GRID.wavelengths.size), observer, illuminant)
            lab = colour.XYZ_to_Lab(xyz, colour.XYZ_to_xy(white))
            print(f"{illuminant}, {observer}:", *(f"{value:.10f}" for value in (*xyz, *white, *lab)))


if __name__ == "__main__":
    main()
