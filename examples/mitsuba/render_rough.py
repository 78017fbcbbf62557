#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Renders spheres of rough copper in three rows: of roughness 0.1 to 1 with the first bounce only, as in common models
of rough metal; the same with all bounces; and brushed, with all bounces."""

import argparse
import pathlib

import mitsuba as mi
import numpy as np

import render_bowl

ROUGHNESSES = (0.1, 0.3, 0.5, 0.75, 1.0)
BACKDROP = 0.05  # radiance


def rough(**parameters):
    return lambda material, roughness: {"type": "vgroove", "material": material, "roughness": roughness, **parameters}


ROWS = (rough(distribution="ggx", max_bounces=1), rough(distribution="ggx"),
        rough(distribution="brushed", concentration=200.0))


def scene(metal, width, samples):
    """One sphere alone, with ∂p/∂u along its circles of latitude."""
    transform = mi.ScalarTransform4f()
    return mi.load_dict({
        "type": "scene",
        "integrator": {"type": "path", "max_depth": 2, "hide_emitters": True},
        "sky": {"type": "envmap", "bitmap": render_bowl.studio(), "to_world": transform.rotate([1, 0, 0], 90)},
        "sphere": {"type": "sphere", "bsdf": metal},
        "sensor": {"type": "orthographic",
                   "to_world": transform.look_at([0, -5, 0], [0, 0, 0], [0, 0, 1]).scale([1.06, 1.06, 1]),
                   "film": {"type": "hdrfilm", "width": width, "height": width,
                            "pixel_format": "rgba", "rfilter": {"type": "gaussian"}},
                   "sampler": {"type": "multijitter", "sample_count": samples}},
    })


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("output", nargs="?", type=pathlib.Path, default=pathlib.Path("rough.png"),
                        help="PNG file to write; rough.png by default")
    parser.add_argument("--material", default="Cu", help="one of Mitsuba's metals; Cu by default")
    parser.add_argument("--width", type=int, default=720, help="pixels; 720 by default")
    parser.add_argument("--samples", type=int, default=64, help="paths per pixel; 64 by default")
    parser.add_argument("--variant", default="scalar_rgb", help="Mitsuba's variant; scalar_rgb by default")
    parser.add_argument("--plug-in", metavar="FOLDER", default=None, help="where it was built; build/mitsuba by default")
    options = parser.parse_args()
    mi.set_variant(options.variant)
    import vgroove
    vgroove.load(options.plug_in)

    width = options.width // len(ROUGHNESSES)
    pixels = np.concatenate([np.concatenate([np.array(mi.render(scene(metal(options.material, roughness), width,
                                                                      options.samples)))
                                             for roughness in ROUGHNESSES], axis=1) for metal in ROWS])
    cover = np.clip(pixels[..., 3:], 0, 1)
    picture = 1 - np.exp(-1.5 * (pixels[..., :3] + BACKDROP * (1 - cover)))  # like film
    mi.Bitmap(picture.astype(np.float32)).convert(mi.Bitmap.PixelFormat.RGB, mi.Struct.Type.UInt8, True).write(
        str(options.output), quality=9)


if __name__ == "__main__":
    main()
