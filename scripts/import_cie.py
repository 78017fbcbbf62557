#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the CIE colour-matching functions and illuminants of data/cie, 360 to 780 nm in steps of 5 nm.

The figures are taken from the PyPI package `colour-science` (BSD-3-Clause):

    python3 -m venv venv && venv/bin/pip install colour-science==0.4.7
    venv/bin/python scripts/import_cie.py
"""

import importlib.metadata
import pathlib

import colour

DESTINATION = pathlib.Path(__file__).resolve().parent.parent / "data" / "cie"
WAVELENGTHS_NM = range(360, 781, 5)

OBSERVERS = {
    "cie_1931_2deg": ("CIE 1931 2 Degree Standard Observer", "CIE 1931 2 degree standard observer, ISO/CIE 11664-1"),
    "cie_1964_10deg": ("CIE 1964 10 Degree Standard Observer", "CIE 1964 10 degree standard observer, ISO/CIE 11664-1"),
}
ILLUMINANTS = {
    "illuminant_a": ("A", "CIE standard illuminant A, relative spectral power, ISO/CIE 11664-2"),
    "illuminant_d65": ("D65", "CIE standard illuminant D65, relative spectral power, ISO/CIE 11664-2"),
    "illuminant_e": ("E", "Illuminant E, equal power at every wavelength"),
}


def write(name, title, columns, values_at):
    version = importlib.metadata.version("colour-science")
    lines = [
        f"# {title}",
        f"# {WAVELENGTHS_NM[0]} to {WAVELENGTHS_NM[-1]} nm in steps of {WAVELENGTHS_NM.step} nm",
        f"# Written by scripts/import_cie.py from the PyPI package colour-science {version} (BSD-3-Clause).",
        f"# wavelength_nm,{columns}",
    ]
    for wavelength in WAVELENGTHS_NM:
        lines.append(",".join([str(wavelength), *(f"{value:.12g}" for value in values_at(wavelength))]))
    (DESTINATION / f"{name}.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")


def main():
    for name, (key, title) in OBSERVERS.items():
        write(name, title, "x_bar,y_bar,z_bar", lambda nm: colour.MSDS_CMFS[key][nm])
    for name, (key, title) in ILLUMINANTS.items():
        write(name, title, "power", lambda nm: [colour.SDS_ILLUMINANTS[key][nm]])


if __name__ == "__main__":
    main()
