"""The operator Add > Mesh > Periodic CVT Tile."""

import bpy
from bpy.props import EnumProperty, FloatProperty, FloatVectorProperty, IntProperty, StringProperty
from bpy_extras.object_utils import AddObjectHelper, object_data_add

from . import words
from .preferences import Missing, load_pcvt


def labelled(choices, **labels):
    """The items of a property: each word with its label and its description, or with itself as both."""
    return [(word, *labels.get(word, (word, word))) for word in choices]


class ShownProgress:
    """The progress function of pcvt as Blender's counter at the mouse: half for the start, if it
    takes long, and the rest for the optimisation."""

    def __init__(self, manager):
        self.manager = manager
        self.first = 0

    def __enter__(self):
        self.manager.progress_begin(0, 1)
        return self

    def __call__(self, state):
        if state.phase == "start":
            self.first = 0.5
            self.manager.progress_update(self.first * state.fraction)
        else:
            self.manager.progress_update(self.first + (1 - self.first) * state.fraction)

    def __exit__(self, *_):
        self.manager.progress_end()


class AddPeriodicTile(bpy.types.Operator, AddObjectHelper):
    """Add a tile of Voronoi cells of equal size, or of the triangles between their centres, that
    repeats without a seam"""

    bl_idname = "mesh.periodic_cvt_tile_add"
    bl_label = "Periodic CVT Tile"
    bl_options = {"REGISTER", "UNDO"}

    sites: IntProperty(name="Sites", default=150, min=1, soft_max=10000, max=1000000,
                       description="Number of cells")
    seed: IntProperty(name="Seed", min=0, description="Another seed, another tile")
    period_a: FloatVectorProperty(name="Period A", size=2, default=(2, 0), unit="LENGTH",
                                  description="The tile repeats when it is moved by this vector")
    period_b: FloatVectorProperty(name="Period B", size=2, default=(0, 2), unit="LENGTH",
                                  description="The tile repeats when it is moved by this vector")
    kind: EnumProperty(name="Faces", items=labelled(
        words.MESH, voronoi=("Cells", "Voronoi cells, most of them hexagons"),
        delaunay=("Triangles", "Delaunay triangles between the centres of the cells"),
        grains=("Meshed Cells", "Cells, each of them filled with small triangles")))
    outline: EnumProperty(name="Outline", items=labelled(
        words.OUTLINE, whole=("Whole Cells", "No cell is cut; triangles never are"),
        box=("Straight", "Cells are cut along the two periods")))
    colours: EnumProperty(name="Materials", items=[
        ("cells", "By Cell", "Seven, so that neighbours differ, also across the seam"),
        ("sides", "By Sides", "One for each number of sides that a cell can have"),
        ("none", "None", "No materials")])
    density: StringProperty(
        name="Density", description="Small cells where it is large: an expression in x, y or, along "
        "the periods, in u, v from 0 to 1, as in 1 + 9*exp(-((v-0.5)/0.1)^2); or the path of a PNG")
    tolerance: FloatProperty(
        name="Tolerance", default=1e-6, min=1e-12, max=1, precision=6,
        description="Largest distance of a site from the centroid of its cell, in mean cell widths")

    @classmethod
    def poll(cls, context):
        cls.poll_message_set("only in Object Mode")
        return context.mode == "OBJECT"

    def draw(self, _):
        self.layout.use_property_split = True
        for name in ("sites", "seed", "period_a", "period_b", "kind"):
            self.layout.prop(self, name)
        row = self.layout.row()
        row.active = self.kind != "delaunay"
        row.prop(self, "outline")
        for name in ("colours", "density", "tolerance", "align", "location", "rotation"):
            self.layout.prop(self, name)

    def execute(self, context):
        try:
            pcvt = load_pcvt()
        except Missing as missing:
            self.report({"ERROR"}, str(missing))
            return {"CANCELLED"}
        from .tile_mesh import make_mesh  # Needs numpy, which load_pcvt() has found.
        try:
            result = self.generate(pcvt, context.window_manager)
            mesh = make_mesh(result, self.kind,
                             "whole" if self.kind == "delaunay" else self.outline, self.colours)
        except pcvt.Error as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        object_data_add(context, mesh, operator=self)
        self.report_end(result.statistics)
        return {"FINISHED"}

    def generate(self, pcvt, manager):
        density = self.density
        if density.startswith("//"):  # Blender's prefix for the folder of its file.
            density = bpy.path.abspath(density)
        with ShownProgress(manager) as progress:
            return pcvt.mesh(self.sites, (self.period_a, self.period_b), density or None,
                             seed=self.seed, tolerance=self.tolerance, progress=progress)

    def report_end(self, figures):
        if figures.stop == "converged":
            self.report({"INFO"}, f"{figures.n_hexagons} of {figures.n_sites} cells are hexagons")
        else:
            self.report({"WARNING"}, f"not converged ({figures.stop}): the residual is "
                        f"{figures.residual:.1e}; take a larger tolerance")
