"""blender ... --python blender_scene.py -- ADD-ON.zip PICTURE.png

Runs inside Blender: installs the add-on, checks the messages about missing parts, adds tiles by the
operator and compares each with the result of pcvt's Python module for the same arguments: vertices
and faces, area, sites, seam, materials. Then renders a tile to the picture and checks its colours.
"""

import contextlib
import sys
from collections import Counter
from types import SimpleNamespace

import bpy
import numpy as np

ADD = bpy.ops.mesh.periodic_cvt_tile_add
OPERATOR = "MESH_OT_periodic_cvt_tile_add"
# Blender's properties store 32-bit numbers; both sides must get the same ones.
OBLIQUE = np.float32([[2, 0], [0.75, 1.5]]).tolist()
SQUARE = [[2, 0], [0, 2]]
TOLERANCE = float(np.float32(1e-6))
SINGLE = 1e-6


def require(holds, complaint):
    if not holds:
        raise AssertionError(complaint)


def read(collection, name, dtype, width=1):
    values = np.empty(width * len(collection), dtype)
    collection.foreach_get(name, values)
    return values.reshape(-1, width) if width > 1 else values


def attribute(mesh, name):
    return read(mesh.attributes[name].data, "value", np.int32)


def install(archive):
    """Installs and enables the add-on as a user does; returns its preferences."""
    bpy.ops.preferences.addon_install(filepath=archive)
    bpy.ops.preferences.addon_enable(module="pcvt_tile")
    return bpy.context.preferences.addons["pcvt_tile"].preferences


def require_refusal(words, **arguments):
    n_objects, n_meshes = len(bpy.data.objects), len(bpy.data.meshes)
    try:
        ADD(**arguments)
    except RuntimeError as error:
        require(all(word in str(error) for word in words), f"the message is {error}")
    else:
        raise AssertionError(f"not refused: {words}")
    require((len(bpy.data.objects), len(bpy.data.meshes)) == (n_objects, n_meshes), "objects remain")


@contextlib.contextmanager
def without(module):
    kept = sys.modules.pop(module, None)
    sys.modules[module] = None
    yield
    sys.modules[module] = kept


def require_plain_words(own, empty_folder):
    """Before pcvt is loaded, the message names the missing part."""
    own.library = "/nowhere/libpcvt.so"
    require_refusal(["cannot load /nowhere/libpcvt.so", "preferences of this add-on"])
    own.library = ""
    own.folder = empty_folder
    require_refusal(["the Python module pcvt is missing", "preferences of this add-on"])
    own.folder = ""
    with without("numpy"):
        require_refusal(["numpy is missing", "python3-numpy"])


def require_same_faces(mesh, tile):
    require(not mesh.validate(), "Blender finds faults in the mesh")
    points = read(mesh.vertices, "co", np.float32, 3)
    require((points[:, :2] == tile.points.astype(np.float32)).all(), "positions differ")
    require((points[:, 2] == 0).all(), "the tile is not flat")
    require((read(mesh.loops, "vertex_index", np.int32) == tile.corners).all(), "corners differ")
    require((read(mesh.polygons, "loop_start", np.int32) == tile.face_begin[:-1]).all(),
            "faces differ")
    require((read(mesh.polygons, "normal", np.float32, 3)[:, 2] > 0.99).all(), "faces are turned")
    wanted = abs(np.linalg.det(tile.lattice))
    area = read(mesh.polygons, "area", np.float32).sum(dtype=float)
    require(abs(area - wanted) < SINGLE * wanted, f"the area is {area}, not {wanted}")
    require((np.array(mesh["lattice"]).reshape(2, 2) == tile.lattice).all(), "the lattice differs")
    for name, values in (("orbit", tile.vertex_orbit), ("offset_i", tile.vertex_offset[:, 0]),
                         ("offset_j", tile.vertex_offset[:, 1])):
        require((attribute(mesh, name) == values).all(), f"{name} differs")


def require_sites(mesh, tile):
    site = attribute(mesh, "site")
    if tile.kind == "delaunay":
        for corners, owner in zip(tile.corners.reshape(-1, 3), site):
            way = np.linalg.norm(tile.points[corners] - tile.points[corners].mean(axis=0), axis=1)
            require(owner in tile.vertex_site[corners[way <= way.min()]], "not the nearest site")
    else:
        require((site == tile.face_site).all(), "sites differ")


def require_seam(mesh, tile):
    """The seam is the boundary, and the two edges of each pair differ by its translation."""
    ends = read(mesh.edges, "vertices", np.int32, 2)
    uses = Counter(edge for polygon in mesh.polygons for edge in polygon.edge_keys)
    boundary = [uses[min(v, w), max(v, w)] == 1 for v, w in ends.tolist()]
    require(read(mesh.edges, "use_seam", bool).tolist() == boundary, "the seam is not the boundary")
    pair = attribute(mesh, "seam_pair")
    require(((pair >= 0) == boundary).all(), "a pair does not lie on the boundary")
    for k, (v0, v1, w0, w1, i, j) in enumerate(tile.seam.tolist()):
        edges = {frozenset(edge) for edge in ends[pair == k].tolist()}
        require(edges == {frozenset((v0, v1)), frozenset((w0, w1))}, f"pair {k} differs")
        way = tile.points[[w0, w1]] - tile.points[[v0, v1]] - np.array([i, j]) @ tile.lattice
        require(np.abs(way).max() < SINGLE, f"pair {k} does not fit")


def require_uv(mesh, tile):
    uv = read(mesh.uv_layers.active.data, "uv", np.float32, 2)
    require(np.abs(uv @ tile.lattice - tile.points[tile.corners]).max() < 4 * SINGLE, "UV differ")


def require_sides(mesh, result):
    """The faces of each material are as many as the cells with its number of sides."""
    wanted = Counter()
    for sides, n in enumerate(result.statistics.valences.tolist()):
        wanted[np.clip(sides, 3, 9)] += n
    found = Counter({int(mesh.materials[k].name.split()[1]): n for k, n in
                     Counter(read(mesh.polygons, "material_index", np.int32).tolist()).items()})
    require(found == +wanted, f"the materials are {found}")


def require_neighbours_differ(mesh, result):
    """Neighbouring cells differ, also across the seam; faces of one cell agree."""
    material = dict(zip(attribute(mesh, "site").tolist(),
                        read(mesh.polygons, "material_index", np.int32).tolist()))
    require(material == dict(zip(reversed(attribute(mesh, "site").tolist()), reversed(
        read(mesh.polygons, "material_index", np.int32).tolist()))), "a cell has two materials")
    require(len(mesh.materials) <= 7, "more than seven materials")
    cells = result.mesh("voronoi")
    cell = np.repeat(cells.site, np.diff(cells.face_begin))
    for one, other in zip(cell.tolist(), cell[cells.opposite].tolist()):
        require(one == other or material[one] != material[other], f"{one} and {other} look alike")


def add(sites, lattice, kind, outline, scheme, **more):
    """Adds a tile by the operator, compares it with the module's and returns the mesh."""
    ADD(sites=sites, period_a=lattice[0], period_b=lattice[1], kind=kind, outline=outline,
        colours=scheme, **more)
    made = bpy.context.active_object
    require(made.name.startswith("Periodic CVT Tile") and made.select_get(), "no object is active")
    pcvt = sys.modules["pcvt_tile.pcvt"]
    result = pcvt.mesh(sites, lattice, more.get("density"), seed=more.get("seed", 0),
                       tolerance=more.get("tolerance", TOLERANCE))
    tile = result.tile(kind, outline)
    for claim in (require_same_faces, require_sites, require_seam, require_uv):
        claim(made.data, tile)
    print(f"{kind}, {outline}: {len(made.data.polygons)} faces, {len(tile.seam)} pairs, "
          f"{len(made.data.materials)} materials")
    return made.data, result


def require_tiles():
    for sites in (1, 2, 7, 150):
        require_sides(*add(sites, OBLIQUE, "voronoi", "whole", "sides", seed=5))
    for sites in (3, 7, 150):
        require_neighbours_differ(*add(sites, SQUARE, "voronoi", "box", "cells"))
    require_neighbours_differ(*add(30, OBLIQUE, "grains", "box", "cells"))
    add(60, OBLIQUE, "delaunay", "whole", "sides")
    add(40, SQUARE, "voronoi", "whole", "sides", density="1 + 9*exp(-((v-0.5)/0.2)^2)",
        tolerance=2**-10)
    mesh, _ = add(20, SQUARE, "voronoi", "whole", "none")
    require(not mesh.materials, "there are materials")
    require(len(bpy.data.materials) <= 15, "materials are not shared")
    require_refusal(["character 4"], density="x +")
    require_refusal(["parallel"], period_a=(1, 0), period_b=(2, 0))


def require_progress():
    """The counter at the mouse rises from 0 to 1."""
    shown = []
    manager = SimpleNamespace(progress_begin=lambda *range_: shown.append(range_),
                              progress_update=shown.append, progress_end=lambda: shown.append("end"))
    with sys.modules["pcvt_tile.add_tile"].ShownProgress(manager) as progress:
        sys.modules["pcvt_tile.pcvt"].mesh(100, tolerance=TOLERANCE, progress=progress)
    steps = shown[1:-1]
    require((shown[0], shown[-1]) == ((0, 1), "end"), f"the counter shows {shown}")
    require(steps == sorted(steps) and steps[0] == 0 and steps[-1] == 1 and len(set(steps)) > 10,
            f"the counter shows {steps}")


def look_from_above(centre, width):
    """Sets up an even light and a camera that sees a square of side `width`."""
    scene = bpy.context.scene
    camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    camera.data.type, camera.data.ortho_scale = "ORTHO", width
    camera.location = (*centre, 5)
    scene.collection.objects.link(camera)
    scene.camera = camera
    scene.world.node_tree.nodes["Background"].inputs["Color"].default_value = (1, 1, 1, 1)
    scene.render.engine = "CYCLES"
    scene.cycles.samples = 8
    scene.cycles.use_denoising = False
    scene.view_settings.view_transform = "Standard"
    scene.render.resolution_x = scene.render.resolution_y = 400
    scene.render.resolution_percentage = 100


def render(picture):
    """Renders the scene and returns the linear colours of the pixels, (n, 3)."""
    bpy.context.scene.render.filepath = picture
    bpy.ops.render.render(write_still=True)
    image = bpy.data.images.load(picture)
    image.colorspace_settings.name = "sRGB"
    pixels = np.empty(4 * image.size[0] * image.size[1], np.float32)
    image.pixels.foreach_get(pixels)
    shown = pixels.reshape(-1, 4)[:, :3]
    return np.where(shown <= 0.04045, shown / 12.92, ((shown + 0.055) / 1.055) ** 2.4)


def require_picture(picture):
    """A rectangular tile fills the picture: each material covers the fraction of its faces."""
    for made in list(bpy.data.objects):
        bpy.data.objects.remove(made)
    mesh, _ = add(40, SQUARE, "voronoi", "box", "cells", seed=3)
    corners = read(mesh.vertices, "co", np.float32, 3)[:, :2]
    look_from_above((corners.min(axis=0) + corners.max(axis=0)) / 2, 2)
    pixels = render(picture)
    colours = np.array([material.diffuse_color[:3] for material in mesh.materials])
    nearest = np.linalg.norm(pixels[:, None] - colours, axis=2).argmin(axis=1)
    found = np.bincount(nearest, minlength=len(colours)) / len(pixels)
    area = np.bincount(read(mesh.polygons, "material_index", np.int32),
                       read(mesh.polygons, "area", np.float32)) / 4
    print("shares of the materials", np.round(area, 3), "in the picture", np.round(found, 3))
    require(len(colours) >= 5 and area.min() > 0.01, "too few materials to look at")
    require(np.abs(found - area).max() < 0.03, "the picture does not show the tile")


def main(archive, picture):
    own = install(archive)
    require_plain_words(own, str(picture).rpartition("/")[0])
    require_tiles()
    require_progress()
    require_picture(picture)
    require(hasattr(bpy.types, OPERATOR), "there is no operator")
    bpy.ops.preferences.addon_disable(module="pcvt_tile")
    require(not hasattr(bpy.types, OPERATOR), "the operator remains")


main(*sys.argv[sys.argv.index("--") + 1:])
