"""From a result of pcvt to a mesh of Blender with materials, seam and attributes."""

from importlib import import_module

import bpy
import numpy as np

from . import colours

_NAME = "Periodic CVT Tile"


def _site_of_faces(tile):
    """The site of each face. A Delaunay triangle lies in three cells: its site is that of the corner
    nearest to its centroid."""
    if tile.face_site is not None:
        return tile.face_site
    triangles = tile.corners.reshape(-1, 3)
    corners = tile.points[triangles]
    way = np.linalg.norm(corners - corners.mean(axis=1, keepdims=True), axis=2)
    nearest = way.argmin(axis=1)
    return tile.vertex_site[triangles[np.arange(len(triangles)), nearest]]


def _linear(colour):
    """"#rrggbb" as Blender's r, g, b, alpha: linear light, by the curve of IEC 61966-2-1."""
    encoded = [int(colour[k:k + 2], 16) / 255 for k in (1, 3, 5)]
    return [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in encoded] + [1]


def _material(name, colour):
    """The material of that name. Keeps an existing one, with the changes of the user."""
    found = bpy.data.materials.get(name)
    if found is not None:
        return found
    made = bpy.data.materials.new(name)
    made.diffuse_color = _linear(colour)
    made.use_nodes = True
    for node in made.node_tree.nodes:
        if node.type == "BSDF_PRINCIPLED":
            node.inputs["Base Color"].default_value = _linear(colour)
    return made


def _named_colours(result, scheme):
    """The index of each site's material, and the names and colours of all materials."""
    cells = result.mesh("voronoi")
    if scheme == "cells":
        names = [f"Tile Cell {k + 1}" for k in range(colours.N_COLOURS)]
        return colours.colours_of_sites(cells), list(zip(names, colours.CELLS))
    palette = import_module("._palette", type(result).__module__).SIDES
    names = ["Tile 3 Sides or Fewer", *(f"Tile {k} Sides" for k in range(4, 9)),
             "Tile 9 Sides or More"]
    return np.clip(colours.sides_of_sites(cells), 3, 9) - 3, list(zip(names, palette))


def _set_materials(mesh, result, site_of_face, scheme):
    if scheme == "none":
        return
    number, materials = _named_colours(result, scheme)
    used, slot = np.unique(number[site_of_face], return_inverse=True)
    for k in used:
        mesh.materials.append(_material(*materials[k]))
    mesh.polygons.foreach_set("material_index", slot.astype(np.int32))


def _add_integers(mesh, name, domain, values):
    attribute = mesh.attributes.new(name, "INT", domain)
    attribute.data.foreach_set("value", np.ascontiguousarray(values, dtype=np.int32))


def _mark_seam(mesh, seam):
    """Marks boundary edges as seams. The edges of pair k get the number k, all other edges -1."""
    ends = np.empty(2 * len(mesh.edges), np.int32)
    mesh.edges.foreach_get("vertices", ends)
    edges = {edge: e for e, edge in enumerate(map(frozenset, ends.reshape(-1, 2).tolist()))}
    pair = np.full(len(edges), -1)
    for k, (v0, v1, w0, w1, *_) in enumerate(seam.tolist()):
        pair[edges[frozenset((v0, v1))]] = pair[edges[frozenset((w0, w1))]] = k
    mesh.edges.foreach_set("use_seam", pair >= 0)
    _add_integers(mesh, "seam_pair", "EDGE", pair)


def _set_uv(mesh, tile):
    """Sets coordinates along the periods as UV: a repeating image fits the tile seamlessly."""
    uv = (tile.points @ np.linalg.inv(tile.lattice))[tile.corners]
    mesh.uv_layers.new(name="UVMap").data.foreach_set("uv", uv.astype(np.float32).ravel())


def make_mesh(result, kind, outline, scheme):
    """A mesh of the tile in the plane z = 0, its normals upwards; vertices and faces in the order
    of `result.tile(kind, outline)`. Blender rounds positions to float32.

    It has the attributes `site` of faces, `seam_pair` of edges, `orbit`, `offset_i` and `offset_j`
    of vertices (as Tile says), its boundary marked as a seam, coordinates along the periods as UV,
    and the period vectors as the property `lattice`, ax, ay, bx, by.

    scheme  "cells": seven materials, so that neighbours differ; "sides": materials by the number of
            sides of the cell; "none"
    """
    tile = result.tile(kind, outline)
    mesh = bpy.data.meshes.new(_NAME)
    points = np.column_stack([tile.points, np.zeros(len(tile.points))])
    faces = np.split(tile.corners, tile.face_begin[1:-1])
    mesh.from_pydata(points.tolist(), [], [face.tolist() for face in faces])
    mesh["lattice"] = tile.lattice.ravel().tolist()
    site = _site_of_faces(tile)
    _add_integers(mesh, "site", "FACE", site)
    _add_integers(mesh, "orbit", "POINT", tile.vertex_orbit)
    _add_integers(mesh, "offset_i", "POINT", tile.vertex_offset[:, 0])
    _add_integers(mesh, "offset_j", "POINT", tile.vertex_offset[:, 1])
    _mark_seam(mesh, tile.seam)
    _set_uv(mesh, tile)
    _set_materials(mesh, result, site, scheme)
    return mesh
