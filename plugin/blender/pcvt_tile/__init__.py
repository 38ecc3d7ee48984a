"""Periodic CVT Tile: adds seamless tiles of Voronoi cells to Blender (Add > Mesh).

The Python module pcvt does the work. The add-on contains it, or finds it as in preferences.py.
"""

import bpy

from .add_tile import AddPeriodicTile
from .preferences import Preferences

bl_info = {
    "name": "Periodic CVT Tile",
    "author": "the authors of pcvt",
    "version": (0, 1, 0),
    "blender": (3, 4, 0),
    "location": "View3D > Add > Mesh",
    "description": "Seamless tiles of centroidal Voronoi cells or Delaunay triangles",
    "category": "Add Mesh",
}

_CLASSES = (Preferences, AddPeriodicTile)


def _add_to_menu(menu, _):
    menu.layout.operator(AddPeriodicTile.bl_idname, icon="MESH_GRID")


def register():
    for kind in _CLASSES:
        bpy.utils.register_class(kind)
    bpy.types.VIEW3D_MT_mesh_add.append(_add_to_menu)


def unregister():
    bpy.types.VIEW3D_MT_mesh_add.remove(_add_to_menu)
    for kind in reversed(_CLASSES):
        bpy.utils.unregister_class(kind)
