#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Lets Radiance read what `vcavity_maps export` writes, and compares its numbers with those of `vcavity_maps direction`:
the reflectance of directions, and the BRDF of pairs away from the mirror direction, where it varies little within a
patch. Needs `pip install pyradiance`, which brings Radiance's library for such files."""

import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

from pyradiance import bsdf

SURFACE = ["--material", "Ag", "--distribution", "ggx", "--roughness", "0.6"]
# Near the mirror direction the BRDF grows like 1/|h|, which a patch averages over a few points.
REFLECTANCE_TOLERANCE = 0.02
BRDF_TOLERANCE = 0.03  # relative


def direction(program, *options):
    return json.loads(subprocess.run([program, "direction", *SURFACE, *options, "--format", "json"], check=True,
                                     capture_output=True, text=True).stdout)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", help="vcavity_maps")
    options = parser.parse_args()
    failed = False
    with tempfile.TemporaryDirectory() as folder:
        file = str(pathlib.Path(folder) / "surface.xml")
        subprocess.run([options.program, "export", *SURFACE, "--out", file], check=True)
        table = bsdf.load_file(file)

        def compare(name, theirs, ours, allowed):
            nonlocal failed
            print(f"{name}: Radiance {theirs:.4f}, vcavity {ours:.4f}")
            failed |= not abs(theirs - ours) <= allowed

        # The exterior of a BSDF lies at z < 0.
        for theta in (0, 20, 40, 60):
            ours = direction(options.program, "--theta", str(theta), "--phi", "0")["reflectance"]
            compare(f"reflectance at {theta}°", bsdf.direct_hemi(table, 180 - theta, 0, bsdf.SAMPLE_ALL), ours,
                    REFLECTANCE_TOLERANCE)
        for theta, toward, phi in [(0, 40, 90), (30, 40, 0), (40, 30, 90), (60, 20, 45), (20, 60, 0)]:
            ours = direction(options.program, "--theta", str(theta), "--phi", "0", "--toward", f"{toward},{phi}")
            compare(f"BRDF from {theta}°, 0° to {toward}°, {phi}°",
                    bsdf.query(table, 180 - theta, 0, 180 - toward, phi)[1], ours["brdf"], BRDF_TOLERANCE * ours["brdf"])
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
