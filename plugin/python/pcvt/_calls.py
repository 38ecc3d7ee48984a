"""Arguments of the library, and calls of it that have callbacks."""

import operator
import os
from ctypes import byref, c_void_p, sizeof

import numpy as np

from . import _library, _structs
from ._callbacks import Callbacks
from ._library import ArgumentError, Handle, checked, library
from ._words import CHOICES, NUMBERS


def choice(name, value, option=None, dimension=2):
    """The number in pcvt.h of a word, which an argument has for an option of the command, or of its own name."""
    words = CHOICES[dimension][option or name]
    if value not in list(words):
        raise ArgumentError(f"{name} {value!r} is unknown; take one of {', '.join(words)}")
    return words[value]


def text(name, value):
    encoded = os.fsencode(value)
    if b"\0" in encoded:
        raise ArgumentError(f"{name} {value!r} has a zero byte; leave it out")
    return encoded


def shaped(name, values, *shapes):
    """The values as an array of one of the shapes."""
    array = np.ascontiguousarray(values, dtype=np.float64)
    if array.shape not in shapes:
        raise ArgumentError(f"{name} has the shape {array.shape}; give {' or '.join(map(str, shapes))}")
    return array


def doubles(name, values, *shape):
    return shaped(name, values, shape)


def set_integers(options, **integers):
    for name, value in integers.items():
        setattr(options, name, operator.index(value))
        if getattr(options, name) != value:  # ctypes cuts what does not fit.
            raise ArgumentError(f"{name} {value} is out of range")


def set_doubles(options, **arrays):
    for name, values in arrays.items():
        field = getattr(options, name)
        field[:] = doubles(name, values, len(field)).tolist()


def require_numbers(function, struct, names):
    """Requires that a function got only names of options whose value is one number, by their fields of pcvt.h."""
    for name in names:
        if name not in NUMBERS or not hasattr(struct, name):
            raise TypeError(f"{function}() got an unexpected keyword argument {name!r}")


def set_fields(function, options, fields):
    """Sets fields of pcvt.h that are one number, by their names there."""
    require_numbers(function, options, fields)
    for name, value in fields.items():
        if isinstance(getattr(options, name), float):
            setattr(options, name, value)
        else:
            set_integers(options, **{name: value})


def set_voxels(options, voxels):
    """Sets the numbers of voxels along x and y, and where a third is given along z."""
    columns, rows, *layers = voxels
    options.voxels[:] = operator.index(columns), operator.index(rows)
    set_integers(options, voxel_layers=layers.pop() if layers else 0)


def set_sites(options, sites, dimension):
    """Returns the array that must stay alive as long as the options are used, or None."""
    if np.ndim(sites) == 0:
        set_integers(options, n_sites=sites)
        return None
    points = doubles("sites", sites, len(sites), dimension)
    set_integers(options, n_sites=len(points))
    options.sites = points.ctypes.data
    return points


def set_functions(options, density, callbacks):
    options.progress = _structs.ProgressCallback(callbacks.show_progress)
    if callable(density):
        options.density = _structs.DensityCallback(callbacks.ask_density)
    elif density is not None:
        options.density_source = text("density", density)


def default_options():
    options = _structs.Options()
    checked(library.pcvt_options_init(byref(options), sizeof(options), _library.ABI_VERSION))
    return options


def generated(options, density, progress):
    """Generates a result and returns its handle."""
    pointer = c_void_p()
    with Callbacks(density, progress) as callbacks:
        set_functions(options, density, callbacks)
        status = library.pcvt_generate(byref(options), byref(pointer))
        handle = Handle(pointer.value) if pointer else None
        if callbacks.error is not None:
            raise callbacks.error
        checked(status)
    handle.converged = status == _library.OK
    return handle


def watched(options, progress, call):
    """Calls the library with a function as the progress of options, and returns the status."""
    with Callbacks(None, progress) as callbacks:
        options.progress = _structs.ProgressCallback(callbacks.show_progress)
        status = call()
        if callbacks.error is not None:
            raise callbacks.error
    return status


def written(handle, path, options, progress):
    """Writes the files of a result. `path` may be None."""
    file = None if path is None else text("path", path)
    checked(watched(options, progress, lambda: library.pcvt_write(handle.pointer, file, byref(options))))
