"""libpcvt: its functions, its errors, its memory."""

import ctypes
import os
import weakref
from ctypes import POINTER, byref, c_char_p, c_int32, c_size_t, c_uint32, c_void_p, sizeof
from pathlib import Path

import numpy as np

from ._structs import (Cells, CheckOptions, Inclusions, Mesh, Options, Picture, Sites, Statistics, StudyContents,
                       StudyOptions, Table, Tile, WriteOptions)

ABI_VERSION = 0x00000003


class Error(Exception):
    """An error of the library, with its message."""


class Cancelled(Error):
    """The progress function cancelled the run."""


class ArgumentError(Error, ValueError):
    """A value that is out of range or not finite, or an unknown or unavailable choice."""


class DensityError(Error, ValueError):
    """A density that is not finite and positive."""


class GeometryError(Error, ValueError):
    """Coincident sites, or sites whose cells are too small."""


class LimitError(Error, MemoryError):
    """Out of memory, or a limit of pcvt."""


class OutputError(Error, OSError):
    """A file exists or could not be written."""


OK, _CANCELLED = 0, 1
_ERRORS = {_CANCELLED: Cancelled, -1: ArgumentError, -3: DensityError, -4: LimitError,
           -5: GeometryError, -6: OutputError}


_FUNCTIONS = {
    "pcvt_version": (c_char_p,),
    "pcvt_last_error": (c_char_p,),
    "pcvt_options_init": (c_int32, POINTER(Options), c_size_t, c_uint32),
    "pcvt_generate": (c_int32, POINTER(Options), POINTER(c_void_p)),
    "pcvt_free": (None, c_void_p),
    "pcvt_get_sites": (c_int32, c_void_p, POINTER(Sites), c_size_t),
    "pcvt_get_inclusions": (c_int32, c_void_p, POINTER(Inclusions), c_size_t),
    "pcvt_get_statistics": (c_int32, c_void_p, POINTER(Statistics), c_size_t),
    "pcvt_get_minimum": (c_int32, c_void_p, POINTER(c_int32)),
    "pcvt_get_mesh": (c_int32, c_void_p, c_int32, POINTER(Mesh), c_size_t),
    "pcvt_get_tile": (c_int32, c_void_p, c_int32, c_int32, POINTER(Tile), c_size_t),
    "pcvt_get_cells": (c_int32, c_void_p, POINTER(Cells), c_size_t),
    "pcvt_write": (c_int32, c_void_p, c_char_p, POINTER(WriteOptions)),
    "pcvt_check": (c_int32, c_char_p, POINTER(CheckOptions), POINTER(c_void_p)),
    "pcvt_proof_text": (c_char_p, c_void_p),
    "pcvt_free_proof": (None, c_void_p),
    "pcvt_study_options_init": (c_int32, POINTER(StudyOptions), c_size_t, c_uint32, c_char_p),
    "pcvt_study": (c_int32, POINTER(StudyOptions), POINTER(c_void_p)),
    "pcvt_get_study_contents": (c_int32, c_void_p, POINTER(StudyContents), c_size_t),
    "pcvt_get_table": (c_int32, c_void_p, c_int32, POINTER(Table), c_size_t),
    "pcvt_get_picture": (c_int32, c_void_p, c_int32, POINTER(Picture), c_size_t),
    "pcvt_free_study": (None, c_void_p),
}


def _library_file():
    name = "libpcvt.so.0.3"
    package = Path(__file__).resolve().parent
    # Installed, the package is lib/python3/dist-packages/pcvt.
    near = [folder / name for folder in (package, package.parents[0], package.parents[2])]
    found = [str(file) for file in near if file.exists()]
    return os.environ.get("PCVT_LIBRARY") or (found + [name])[0]


def _load():
    file = _library_file()
    try:
        library = ctypes.CDLL(file)
        for name, (result, *arguments) in _FUNCTIONS.items():
            function = getattr(library, name)
            function.restype, function.argtypes = result, arguments
    except (OSError, AttributeError) as error:
        raise ImportError(f"cannot load {file}: {error}; set PCVT_LIBRARY to the path of "
                          "libpcvt.so") from None
    return library


library = _load()


def checked(status):
    """Raises the error of a status that has no result."""
    if status < 0 or status == _CANCELLED:
        raise _ERRORS.get(status, Error)(os.fsdecode(library.pcvt_last_error()))


class _Borrowed:
    """Memory of a result, valid as long as this object lives; numpy arrays hold a reference to it."""

    def __init__(self, owner, address, n_bytes):
        self.owner = owner
        self.__array_interface__ = {"version": 3, "data": (address, True), "shape": (n_bytes,),
                                    "typestr": "|u1"}


class Handle:
    """A pcvt_result, or with another function that frees it an object of another type, freed with the last array or
    object that refers to it."""

    def __init__(self, pointer, free=None):
        self.pointer = pointer
        self.converged = False
        weakref.finalize(self, free or library.pcvt_free, pointer).atexit = False

    def view(self, get, kind, *choices):
        view = kind()
        checked(get(self.pointer, *choices, byref(view), sizeof(view)))
        return view

    def array(self, address, dtype, *shape):
        """The array of this shape at an address; None for a null pointer."""
        if address is None:
            return None
        n_bytes = np.dtype(dtype).itemsize * int(np.prod(shape))
        return np.asarray(_Borrowed(self, address, n_bytes)).view(dtype).reshape(shape)
