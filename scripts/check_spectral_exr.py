#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that another program, the PyPI package `colour-science`, gets our numbers from our spectral EXR images.

    python3 -m venv venv && venv/bin/pip install colour-science OpenImageIO scipy
    venv/bin/python scripts/check_spectral_exr.py PATH/TO/vcavity_maps

A map of silver is written in every precision and compression; the spectrum that colour-science reads at some pixels
must be that of `vcavity_maps direction`, and the R, G, B preview must be what colour-science makes of the spectrum.
Prints the largest differences; ends with status 1 if one is larger than rounding explains.
"""

import json
import math
import subprocess
import sys
import tempfile
from pathlib import Path

import colour
import numpy

SIZE = 32
APERTURE_DEG = 60
# The points of the tables of the CIE: there the colour is a plain sum. The reflectance of silver is smooth between them.
GRID = colour.SpectralShape(400, 700, 5)
# One unit in the last place of a float or half.
ROUNDING = {"float": 2**-23, "half": 2**-10}


def spectrum_of(program, theta_deg, phi_deg):
    """The directional reflectance at every wavelength of the grid, as the program prints it."""
    values = []
    for wavelength in GRID.wavelengths:
        answer = subprocess.run(
            [program, "direction", "--material", "Ag", "--aperture", str(APERTURE_DEG), "--theta", repr(theta_deg),
             "--phi", repr(phi_deg), "--wavelength", repr(float(wavelength)), "--format", "json"],
            check=True, capture_output=True, text=True)
        values.append(json.loads(answer.stdout)["reflectance"])
    return numpy.array(values)


def direction_of(row, column):
    """θ and φ in degrees of a pixel of the equal-area disc."""
    u = math.sqrt(2) * ((column + 0.5) * 2 / SIZE - 1)
    v = math.sqrt(2) * (1 - (row + 0.5) * 2 / SIZE)
    return math.degrees(2 * math.asin(math.hypot(u, v) / 2)), math.degrees(math.atan2(v, u))


def preview_of(spectra):
    """Linear sRGB of reflectances in D65 for the CIE 1931 2 degree observer."""
    functions = colour.MSDS_CMFS["CIE 1931 2 Degree Standard Observer"].copy().align(GRID)
    light = colour.SDS_ILLUMINANTS["D65"].copy().align(GRID)
    weights = functions.values * light.values[:, None]
    return colour.XYZ_to_sRGB(spectra @ weights / weights[:, 1].sum(), apply_cctf_encoding=False)


def check(program, file, precision, compression):
    subprocess.run(
        [program, "map", "--material", "Ag", "--aperture", str(APERTURE_DEG), "--size", str(SIZE), "--wavelengths",
         f"{GRID.start:g}:{GRID.end:g}:{GRID.interval:g}", "--precision", precision, "--compression", compression,
         "--out", str(file)], check=True)
    components = colour.read_spectral_image_Fichet2021(file)
    wavelengths, image = components["T"]
    assert numpy.array_equal(wavelengths, GRID.wavelengths), wavelengths

    worst = 0.0
    for row, column in ((3, 16), (10, 5), (16, 16), (20, 29)):
        expected = spectrum_of(program, *direction_of(row, column))
        worst = max(worst, float(numpy.max(numpy.abs(image[row, column] / expected - 1))))

    rgb = colour.read_image(str(file))[..., :3]
    inside = image[..., 0] > 0
    preview = float(numpy.max(numpy.abs(rgb[inside] - preview_of(image[inside]))))
    good = worst <= ROUNDING[precision] and preview <= ROUNDING[precision]
    print(f"{precision:5} {compression:4}: spectrum differs by {worst:.1e} relative, preview by {preview:.1e}"
          f"{'' if good else '  FAILED'}")
    return good


def main():
    program = sys.argv[1]
    with tempfile.TemporaryDirectory() as folder:
        results = [check(program, Path(folder) / "map.exr", precision, compression)
                   for precision in ("float", "half") for compression in ("none", "rle", "zips", "zip", "piz")]
    sys.exit(0 if all(results) else 1)


if __name__ == "__main__":
    main()
