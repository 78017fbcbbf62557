#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that `vgroove` accepts what its documentation says and refuses the rest with a text that tells why."""

import sys

import mitsuba as mi

ACCEPTED = [
    {"material": "Cu"},
    {"material": "Cu", "aperture": 180.0, "rotation": -30.0, "max_bounces": 1, "polarized": True, "lobe_width": 2.0},
    {"eta": 1.5},
    {"eta": {"type": "spectrum", "value": 0.2}, "k": {"type": "spectrum", "value": 3.9}, "max_bounces": -1},
]
REFUSED = [
    ({}, "give a material"),
    ({"material": "Cu", "eta": 1.5}, "either a material or eta and k"),
    ({"material": "Cu", "aperture": 200.0}, "the aperture of a groove must lie in (0, π] radians"),
    ({"material": "Cu", "aperture": 0.0}, "the aperture of a groove must lie in (0, π] radians"),
    ({"material": "Cu", "max_bounces": 0}, "must be positive or -1, not 0"),
    ({"material": "Cu", "lobe_width": -1.0}, "the width of a lobe"),
    ({"material": "unobtainium"}, "unobtainium"),
    ({"material": "Cu", "apperture": 60.0}, "apperture"),
]


def main():
    for variant in ("scalar_rgb", "scalar_spectral", "scalar_spectral_polarized"):
        mi.set_variant(variant)
        import vgroove
        vgroove.load(sys.argv[1] if len(sys.argv) > 1 else None)
        for parameters in ACCEPTED:
            mi.load_dict({"type": "vgroove", **parameters})
        for parameters, reason in REFUSED:
            try:
                mi.load_dict({"type": "vgroove", **parameters})
            except RuntimeError as error:
                if reason not in str(error):
                    raise SystemExit(f"{variant}: {parameters} was refused, but with: {error}")
            else:
                raise SystemExit(f"{variant}: {parameters} was accepted")


if __name__ == "__main__":
    main()
