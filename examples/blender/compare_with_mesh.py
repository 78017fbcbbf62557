#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Compares the shader vgroove.osl on a flat plate with grooves modelled as a mesh, in Blender's renderer Cycles.

The mesh has Cycles' own metal without roughness. Both are seen from one direction under one patchy sky. Prints a Markdown
table of radiances, averaged over three colours, and ends with status 1 if they differ by more than noise explains.

Needs `pip install bpy`, for the Python of its wheel."""

import argparse
import hashlib
import math
import pathlib
import sys
import tempfile

import bpy
import numpy as np
from mathutils import Matrix, Vector

SHADER = pathlib.Path(__file__).resolve().parent / "vgroove.osl"
COPPER = ((0.22, 0.92, 1.15), (3.8, 2.5, 2.4))  # n and k for red, green, blue
GLASS = ((1.5, 1.5, 1.5), (0.0, 0.0, 0.0))
# (name, n and k, aperture, θ, φ) in degrees; φ is measured from the direction across the grooves
CASES = [(name, index, aperture, theta, phi)
         for name, index, aperture in [("copper", COPPER, 40), ("copper", COPPER, 60), ("copper", COPPER, 130),
                                       ("glass", GLASS, 60)]
         for theta, phi in [(5, 20), (35, 0), (50, 60), (75, 30)]]
PIXELS = 8  # of a side of the picture: as many independent numbers, for the noise
LARGEST_DEVIATION = 4  # of one number, in σ
SYSTEMATIC_ERROR = 2e-4  # of a radiance: rays that meet edges of the mesh, single precision


def new_scene(samples, seed):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    cycles = scene.cycles
    cycles.device, cycles.shading_system, cycles.samples, cycles.seed = "CPU", True, samples, seed
    cycles.use_adaptive_sampling = cycles.use_denoising = False
    cycles.max_bounces = cycles.glossy_bounces = 64
    cycles.sample_clamp_indirect, cycles.blur_glossy = 0, 0
    cycles.pixel_filter_type = "BOX"
    scene.render.resolution_x = scene.render.resolution_y = PIXELS
    scene.render.threads_mode, scene.render.threads = "FIXED", 1
    image = scene.render.image_settings
    image.file_format, image.color_depth, image.color_mode = "OPEN_EXR", "32", "RGB"
    return scene


def add_sky(scene, patches):
    rows, columns, _ = patches.shape
    image = bpy.data.images.new("sky", columns, rows, float_buffer=True, is_data=True)
    image.pixels = np.concatenate([patches, np.ones((rows, columns, 1))], axis=2).ravel().tolist()
    world = bpy.data.worlds.new("world")
    scene.world = world
    if world.node_tree is None:
        world.use_nodes = True
    nodes, links = world.node_tree.nodes, world.node_tree.links
    nodes.clear()
    texture, output = nodes.new("ShaderNodeTexEnvironment"), nodes.new("ShaderNodeOutputWorld")
    background = nodes.new("ShaderNodeBackground")
    texture.image = image
    links.new(texture.outputs["Color"], background.inputs["Color"])
    links.new(background.outputs["Background"], output.inputs["Surface"])
    world.cycles.sampling_method = "NONE"  # mirrors do not meet it by chance


def material_with(make):
    """A material whose surface is the output of the node that `make` adds."""
    material = bpy.data.materials.new("surface")
    if material.node_tree is None:
        material.use_nodes = True
    tree = material.node_tree
    tree.nodes.clear()
    output = tree.nodes.new("ShaderNodeOutputMaterial")
    tree.links.new(make(tree.nodes), output.inputs["Surface"])
    return material


def metal(index):
    def make(nodes):
        node = nodes.new("ShaderNodeBsdfMetallic")
        node.fresnel_type = "PHYSICAL_CONDUCTOR"
        node.inputs["IOR"].default_value, node.inputs["Extinction"].default_value = index
        node.inputs["Roughness"].default_value = 0
        return node.outputs["BSDF"]
    return material_with(make)


def grooves(index, aperture):
    """The shader: compiled by Blender, with its parameters as the sockets of a node."""
    import _cycles

    def make(nodes):
        with tempfile.TemporaryDirectory() as folder:
            compiled = pathlib.Path(folder) / "vgroove.oso"
            if not _cycles.osl_compile(str(SHADER), str(compiled)):
                raise SystemExit(f"{SHADER} does not compile")
            bytecode = compiled.read_text()
        node = nodes.new("ShaderNodeScript")
        node.bytecode, node.bytecode_hash = bytecode, hashlib.md5(bytecode.encode()).hexdigest()
        for name, kind, value in [("aperture", "NodeSocketFloat", aperture), ("n", "NodeSocketColor", (*index[0], 1)),
                                  ("k", "NodeSocketColor", (*index[1], 1))]:
            node.inputs.new(type=kind, name=name, identifier=name).default_value = value
        return node.outputs.new(type="NodeSocketShader", name="BSDF", identifier="BSDF")
    return material_with(make)


def add_mesh(scene, vertices, faces, material):
    mesh = bpy.data.meshes.new("mesh")
    mesh.from_pydata(vertices, [], faces)
    mesh.materials.append(material)
    scene.collection.objects.link(bpy.data.objects.new("object", mesh))


def add_plate(scene, index, aperture):
    corners = [(x, y, 0) for x, y in ((-200, -20), (200, -20), (200, 20), (-200, 20))]
    add_mesh(scene, corners, [(0, 1, 2, 3)], grooves(index, aperture))


def add_groove_mesh(scene, index, aperture):
    """Five long grooves along x, whose openings lie at z = 0."""
    half_width, depth = math.sin(math.radians(aperture) / 2), math.cos(math.radians(aperture) / 2)
    vertices, faces = [], []
    for groove in range(-2, 3):
        for y0, z0, y1, z1 in [(-half_width, 0, 0, -depth), (0, -depth, half_width, 0)]:
            first, shift = len(vertices), 2 * half_width * groove
            vertices += [(x, y + shift, z) for x in (-200, 200) for y, z in ((y0, z0), (y1, z1))]
            faces.append((first, first + 2, first + 3, first + 1))
    add_mesh(scene, vertices, faces, metal(index))


def add_camera(scene, aperture, theta, phi):
    """Parallel rays that meet the opening of the middle groove, all over its width."""
    theta, phi = math.radians(theta), math.radians(phi)
    towards = Vector((math.sin(theta) * math.sin(phi), math.sin(theta) * math.cos(phi), math.cos(theta)))
    width = 2 * math.sin(math.radians(aperture) / 2)
    # A picture that spans one period of the grooves covers all parts of an opening alike.
    along = Vector((1, 0, 0))
    along_seen = (along - along.dot(towards) * towards).normalized()
    right = along_seen.cross(towards)
    period = width * abs(Vector((0, 1, 0)).dot(right))
    camera = bpy.data.cameras.new("camera")
    camera.type, camera.ortho_scale, camera.clip_end = "ORTHO", period, 1000
    seen = bpy.data.objects.new("camera", camera)
    seen.matrix_world = Matrix.Translation(100 * towards) @ Matrix((right, along_seen, towards)).transposed().to_4x4()
    scene.collection.objects.link(seen)
    scene.camera = seen


def radiance(add_surface, patches, index, aperture, theta, phi, samples, seed):
    """Mean over the picture and the colours, and its standard error."""
    scene = new_scene(samples, seed)
    add_sky(scene, patches)
    add_surface(scene, index, aperture)
    add_camera(scene, aperture, theta, phi)
    with tempfile.TemporaryDirectory() as folder:
        scene.render.filepath = str(pathlib.Path(folder) / "picture.exr")
        bpy.ops.render.render(write_still=True)
        image = bpy.data.images.load(scene.render.filepath)
        image.colorspace_settings.name = "Non-Color"
        pixels = np.array(image.pixels).reshape(PIXELS, PIXELS, -1)[..., :3].mean(axis=2)
    # Columns lie at different places of the opening, which is no noise; rows repeat them.
    rows = pixels.mean(axis=1)
    return rows.mean(), rows.std(ddof=1) / math.sqrt(PIXELS)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--samples", type=int, default=2048, help="paths per pixel of 64; 2048 by default")
    options = parser.parse_args()
    patches = np.random.default_rng(1).uniform(0, 1, (16, 32, 3))
    print(f"Blender {bpy.app.version_string}, Cycles, {options.samples} paths per pixel of {PIXELS * PIXELS}\n\n"
          "| facets | aperture | θ | φ | mesh | shader | difference / σ |\n|---|---|---|---|---|---|---|")
    worst = 0
    for name, index, *angles in CASES:
        mesh, mesh_error = radiance(add_groove_mesh, patches, index, *angles, options.samples, 1)
        shader, shader_error = radiance(add_plate, patches, index, *angles, options.samples, 2)
        sigma = math.hypot(mesh_error, shader_error, SYSTEMATIC_ERROR * mesh)
        deviation = (shader - mesh) / sigma
        worst = max(worst, abs(deviation))
        print(f"| {name} | {angles[0]}° | {angles[1]}° | {angles[2]}° | {mesh:.5f} ± {mesh_error:.5f} "
              f"| {shader:.5f} ± {shader_error:.5f} | {deviation:+.1f} |", flush=True)
    return 1 if not worst < LARGEST_DEVIATION else 0


if __name__ == "__main__":
    sys.exit(main())
