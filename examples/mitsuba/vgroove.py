# SPDX-License-Identifier: BSD-3-Clause
"""Makes the plug-in `vgroove` known to Mitsuba, and builds what the scenes of this folder share."""

import pathlib
import sys
import time

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


def start(variant, build_folder=None):
    """Sets a variant and makes the plug-in known; ends the program with status 77, "skipped", where the variant does not
    start, as vectorised ones without LLVM or a GPU."""
    try:
        mi.set_variant(variant)
    except ImportError as error:
        print(f"skipped: {variant} does not start: {error}")
        sys.exit(77)
    load(build_folder)


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


def plate(bsdf, size, **others):
    """A rectangle of a BSDF that fills a square picture; `others` are light, integrator and film options of the scene, as
    `mi.load_dict` takes them."""
    film = {"type": "hdrfilm", "width": size, "height": size, **others.pop("film", {})}
    return mi.load_dict({
        "type": "scene", "plate": {"type": "rectangle", "bsdf": bsdf},
        "sensor": {"type": "perspective", "fov": 20.0,
                   "to_world": mi.ScalarTransform4f().look_at([1, -2, 2], [0, 0, 0], [0, 0, 1]),
                   "film": film, "sampler": {"type": "independent"}},
        **others})


def least_seconds(bsdfs, samples, repetitions):
    """Processor times of rendering 64 × 64 pixels of plates of several surfaces in a sky: each path takes a sample, a value
    and a density. The least of several times, in turn, so that what else a machine does meets all surfaces alike."""
    scenes = [plate(bsdf, 64, integrator={"type": "path", "max_depth": 2}, sky={"type": "constant"}) for bsdf in bsdfs]
    times = []
    for seed in range(repetitions + 1):
        times.append([])
        for scene in scenes:
            start = time.process_time()
            np.array(mi.render(scene, spp=samples, seed=seed))
            times[-1].append(time.process_time() - start)
    return np.min(times[1:], axis=0)  # the first picture of a scene prepares it


def is_vectorised():
    return not mi.variant().startswith("scalar")


def is_polarized():
    return mi.variant().endswith("polarized")


def interactions(wi, wavelengths=None):
    """Where light that comes from `wi`, n directions in the shading frame, meets a surface: one interaction of a
    vectorised variant, or a list of n of a scalar one. `wavelengths` are in nm, 4 for each direction."""
    if not is_vectorised():
        result = []
        for i, direction in enumerate(np.asarray(wi, np.float32).tolist()):
            si = mi.SurfaceInteraction3f()
            si.wi = direction
            if wavelengths is not None:
                si.wavelengths = np.asarray(wavelengths[i], np.float32)
            result.append(si)
        return result
    import drjit as dr
    si = dr.zeros(mi.SurfaceInteraction3f, len(wi))
    si.wi = mi.Vector3f(np.asarray(wi, np.float32).T)
    if wavelengths is not None:
        si.wavelengths = type(si.wavelengths)(np.asarray(wavelengths, np.float32).T)
    return si


def sampled(bsdf, wi, u, wavelengths=None, mode=None):
    """What `sample` of a BSDF draws for n directions and n × 3 random numbers, in any variant: arrays of n directions, n
    densities, and n weights; these have the shape of the variant's spectrum."""
    context, si = mi.BSDFContext(mode or mi.TransportMode.Radiance), interactions(wi, wavelengths)
    u = np.asarray(u, np.float32)
    if not is_vectorised():
        drawn = [bsdf.sample(context, one, numbers[0], numbers[1:]) for one, numbers in zip(si, u.tolist())]
        return (np.array([np.ravel(sample.wo) for sample, _ in drawn]), np.array([sample.pdf for sample, _ in drawn]),
                np.array([np.array(weight) for _, weight in drawn]))
    import drjit as dr
    sample, weight = bsdf.sample(context, si, mi.Float(u[:, 0]), mi.Point2f(u[:, 1:].T))
    weight = np.moveaxis(np.array(weight), -1, 0)
    return (np.array(sample.wo).T, np.array(dr.full(mi.Float, 0, len(u)) + sample.pdf),
            np.broadcast_to(weight, (len(u), *weight.shape[1:])))
