"""Studies: many runs, their tables and their pictures."""

import operator
from ctypes import byref, c_void_p, sizeof

import numpy as np

from . import _library, _structs
from ._calls import set_integers, text, watched
from ._library import Handle, checked, library
from ._shown import count, one_line


class StudyResult:
    """The tables and pictures of a study. str() of it is the table that `pcvt study` prints.

    name      of the study
    tables    the tables by the names of their .csv files, {"fig11": ..., "fig11-patterns": ..., "fig11-runs": ...}, the
              main one first, that of the runs last. A table is an array with one entry a row and the columns
              as fields: int64 where all cells are whole numbers, float64 where they are numbers (NaN in cells
              that are empty or "-"), else text
    notes     the lines above each table by its name: the study, the meaning of the columns, the conclusions
    pictures  the texts of the .svg files by their names, the main one first; notebooks show that one
    """

    def __init__(self, handle):
        view = handle.view(library.pcvt_get_study_contents, _structs.StudyContents)
        self._text = view.text.decode()
        self.tables, self.notes, self.pictures = {}, {}, {}
        for k in range(view.n_tables):
            table = handle.view(library.pcvt_get_table, _structs.Table, k)
            name = table.name.decode()
            self.tables[name] = _array(table)
            self.notes[name] = [line.decode() for line in table.notes[:table.n_notes]]
        for k in range(view.n_pictures):
            picture = handle.view(library.pcvt_get_picture, _structs.Picture, k)
            self.pictures[picture.name.decode()] = picture.svg.decode()
        self.name = next(iter(self.tables))

    @property
    def table(self):
        """The main table."""
        return self.tables[self.name]

    @property
    def runs(self):
        """The table of the runs, with the columns n, run, seed and those of the study."""
        return list(self.tables.values())[-1]

    def __str__(self):
        return self._text

    @one_line
    def __repr__(self):
        n_runs = len(np.unique(self.runs[["n", "run"]]))
        return (f"{self.name}, {count(n_runs, 'run')}, {count(len(self.tables), 'table')}, "
                f"{count(len(self.pictures), 'picture')}")

    def _repr_svg_(self):
        return next(iter(self.pictures.values()), None)


def study(name, sites=None, runs=None, seed=None, *, threads=0, path=None, replace=False, progress=None):
    """Makes the runs of a study of the paper, and its tables and pictures, as `pcvt study` does; Ctrl-C ends it soon.

        study = pcvt.study("fig11", sites=[8, 9], runs=100)
        print(study)                                 # the table that the command prints
        study.table["percent"]                       # of the runs with hexagons only, for 8 and 9 sites
        study.runs["energy"][study.runs["n"] == 8].min()
        pcvt.study("fig9", path="results/")          # writes results/fig9.csv, .svg, .html, ...

    name      table1, fig7, fig8, fig9, fig10, fig11, sizes, symmetry, gersho3d or sizes3d
    sites     a list of numbers of sites, or one; None: those of the paper, with which a study takes minutes to hours
    runs      random starts for each number of sites; None: as many as in the paper
    seed      run r starts from the random sites of seed + r; None: that of the paper
    threads   runs at a time; 0: as many as there are cores. fig7, which measures times, has always one
    path      FILE.csv writes the tables, FILE.svg the pictures, FILE.html a page with both, a folder, which exists or
              whose name ends in /, all of them; None: no file. Either all files appear, or none
    replace   whether files that exist are replaced
    progress  called with a Progress ten times a second, whose phase is optimise; a true return value cancels

    Returns a StudyResult. The tables are the same for any number of threads, but for measured times. Raises
    ArgumentError, LimitError (too many sites), OutputError, Cancelled, or the exception of progress.
    """
    options = _structs.StudyOptions()
    checked(library.pcvt_study_options_init(byref(options), sizeof(options), _library.ABI_VERSION,
                                            text("name", name)))
    if sites is not None:
        given = [operator.index(n) for n in np.atleast_1d(sites)]
        numbers = np.array([n if abs(n) < 2**31 else 2**31 - 1 for n in given], np.int32)  # Alive during the call.
        set_integers(options, n_sites=len(numbers))
        options.sites = numbers.ctypes.data
    if runs is not None:
        set_integers(options, runs=runs)
    if seed is not None:
        set_integers(options, seed=seed)
    set_integers(options, n_threads=threads)
    options.replace = bool(replace)
    options.path = None if path is None else text("path", path)
    pointer = c_void_p()
    status = watched(options, progress, lambda: library.pcvt_study(byref(options), byref(pointer)))
    handle = Handle(pointer.value, library.pcvt_free_study) if pointer else None
    checked(status)
    return StudyResult(handle)


def _array(table):
    """A table of pcvt.h as a structured array."""
    n_columns = table.n_columns
    cells = [cell.decode() for cell in table.cells[:table.n_rows * n_columns]]
    columns = [_column(cells[k::n_columns]) for k in range(n_columns)]
    names = [table.columns[k].decode() for k in range(n_columns)]
    array = np.empty(table.n_rows, [(name, column.dtype) for name, column in zip(names, columns)])
    for name, column in zip(names, columns):
        array[name] = column
    return array


def _column(cells):
    """The cells of a column as whole numbers, else as numbers, else as text."""
    for convert, dtype in ((int, np.int64), (lambda cell: np.nan if cell in ("", "-") else float(cell), np.float64)):
        try:
            return np.array([convert(cell) for cell in cells], dtype)
        except (ValueError, OverflowError):
            pass
    return np.array(cells, str)
