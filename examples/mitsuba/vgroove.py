# SPDX-License-Identifier: BSD-3-Clause
"""Makes the plug-in `vgroove` known to Mitsuba, and builds what the scenes of this folder share."""

import pathlib

import mitsuba as mi
import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]


def load(build_folder=None):
    """Puts the folder of the built plug-in, build/mitsuba by default, on Mitsuba's search path."""
    folder = pathlib.Path(build_folder or ROOT / "build" / "mitsuba")
    if not (folder / "plugins" / "vgroove.so").exists():
        raise SystemExit(f"{folder} holds no plugins/vgroove.so; build it first:\n"
                         f"  cmake -S {ROOT}/examples/mitsuba -B {folder} && cmake --build {folder}")
    mi.file_resolver().prepend(str(folder))


def triangle_mesh(name, vertices, faces, texcoords=None, bsdf=None):
    """A mesh from arrays; `bsdf` is a dictionary as `mi.load_dict` takes it. Normals are those of the faces
    unless there are texture coordinates, which come with smooth normals."""
    props = mi.Properties()
    if bsdf is not None:
        props["bsdf"] = mi.load_dict(bsdf)
    mesh = mi.Mesh(name, len(vertices), len(faces), has_vertex_normals=texcoords is not None,
                   has_vertex_texcoords=texcoords is not None, props=props)
    params = mi.traverse(mesh)
    params["vertex_positions"] = np.ravel(vertices).astype(np.float32)
    params["faces"] = np.ravel(faces).astype(np.uint32)
    if texcoords is not None:
        params["vertex_texcoords"] = np.ravel(texcoords).astype(np.float32)
    params.update()
    if texcoords is not None:
        mesh.recompute_vertex_normals()
    return mesh
