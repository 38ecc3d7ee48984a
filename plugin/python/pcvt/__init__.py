"""Periodic centroidal Voronoi tessellations as numpy arrays, by the C interface of pcvt.

    import pcvt
    result = pcvt.mesh(sites=300, lattice=((1, 0), (0.37, 0.81)), seed=7)
    tile = result.tile()                         # cells; result.tile("delaunay"): triangles
    seam = tile.seam                             # pairs of boundary edges v0 -> v1, w0 -> w1
    move = np.column_stack([seam["i"], seam["j"]]) @ tile.lattice
    np.allclose(tile.points[seam["w0"]], tile.points[seam["v0"]] + move)    # True
    result.write("tile.glb")
    result.plot()                                # needs matplotlib
    pcvt.pattern(56).write("pattern.svg")        # the best exact lattice: all cells are alike

With three periods the cells are polyhedra:

    result = pcvt.mesh(sites=100, period=(1, 1, 1))
    tile = result.tile()                         # points, faces, owner, neighbour, partners
    result.write("tile.vtu")

Files are proved, and the studies of the paper are made, as by the command:

    assert pcvt.check("tile.glb")                # false where a file is refuted; print() shows the verdict
    pcvt.study("fig11", sites=[8, 9], runs=100).table["percent"]

The environment variable PCVT_LIBRARY names libpcvt.so. Without it the package looks for
libpcvt.so.0.3 in its own folder, in the folder above, in the `lib` that it is installed in, and then
where the system's loader finds libraries.

Arrays are read-only views of the library's memory, without a copy. Each array keeps that memory
alive. Use array.copy() to change one. Arguments that are float64 arrays in C order are read in
place. Numbers are float64 and int32, positions in length units; sites, vertices and faces are
numbered from 0, sites in the order of the input. An offset i, j means the translation i a + j b,
with a, b the rows of `lattice`; an offset i, j, k means i a + j b + k c.
"""

try:
    import numpy
except ModuleNotFoundError as missing:
    raise ModuleNotFoundError("pcvt needs numpy; install it: pip install numpy, or on Debian "
                              "python3-numpy", name=missing.name) from None

from ._callbacks import Progress
from ._check import CheckResult, check
from ._library import (ArgumentError, Cancelled, DensityError, Error, GeometryError, LimitError, OutputError,
                       library)
from ._mesh import mesh, pattern, space
from ._result import Result
from ._space import SpaceResult, SpaceTile
from ._study import StudyResult, study
from ._views import Statistics, Tile, TorusMesh

__all__ = ["mesh", "pattern", "space", "check", "study", "version", "Result", "Tile", "TorusMesh", "SpaceResult",
           "SpaceTile", "CheckResult", "StudyResult", "Statistics", "Progress", "Error", "Cancelled", "ArgumentError", "DensityError", "GeometryError",
           "LimitError", "OutputError"]


def version():
    """"major.minor.patch" of the library."""
    return library.pcvt_version().decode()


def __dir__():
    return sorted([*__all__, "__version__"])


__version__ = version()

for _name in __all__:  # Messages show the public name.
    globals()[_name].__module__ = __name__
