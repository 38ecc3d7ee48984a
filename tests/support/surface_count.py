"""Counts the surfaces of cells, or of a whole tile in space, in an .obj, a .ply or a .glb again, from only points and faces.

read(path) gives polyhedra with the cell of each, or the one boundary of a tile; counted(path) raises space_count.Fault unless
each closes, the volumes are positive and sum to det L, and, where points are doubles, the faces of the boundary are paired by
lattice translations, and V - E + F - T = 0 where these are glued.
"""

import json
import re
import struct

import numpy as np

from support.space_count import Polyhedra, area_vector, count_of_polyhedra, glued, require, require_sum, volume_of_fan, with_elements

# Positions in .glb have 24 bits.
ROUNDED = 2e-5


def of_obj(path):
    text = path.read_text()
    points = np.array(re.findall(r"^v (\S+) (\S+) (\S+)", text, re.M), float)
    cells, owners = [], []
    for group in re.split(r"^g ", text, flags=re.M)[1:]:
        name = group.split("\n", 1)[0]
        found = re.fullmatch(r"cell_(\d+)(_\d+)?", name)
        owners.append(int(found[1]) if found else -1)
        cells.append([[int(word.split("/")[0]) - 1 for word in row.split()] for row in re.findall(r"^f (.*)", group, re.M)])
    return surfaces(points, cells, owners, text)


def of_ply(path):
    text = path.read_text()
    head, _, rows = text.partition("end_header\n")
    n_points, n_faces = (int(re.search(rf"element {name} (\d+)", head)[1]) for name in ("vertex", "face"))
    rows = rows.split("\n")
    points = np.array([row.split()[:3] for row in rows[:n_points]], float)
    sites = np.array([row.split() for row in rows[n_points + n_faces:] if row], float)
    cells, owners = {}, []
    for row in rows[n_points:n_points + n_faces]:
        numbers = list(map(int, row.split()))
        # Behind the corners are three colours and the piece, whose site is the image in its cell.
        cells.setdefault(numbers[1 + numbers[0] + 3], []).append(numbers[1:1 + numbers[0]])
    mesh = surfaces(points, list(cells.values()), [0] * len(cells), head)
    mesh.sites = sites[list(cells)]
    return mesh


def surfaces(points, cells, owners, text):
    lattice = np.array(re.search(r"pcvt lattice (.*)", text)[1].split(), float).reshape(3, 3)
    if "pcvt kind boundary" in text:
        cells, owners = [[face for cell in cells for face in cell]], [-1]
    mesh = Polyhedra(points, cells, lattice)
    mesh.owners = np.array(owners)
    return with_elements(mesh)


def of_glb(path):
    """The triangles of each node, whose corners are one point where their positions are equal."""
    data = path.read_bytes()
    n = struct.unpack("<I", data[12:16])[0]
    tree, binary = json.loads(data[20:20 + n]), data[28 + n:]

    def array(number, kind, width):
        accessor = tree["accessors"][number]
        view = tree["bufferViews"][accessor["bufferView"]]
        start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        return np.frombuffer(binary, kind, accessor["count"] * width, start).reshape(-1, width)

    points, cells, owners, n_points = [], [], [], 0
    for node in tree["nodes"]:
        if "mesh" not in node:
            continue
        triangles = []
        for primitive in tree["meshes"][node["mesh"]]["primitives"]:
            kind = {5123: "<u2", 5125: "<u4"}[tree["accessors"][primitive["indices"]]["componentType"]]
            corners = array(primitive["indices"], kind, 1).reshape(-1, 3).astype(int) + n_points
            points.append(array(primitive["attributes"]["POSITION"], "<f4", 3).astype(float))
            n_points += len(points[-1])
            triangles += corners.tolist()
        found = re.fullmatch(r"cell_(\d+)(_\d+)?", node.get("name", ""))
        owners.append(int(found[1]) if found else -1)
        cells.append(triangles)
    unique, which = np.unique(np.concatenate(points), axis=0, return_inverse=True)
    which = which.reshape(-1)
    cells = [which[np.array(cell)].tolist() for cell in cells]
    found = next(node["extras"]["periodic"] for node in tree["nodes"] if "periodic" in node.get("extras", {}))
    lattice = np.array(found["lattice"], float).reshape(3, 3)
    if found["kind"] == "boundary":
        cells, owners = [[face for cell in cells for face in cell]], [-1]
    mesh = Polyhedra(unique, cells, lattice)
    mesh.owners, mesh.is_rounded = np.array(owners), True
    return mesh


READERS = {".obj": of_obj, ".ply": of_ply, ".glb": of_glb}


def read(path):
    return READERS[path.suffix](path)


def count_of(mesh):
    if not getattr(mesh, "is_rounded", False) and mesh.owners[0] >= 0:
        return count_of_polyhedra(mesh)
    for cell in mesh.cells:
        edges = np.array([edge for face in cell for edge in zip(face, face[1:] + face[:1]) if edge[0] != edge[1]])
        _, which = np.unique(np.sort(edges, axis=1), axis=0, return_inverse=True)
        sums = np.bincount(which.reshape(-1), np.where(edges[:, 0] < edges[:, 1], 1, -1))
        require(sums == 0, "a surface does not close")
    mesh.volumes = np.array([sum(volume_of_fan(mesh.points[face] - mesh.points[cell[0][0]]) for face in cell)
                             for cell in mesh.cells])
    require(mesh.volumes > 0, "a surface has no positive volume")
    if getattr(mesh, "is_rounded", False):
        require_sum(mesh.volumes, mesh.lattice, ROUNDED)
    else:
        require_sum(mesh.volumes, mesh.lattice)
        areas = np.array([area_vector(mesh.points[face]) for face in mesh.cells[0]])
        require(abs(areas.sum(axis=0)).max() < 1e-10 * abs(areas).sum(), "the boundary does not close")
        glued(mesh, mesh.cells[0], {})
    return (sum(map(len, mesh.cells)),)


def counted(path):
    return count_of(read(path))
