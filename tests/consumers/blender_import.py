"""blender ... --python blender_import.py -- FILE.glb|FILE.obj...

Runs inside Blender: imports each file and checks that
  its faces lie upright and cover the area of the period parallelogram,
  with "Merge Vertices" on, a .glb of one node is one mesh whose boundary edges are those of the tile,
  at each corner u a + v b is the position, so that a picture lies upright on the tile,
  a .glb has one object for each cell or one for all,
  where FILE.csv lists the cells, each object has the area of its cell,
  boundary edges of one mesh cover the walls that the file states,
  of three dimensions, each cell or the sides of the boundary together close, and the volumes sum to that of the domain.
"""

import csv
import json
import re
import struct
import sys
from collections import Counter
from pathlib import Path

import bmesh
import bpy
import numpy as np

SINGLE = 2e-6
# The tolerance of the areas of cells from positions in single precision.
SAME_AREA = 1e-5


def require(holds, complaint):
    if not holds:
        raise AssertionError(complaint)


def read_glb(path):
    """Returns extras.periodic, and the corners of the triangles of all primitives."""
    data = path.read_bytes()
    size = struct.unpack_from("<I", data, 12)[0]
    root, binary = json.loads(data[20:20 + size]), data[28 + size:]
    indices = []
    for mesh in root["meshes"]:
        for primitive in mesh["primitives"]:
            if primitive.get("mode", 4) != 4:
                continue
            accessor = root["accessors"][primitive["indices"]]
            view = root["bufferViews"][accessor["bufferView"]]
            at = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
            kind = {5123: "<u2", 5125: "<u4"}[accessor["componentType"]]
            indices.append(np.frombuffer(binary, kind, accessor["count"], at).astype(int))
    return root["nodes"][0]["extras"]["periodic"], np.concatenate(indices)


def n_boundary_edges(faces):
    uses = Counter(frozenset(edge) for face in faces
                   for edge in zip(face, face[1:] + face[:1]))
    return sum(n == 1 for n in uses.values())


def read_obj(path):
    """Returns the lattice, whether sides across x and y are walls, and the faces as lists of vertices."""
    lines = [line.split() for line in path.read_text(encoding="ascii").splitlines()]
    lattice = next(line[3:] for line in lines if line[:3] == ["#", "pcvt", "lattice"])
    walls = next((line[3:] for line in lines if line[:3] == ["#", "pcvt", "walls"]), [0, 0])
    faces = [[int(word.split("/")[0]) - 1 for word in line[1:]] for line in lines
             if line and line[0] == "f"]
    return np.array(lattice, float).reshape(2, 2), [int(word) for word in walls], faces


def load(path):
    """Imports a file into an empty scene; returns its meshes of faces."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    if path.suffix == ".obj":
        bpy.ops.wm.obj_import(filepath=str(path))
    else:
        # Other shadings fail in Debian 12, whose numpy has no numpy.bool.
        bpy.ops.import_scene.gltf(filepath=str(path), merge_vertices=True, import_shading="FLAT")
    return [item for item in bpy.data.objects if item.type == "MESH" and item.data.polygons]


def require_texture(item, lattice):
    """Returns the area of the faces."""
    mesh = item.data
    points = np.array([item.matrix_world @ vertex.co for vertex in mesh.vertices])
    require(np.abs(points[:, 1]).max() < SINGLE, "the tile does not lie in the upright plane")
    plane = points[:, [0, 2]]
    require(len(mesh.uv_layers) == 1, f"{len(mesh.uv_layers)} UV maps")
    uv = np.array([corner.uv for corner in mesh.uv_layers[0].data])
    vertex = np.array([corner.vertex_index for corner in mesh.loops])
    off = np.abs(uv @ lattice - plane[vertex]).max()
    require(off < SINGLE * np.abs(lattice).max(), f"a texture coordinate is off by {off}")
    return sum(polygon.area for polygon in mesh.polygons)


def check_areas(path, items, areas):
    """Returns how well the areas of the objects agree with those of the table of cells, in words."""
    table = path.with_suffix(".csv")
    if not table.exists():
        return ""
    with open(table, encoding="utf-8") as lines:
        rows = csv.DictReader(line for line in lines if not line.startswith("#"))
        wanted = {int(row["site"]): float(row["area"]) for row in rows}
    found = {int(re.search(r"cell_(\d+)", item.name)[1]): area for item, area in zip(items, areas)}
    require(found.keys() == wanted.keys(), "the objects are not the cells of the table")
    error = max(abs(found[site] / area - 1) for site, area in wanted.items())
    require(error < SAME_AREA, f"the area of a cell is off by {error:.1e}")
    return f", areas within {error:.1e}"


def require_walls(item, lattice, walls):
    """The boundary edges on each wall have its length together."""
    points = np.array([item.matrix_world @ vertex.co for vertex in item.data.vertices])[:, [0, 2]]
    edges = Counter(edge for polygon in item.data.polygons for edge in polygon.edge_keys)
    ends = np.array([edge for edge, n in edges.items() if n == 1])
    for axis in (axis for axis in (0, 1) if walls[axis]):
        for line in (0, lattice[axis, axis]):
            on_wall = (np.abs(points[ends, axis] - line) < SINGLE).all(axis=1)
            along = points[ends[on_wall], 1 - axis]
            found, wanted = np.abs(along[:, 1] - along[:, 0]).sum(), lattice[1 - axis, 1 - axis]
            require(abs(found - wanted) < 1e-5, f"edges of {found} in place of {wanted} lie on a wall")


def check_solids(path, items, periodic):
    """Proves the surfaces of polyhedra."""
    lattice = np.array(periodic["lattice"])
    whole = abs(np.linalg.det(lattice))
    is_boundary = periodic["kind"] == "boundary"
    require(is_boundary or len(items) == len(periodic["sites"]), f"{len(items)} objects")
    groups = [items] if is_boundary else [[item] for item in items]
    volume = 0
    for group in groups:
        solid = bmesh.new()
        for item in group:
            solid.from_mesh(item.data)
        bmesh.ops.remove_doubles(solid, verts=solid.verts, dist=SINGLE * whole ** (1 / 3))
        require(all(edge.is_manifold for edge in solid.edges), f"{group[0].name} does not close")
        part = solid.calc_volume(signed=True)
        require(part > 0, f"{group[0].name} has the volume {part}")
        volume += part
        solid.free()
    require(abs(volume / whole - 1) < 1e-5, f"the volume is {volume} in place of {whole}")
    print(f"{path}: {len(items)} objects, closed, volume {volume:.7g}")


def check(path):
    items = load(path)
    if path.suffix == ".glb" and "kind" in (periodic := read_glb(path)[0]) and len(periodic["lattice"]) == 3:
        check_solids(path, items, periodic)
        return
    if path.suffix == ".obj":
        lattice, walls, faces = read_obj(path)
        expected = 1
    else:
        periodic, corners = read_glb(path)
        lattice, walls = np.array(periodic["lattice"]), periodic.get("walls", [0, 0])
        faces = corners.reshape(-1, 3).tolist()
        expected = sum("cell_" in item.name for item in bpy.data.objects) or 1
    require(len(items) == expected, f"{len(items)} objects in place of {expected}")
    areas = [require_texture(item, lattice) for item in items]
    area = sum(areas)
    require(abs(area - abs(np.linalg.det(lattice))) < 1e-5 * area, f"the area is {area}")
    if expected > 1:
        print(f"{path}: {expected} objects{check_areas(path, items, areas)}")
        return
    found = n_boundary_edges([list(polygon.vertices) for polygon in items[0].data.polygons])
    wanted = n_boundary_edges(faces)
    require(found == wanted, f"{found} boundary edges in place of {wanted}")
    require_walls(items[0], lattice, walls)
    print(f"{path}: one object, {len(items[0].data.polygons)} faces, {found} boundary edges")


for name in sys.argv[sys.argv.index("--") + 1:]:
    try:
        check(Path(name))
    except AssertionError as fault:
        raise AssertionError(f"{name}: {fault}") from fault
