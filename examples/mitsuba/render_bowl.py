#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Renders a copper bowl turned on a lathe and a grooved disc under studio lights, three times side by side: with all
bounces, with single bounces only, and as flat metal."""

import argparse
import pathlib

import mitsuba as mi
import numpy as np


def surface_of_revolution(name, radii, heights, bsdf, sectors=360):
    """A mesh whose ∂p/∂u runs around the axis z, like the grooves that a lathe cuts."""
    turns = np.linspace(0, 1, sectors + 1)
    angles = 2 * np.pi * turns
    vertices = [(r * np.cos(a), r * np.sin(a), z) for r, z in zip(radii, heights) for a in angles]
    texcoords = [(turn, i / (len(radii) - 1)) for i in range(len(radii)) for turn in turns]
    row = sectors + 1
    faces = []
    for i in range(len(radii) - 1):
        for j in range(sectors):
            a, b, c, d = i * row + j, i * row + j + 1, (i + 1) * row + j, (i + 1) * row + j + 1
            faces += [(a, b, d), (a, d, c)]
    return vgroove.triangle_mesh(name, vertices, faces, texcoords, bsdf)


def bowl(bsdf):
    """A hemispherical bowl with a rounded lip, standing on z = 0; walked inside out, so that normals face outwards."""
    inner, outer = 0.94, 1.0
    inside = np.linspace(0.01, np.pi / 2, 60)
    lip = np.linspace(0, np.pi, 12)[1:-1]
    outside = np.linspace(np.pi / 2, 0.35, 60)
    middle, thickness = (inner + outer) / 2, (outer - inner) / 2
    radii = np.concatenate([inner * np.sin(inside), middle - thickness * np.cos(lip), outer * np.sin(outside)])
    heights = np.concatenate([1 - inner * np.cos(inside), 1 + thickness * np.sin(lip), 1 - outer * np.cos(outside)])
    return surface_of_revolution("bowl", radii, heights - heights.min(), bsdf)


def disc(bsdf, centre):
    """A flat ring, like a gramophone record."""
    mesh = surface_of_revolution("disc", np.linspace(0.85, 0.22, 30), np.zeros(30), bsdf)
    params = mi.traverse(mesh)
    params["vertex_positions"] = np.ravel(np.reshape(params["vertex_positions"], (-1, 3)) + centre)
    params.update()
    return mesh


def studio():
    """A dim room with soft boxes, as an environment map with z up."""
    height, width = 256, 512
    elevation = np.pi / 2 - np.pi * (np.arange(height) + 0.5) / height
    azimuth = 2 * np.pi * (np.arange(width) + 0.5) / width
    sky = np.zeros((height, width, 3))
    sky += np.where(elevation > 0, 0.10 + 0.25 * np.sin(np.maximum(elevation, 0)), 0.06)[:, None, None] * [0.9, 0.97, 1.1]

    def soft_box(azimuth_deg, half_width_deg, low_deg, high_deg, radiance):
        off = np.abs((np.degrees(azimuth) - azimuth_deg + 180) % 360 - 180)
        across = np.clip((half_width_deg - off) / 2 + 0.5, 0, 1)
        up = np.degrees(elevation)
        along = np.clip((up - low_deg) / 2 + 0.5, 0, 1) * np.clip((high_deg - up) / 2 + 0.5, 0, 1)
        sky[...] += along[:, None, None] * across[None, :, None] * np.array(radiance)

    soft_box(60, 22, 25, 60, [4.0, 4.0, 4.0])
    soft_box(205, 14, 10, 70, [2.6, 2.8, 3.2])
    soft_box(300, 30, 35, 50, [2.5, 2.3, 1.9])
    soft_box(140, 6, 5, 60, [2.4, 2.4, 2.4])
    return mi.Bitmap(sky.astype(np.float32))


def scene(metal_of, width, height, samples):
    """`metal_of(material, aperture)` is the BSDF of the two objects."""
    transform = mi.ScalarTransform4f()
    return mi.load_dict({
        "type": "scene",
        "integrator": {"type": "path", "max_depth": 12},
        "sky": {"type": "envmap", "bitmap": studio(), "to_world": transform.rotate([1, 0, 0], 90)},
        "table": {"type": "rectangle", "to_world": transform.scale([30, 30, 1]),
                  "bsdf": {"type": "diffuse", "reflectance": {"type": "rgb", "value": [0.20, 0.20, 0.21]}}},
        "bowl": bowl(metal_of("Cu", 75)),
        "disc": disc(metal_of("Au", 70), [0.78, -1.62, 0.02]),
        "sensor": {"type": "perspective", "fov": 23, "fov_axis": "larger",
                   "to_world": transform.look_at([0.9, -7.0, 5.2], [0.30, -0.74, 0.26], [0, 0, 1]),
                   "film": {"type": "hdrfilm", "width": width, "height": height, "pixel_format": "rgb",
                            "rfilter": {"type": "gaussian"}},
                   "sampler": {"type": "multijitter", "sample_count": samples}},
    })


def grooved(max_bounces):
    return lambda material, aperture: {"type": "twosided", "bsdf": {
        "type": "vgroove", "material": material, "aperture": aperture, "max_bounces": max_bounces}}


def flat(material, _):
    return {"type": "twosided", "bsdf": {"type": "conductor", "material": material}}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("output", nargs="?", type=pathlib.Path, default=pathlib.Path("vgroove.png"),
                        help="PNG file to write; vgroove.png by default")
    parser.add_argument("--width", type=int, default=310, help="pixels of one of the three pictures; 310 by default")
    parser.add_argument("--samples", type=int, default=256, help="paths per pixel; 256 by default")
    parser.add_argument("--variant", default="scalar_rgb", help="Mitsuba's variant; scalar_rgb by default")
    parser.add_argument("--plug-in", metavar="FOLDER", default=None, help="where it was built; build/mitsuba by default")
    options = parser.parse_args()
    mi.set_variant(options.variant)
    global vgroove
    import vgroove
    vgroove.load(options.plug_in)

    pictures = [np.array(mi.render(scene(metal, options.width, options.width, options.samples)))
                for metal in (grooved(-1), grooved(1), flat)]
    gap = 10 * np.ones((pictures[0].shape[0], 6, 3), np.float32)
    row = 1 - np.exp(-1.1 * np.concatenate([pictures[0], gap, pictures[1], gap, pictures[2]], axis=1))  # like film
    mi.Bitmap(row.astype(np.float32)).convert(mi.Bitmap.PixelFormat.RGB, mi.Struct.Type.UInt8, True).write(
        str(options.output), quality=9)


if __name__ == "__main__":
    main()
