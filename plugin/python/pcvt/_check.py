"""Proofs of files."""

import os
from ctypes import byref, c_void_p, sizeof

from . import _library, _structs
from ._arguments import period_vectors
from ._calls import set_doubles, text, watched
from ._library import ArgumentError, checked, library
from ._shown import count, one_line

# A longer line of proof is cut at a comma where consoles show it.
_MOST_SHOWN = 100


class CheckResult:
    """The verdict on one or more files, which is true where all of them are proved.

    lines    a tuple with one line a file, which begins with its path: the proved properties with their figures, or
             the first fault. str() of the result has a line end between them
    refuted  a tuple with the paths of the files that are refuted
    """

    def __init__(self, verdicts):
        self.lines = tuple(line for _, _, line in verdicts)
        self.refuted = tuple(path for path, is_proved, _ in verdicts if not is_proved)

    def __bool__(self):
        return not self.refuted

    def __str__(self):
        return "\n".join(self.lines)

    @one_line
    def __repr__(self):
        if len(self.lines) > 1:
            return f"{len(self.lines) - len(self.refuted)} of {count(len(self.lines), 'file')} proved"
        line = self.lines[0]
        if len(line) > _MOST_SHOWN:
            line = line[:_MOST_SHOWN].rpartition(", ")[0] or line[:_MOST_SHOWN]
        return f"{'refuted' if self.refuted else 'proved'}, {line}"


def check(path, *, lattice=None, period=None, tolerance=None, cvt=None, areas=None, inclusions=None, density=None,
          density_range=(0, 0), progress=None, volumes=None):
    """Proves that files are periodic tiles, also those of other programs, only from positions and period vectors, as
    `pcvt check` does. Ctrl-C ends the call soon.

        pcvt.mesh(300).write("tile.obj")
        print(pcvt.check("tile.obj"))                # tile.obj: a periodic tile: 602 vertices, 300 faces, ...
        assert pcvt.check(["tile.obj", "tile.glb"], cvt=1e-5)

    path        the name of a file or of a .foam folder, or a list of names. Files that belong to one, such as
                the .seam.json of an .obj, are found beside it
    lattice, period
                the period vectors of files in the plane that state none, as in mesh(); stated ones must be equal
    tolerance   the sides of a tile of another program agree within this length; None: within 4 ulps of the largest
                coordinate, in the precision of the file
    cvt         prove as well that cells are centroidal Voronoi cells, and triangles Delaunay, within cvt h,
                h = sqrt(area / n), such as 1e-5; None: not examined
    areas       the name of a table, FILE or FILE:COLUMN, with one area a site: power cells have these areas
    inclusions  the name of a file of shapes, which has the form of the text in mesh(): no cell crosses their outlines
    density     of the centroids of cvt: an expression in x, y, u, v, or the name of a .png file; None: uniform
    density_range
                of the image; 0, 0: pcvt chooses
    progress    called with a Progress ten times a second; a true return value cancels
    volumes     the name of a table with one volume a site: cells in space have these volumes, within 1e-9 of the mean
                or of their own (1e-8 and 1e-7 above 20,000 and 200,000 cells), or what rounding changes

    Returns a CheckResult, which is false where a file is refuted: damaged, not a periodic tile, or without a property.
    Raises ArgumentError where a file cannot be opened, names no lattice where none is given, or is of a kind that
    cannot have a property, LimitError, Cancelled, or the exception of progress.
    """
    options = _structs.CheckOptions(struct_size=sizeof(_structs.CheckOptions))
    if lattice is not None or period is not None:
        vectors = period_vectors(lattice, period, None)
        if len(vectors) != 2:
            raise ArgumentError("check takes two period vectors; files in space state theirs, so leave them out")
        set_doubles(options, lattice=vectors.ravel())
    set_doubles(options, density_range=density_range)
    for name, value in (("tolerance", tolerance), ("cvt", cvt)):
        if value is not None:
            if not value > 0:
                raise ArgumentError(f"{name} {value!r} is not above 0; give a positive number, or None")
            setattr(options, name, value)
    for name, value in (("areas", areas), ("volumes", volumes), ("inclusions", inclusions), ("density", density)):
        if value is not None:
            setattr(options, name, text(name, value))
    paths = [path] if isinstance(path, (str, bytes, os.PathLike)) else list(path)
    if not paths:
        raise ArgumentError("no file to check; give one or more")
    return CheckResult([_verdict(name, options, progress) for name in paths])


def _verdict(path, options, progress):
    """The path as text, whether the file is proved, and its line."""
    name = text("path", path)
    proof = c_void_p()
    try:
        status = watched(options, progress, lambda: library.pcvt_check(name, byref(options), byref(proof)))
        checked(status)
        return os.fsdecode(name), status == _library.OK, os.fsdecode(library.pcvt_proof_text(proof))
    finally:
        library.pcvt_free_proof(proof)
