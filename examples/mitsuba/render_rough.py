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


def sphere(bsdf, centre):
    """A sphere standing on its place, with ∂p/∂u along the circles of latitude."""
    transform = mi.ScalarTransform4f()
    return {"type": "sphere", "to_world": transform.translate(centre).scale(0.47), "bsdf": bsdf}


def row(metal, height):
    """One sphere for each roughness, side by side in the plane of the picture."""
    middle = (len(ROUGHNESSES) - 1) / 2
    return {f"sphere_{height}_{i}".replace(".", "_").replace("-", "m"): sphere(metal(roughness), [i - middle, 0, height])
            for i, roughness in enumerate(ROUGHNESSES)}


def rough(material, **parameters):
    return lambda roughness: {"type": "vgroove", "material": material, "roughness": roughness, **parameters}


def scene(material, width, samples):
    rows = [rough(material, distribution="ggx", max_bounces=1), rough(material, distribution="ggx"),
            rough(material, distribution="brushed", concentration=200.0)]
    transform = mi.ScalarTransform4f()
    objects = {}
    for i, metal in enumerate(rows):
        objects.update(row(metal, float(1 - i)))
    return mi.load_dict({
        "type": "scene",
        "integrator": {"type": "path", "max_depth": 2, "hide_emitters": True},  # no sphere mirrors its neighbours
        "sky": {"type": "envmap", "bitmap": render_bowl.studio(), "to_world": transform.rotate([1, 0, 0], 90)},
        **objects,
        "sensor": {"type": "orthographic",
                   "to_world": transform.look_at([0, -5, 0], [0, 0, 0], [0, 0, 1]).scale([2.5, 2.5, 1]),
                   "film": {"type": "hdrfilm", "width": width, "height": width * 3 // len(ROUGHNESSES),
                            "pixel_format": "rgba", "rfilter": {"type": "gaussian"}},
                   "sampler": {"type": "multijitter", "sample_count": samples}},
    })


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("output", nargs="?", type=pathlib.Path, default=pathlib.Path("rough.png"),
                        help="PNG file to write; rough.png by default")
    parser.add_argument("--material", default="Cu", help="one of Mitsuba's metals; Cu by default")
    parser.add_argument("--width", type=int, default=720, help="pixels; 720 by default")
    parser.add_argument("--samples", type=int, default=144, help="paths per pixel; 144 by default")
    parser.add_argument("--variant", default="scalar_rgb", help="Mitsuba's variant; scalar_rgb by default")
    parser.add_argument("--plug-in", metavar="FOLDER", default=None, help="where it was built; build/mitsuba by default")
    options = parser.parse_args()
    mi.set_variant(options.variant)
    import vgroove
    vgroove.load(options.plug_in)

    pixels = np.array(mi.render(scene(options.material, options.width, options.samples)))
    cover = np.clip(pixels[..., 3:], 0, 1)
    picture = 1 - np.exp(-1.5 * (pixels[..., :3] + BACKDROP * (1 - cover)))  # like film
    mi.Bitmap(picture.astype(np.float32)).convert(mi.Bitmap.PixelFormat.RGB, mi.Struct.Type.UInt8, True).write(
        str(options.output), quality=9)


if __name__ == "__main__":
    main()
