"""Arguments of mesh() that take more than one form, and those that its dimension lacks."""

import inspect
import os

import numpy as np

from ._calls import doubles, set_doubles, set_integers, shaped, text
from ._library import ArgumentError
from ._words import PLANE_ONLY


def period_vectors(lattice, period, symmetry):
    """The two or three period vectors as rows."""
    if period is not None and lattice is not None:
        raise ArgumentError("lattice and period exclude each other; give one of the two")
    if period is not None:
        sides = shaped("period", period, (2,), (3,))
        if not (sides > 0).all():
            raise ArgumentError(f"period {period!r}: a side is not above 0; give "
                                f"{'two' if len(sides) == 2 else 'three'} positive lengths")
        return np.diag(sides)
    if lattice is not None:
        vectors = shaped("lattice", lattice, (2, 2), (3, 3), (4,), (9,))
        return vectors.reshape(2 if vectors.size == 4 else 3, -1)
    is_hexagonal = str(symmetry)[1:2] in ("3", "6")
    return np.array(((1, 0), (0.5, 0.75 ** 0.5)) if is_hexagonal else ((1, 0), (0, 1)))


def refuse_plane_only(function, arguments):
    """Requires that the arguments of a function which are for the plane only have their defaults."""
    defaults = inspect.signature(function).parameters
    names = [name for name, value in arguments.items()
             if name in PLANE_ONLY and not np.array_equal(value, defaults[name].default)]
    if names:
        raise ArgumentError(f"{' and '.join(names)} {'is' if len(names) == 1 else 'are'} not for three dimensions; "
                            f"leave {'it' if len(names) == 1 else 'them'} out, or give two period vectors")


def set_origin(options, origin, dimension):
    """Sets the corner of the domain: (x, y), (x, y, z), or "auto"."""
    options.find_origin = isinstance(origin, str) and origin == "auto"
    if options.find_origin:
        return
    if dimension == 2:
        set_doubles(options, origin=origin)
    # The default is that of the plane.
    elif isinstance(origin, str):
        raise ArgumentError(f"origin {origin!r} is no point; give (x, y, z) or \"auto\"")
    elif not np.array_equal(origin, (0, 0)):
        corner = doubles("origin", origin, 3)
        set_doubles(options, origin=corner[:2])
        options.origin_z = corner[2]


def set_aspect(options, aspect, dimension):
    """Sets the elongation of the cells: R, (R, degrees), or in space (R, (x, y, z))."""
    is_ratio = not isinstance(aspect, (tuple, list)) and np.ndim(aspect) == 0
    ratio, direction = (aspect, None) if is_ratio else aspect
    options.aspect = ratio
    if direction is None:
        return
    if dimension == 2:
        options.aspect_degrees = direction
    else:
        set_doubles(options, aspect_axis=doubles("aspect", direction, 3))


def set_sizes(options, word, sizes):
    """Sets areas or volumes, or their law. Returns the array that must stay alive as long as the options are used."""
    if sizes is None:
        return None
    if isinstance(sizes, str):
        setattr(options, f"{word}_law", text(f"{word}s", sizes))
        return None
    return set_list(options, f"{word}s", sizes)


def set_weights(options, weights):
    """Returns the array that must stay alive as long as the options are used, or None."""
    return None if weights is None else set_list(options, "weights", weights)


def set_list(options, name, values):
    """Sets a field and its number of values. Returns the array that must stay alive."""
    array = doubles(name, values, np.size(values))
    set_integers(options, **{f"n_{name}": len(array)})
    setattr(options, name, array.ctypes.data)
    return array


def set_site_phases(options, phases):
    """Sets the phase of each site from its name. Returns the array that must stay alive."""
    names = list(dict.fromkeys(map(str, phases)))
    indices = np.array([names.index(str(phase)) for phase in phases], dtype=np.int32)
    set_integers(options, n_site_phases=len(indices))
    options.site_phases, options.phases = indices.ctypes.data, text("phases", ",".join(names))
    return indices


def set_materials(options, phases, orientations, weights):
    """Returns the arrays that must stay alive as long as the options are used."""
    if phases is not None:
        if not isinstance(phases, str):
            phases = ",".join(f"{name}:{float(fraction)!r}" for name, fraction in phases.items())
        options.phases = text("phases", phases)
    arrays = []
    if weights is not None:
        if orientations is None or isinstance(orientations, str):
            raise ArgumentError("orientation_weights are those of a list of orientations; give one")
        arrays.append(doubles("orientation_weights", weights, len(orientations)))
        options.orientation_weights = arrays[0].ctypes.data
    if isinstance(orientations, str):
        if orientations != "random":
            raise ArgumentError(f"orientations {orientations!r} is unknown; give random or angles")
        options.random_orientations = 1
    elif orientations is not None:
        arrays.append(doubles("orientations", orientations, len(orientations), 3))
        set_integers(options, n_orientations=len(orientations))
        options.orientations = arrays[-1].ctypes.data
    return arrays


def material_text(materials):
    """Elastic constants as text: {name: numbers}, the path of a file, or text."""
    if isinstance(materials, os.PathLike):
        materials = os.fspath(materials)
    if not isinstance(materials, str):
        materials = " ".join(f"{name}:" + ",".join(repr(float(x)) for x in np.ravel(constants))
                             for name, constants in materials.items())
    return text("materials", materials)


def set_fixed(options, fixed):
    """Returns the array that must stay alive as long as the options are used, or None."""
    if fixed is None:
        return None
    points = doubles("fixed", fixed, len(fixed), 2)
    set_integers(options, n_fixed_sites=len(points))
    options.fixed_sites = points.ctypes.data
    return points


def _shape_line(shape):
    """The line of a shape: (word, tag, numbers...), or (word, tag, array of corners)."""
    word, tag, *numbers = shape
    return f"{word} {tag} " + " ".join(repr(float(x)) for part in numbers for x in np.ravel(part))


def set_inclusions(options, inclusions, fibres, holes):
    if len(holes) > 0:
        options.holes = text("holes", holes if isinstance(holes, str) else ",".join(holes))
    if fibres is not None:
        options.fibres = ",".join(map(repr, fibres)).encode()
    if inclusions is None:
        return
    if not isinstance(inclusions, str):
        inclusions = "\n".join(map(_shape_line, inclusions))
    options.inclusions = text("inclusions", inclusions)
