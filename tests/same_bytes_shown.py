"""What the Python scripts of tests/same_bytes print: all that a caller of the package sees.

    from same_bytes_shown import *
    show_space(pcvt.space(8))
    refused(pcvt.space, 0)              # the classes and the message of an exception

The names of the attributes are those of the documented interface, so that further ones do not count.
"""

import inspect

import numpy as np
import pcvt

CUBE = np.eye(3)
OBLIQUE = np.array([[1, 0], [0.37, 0.81]])
OBLIQUE3 = np.array([[1, 0, 0], [0.37, 0.81, 0], [0.2, 0.4, 0.9]])

STATISTICS = ("energy energy_bound residual rms_residual valences n_hexagons stop n_sites iterations evaluations "
              "n_threads n_mirrors area_error newton_steps").split()
RESULT = "lattice sites weights phases phase_names inclusions orbits orientations minimum cells".split()
MESH = "kind lattice vertices face_begin corner_vertex corner_offset opposite site site_points".split()
TILE = ("kind outline lattice points face_begin corners face_site site_points vertex_site vertex_orbit vertex_offset "
        "seam wall_edges holes").split()
SPACE_TILE = ("lattice points point_orbit point_offset face_begin face_points n_inner_faces owner neighbour partner "
              "partner_offset volumes site_points").split()
PROGRESS = "iteration evaluations energy energy_bound residual rms_residual phase phase_text".split()


def show(name, value):
    """Prints one value, an array with its type, shape and access."""
    if isinstance(value, np.ndarray):
        access = "writeable" if value.flags.writeable else "read-only"
        print(name, value.dtype, value.shape, access)
        for row in value.tolist():
            print("   ", repr(row))
    elif isinstance(value, (tuple, list)):
        print(name, type(value).__name__, len(value))
        for entry in value:
            show("  ", entry)
    else:
        print(name, repr(value))


def show_all(title, owner, names):
    print(f"{title}: {type(owner).__name__}")
    for name in names:
        show(name, getattr(owner, name))


def show_result(result, kinds=("voronoi", "delaunay", "grains"), outlines=("whole", "box")):
    """All views of a result in the plane."""
    show_all("result", result, RESULT)
    show_all("statistics", result.statistics, STATISTICS)
    for kind in kinds:
        if kind != "grains":
            show_all(f"mesh {kind}", result.mesh(kind), MESH)
        for outline in outlines:
            if (kind, outline) != ("delaunay", "box"):
                show_all(f"tile {kind} {outline}", result.tile(kind, outline), TILE)
    show("polygons", result.tile(kinds[0]).polygons())


def show_space(result):
    """All views of a result in space."""
    show_all("result", result, ["sites", "minimum"])
    show_all("statistics", result.statistics, STATISTICS)
    show_all("tile", result.tile(), SPACE_TILE)
    show("polygons", result.tile().polygons())


def refused(call, *arguments, **options):
    """Prints the classes and the message of the exception that a call raises, or what it returns."""
    try:
        print("not refused:", type(call(*arguments, **options)).__name__)
    except Exception as error:
        print(", ".join(kind.__name__ for kind in type(error).__mro__ if kind is not object), "|", error)


def show_signature(call):
    """Prints each parameter with its kind and default."""
    print(call.__qualname__)
    for parameter in inspect.signature(call).parameters.values():
        print("   ", parameter.kind.name, parameter)


class Watch:
    """A progress function that prints each iteration and phase the first time; cancels at `last`."""

    def __init__(self, last=None):
        self.seen, self.last = [], last

    def __call__(self, progress):
        key = progress.phase, progress.iteration
        if key in self.seen or progress.phase == "start":  # Those are a matter of time.
            return False
        self.seen.append(key)
        print("progress", *(repr(getattr(progress, name)) for name in PROGRESS))
        return len(self.seen) == self.last
