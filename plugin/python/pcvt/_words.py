"""Words of options, by their numbers in pcvt.h. Written by plugin/words."""

# In the plane and in space.
CHOICES = {
    2: {
        "duplicates": {"refuse": 0, "drop": 1},
        "symmetry": {
            "p1": 1, "p2": 2, "pm": 3, "pg": 4, "cm": 5, "pmm": 6, "pmg": 7, "pgg": 8, "cmm": 9, "p4": 10,
            "p4m": 11, "p4g": 12, "p3": 13, "p3m1": 14, "p31m": 15, "p6": 16, "p6m": 17,
        },
        "walls": {"none": 0, "x": 1, "y": 2, "xy": 3},
        "wall_cells": {"whole": 0, "half": 1},
        "start": {"default": 0, "random": 1, "coarse": 2, "lattice": 3, "best": 4},
        "solver": {"default": 0, "lbfgs": 1, "lloyd": 2, "newton": 3},
        "mesh": {"voronoi": 0, "delaunay": 1, "grains": 2},
        "outline": {"whole": 0, "box": 1},
        "colour": {
            "default": 0, "sides": 1, "size": 2, "cells": 3, "density": 4, "phase": 5, "orbit": 6, "tag": 7,
            "orientation": 9,
        },
        "glb_nodes": {"default": 0, "cells": 1, "one": 2},
        "element": {"CPE": 0, "CPS": 1, "C3D6": 2, "C3D15": 3},
        "job": {"none": 0, "elastic": 1},
    },
    3: {
        "duplicates": {"refuse": 0, "drop": 1},
        "start": {"default": 0, "random": 1, "coarse": 2, "lattice": 3},
        "solver": {"default": 0, "lbfgs": 1, "lloyd": 2},
        "mesh": {"voronoi": 0, "delaunay": 1, "grains": 2},
        "outline": {"whole": 0, "box": 1},
        "colour": {"default": 0, "size": 2, "cells": 3, "phase": 5, "faces": 8, "orientation": 9},
        "job": {"none": 0, "elastic": 1},
        "surface": {"cells": 0, "boundary": 1},
    },
}

# Names of options, and of their fields in pcvt.h, that are for the plane only.
PLANE_ONLY = {
    "area_law", "areas", "background", "budget", "coriolis", "cut", "cut_width", "density", "density_data",
    "density_range", "density_source", "element", "fibres", "fixed", "fixed_sites", "float32", "glb_nodes",
    "gltf_nodes", "grain_per_edge", "hole", "holes", "inclusions", "n_areas", "n_fixed_sites", "per_edge", "pixels",
    "retry", "single_precision", "symmetry", "thickness", "wall_cells", "walls",
}

# Fields of pcvt.h that state an option whose value is one number.
NUMBERS = {
    "tolerance", "max_iterations", "grain_size", "grain_per_edge", "short_edges", "pixels", "cut_width",
    "thickness",
}
