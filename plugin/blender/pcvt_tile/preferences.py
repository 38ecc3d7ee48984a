"""The preferences of the add-on, and the search for the Python module pcvt."""

import importlib
import os
import sys
from contextlib import contextmanager
from pathlib import Path

import bpy
from bpy.props import StringProperty

_ADVICE = {
    "numpy": "numpy is missing; install it for Blender's Python (Debian: python3-numpy)",
    "pcvt": "the Python module pcvt is missing; name the folder that holds it in the preferences "
            "of this add-on",
}


class Missing(Exception):
    """A missing requirement of pcvt and the remedy, in one line."""


@contextmanager
def _looking_in(folder, library):
    """Makes Python search `folder` first and pcvt load `library`. Empty: no change."""
    library_before, path_before = os.environ.get("PCVT_LIBRARY", ""), list(sys.path)
    os.environ["PCVT_LIBRARY"] = library or library_before
    sys.path[:0] = [folder] if folder else []
    try:
        yield
    finally:
        sys.path[:] = path_before
        os.environ["PCVT_LIBRARY"] = library_before


def _paths():
    """Folder and library of the preferences, which do not exist after `blender --addons`."""
    own = bpy.context.preferences.addons.get(__package__)
    if own is None:
        return "", ""
    return (path and bpy.path.abspath(path) for path in (own.preferences.folder,
                                                         own.preferences.library))


def load_pcvt():
    """Loads the module pcvt from the folder in the preferences, else from this add-on's folder, else
    from Python's path. Raises Missing."""
    folder, library = _paths()
    brought = not folder and (Path(__file__).parent / "pcvt").is_dir()
    try:
        with _looking_in(folder, library):
            return importlib.import_module(f"{__package__}.pcvt" if brought else "pcvt")
    except ModuleNotFoundError as error:
        raise Missing(_ADVICE.get(error.name, str(error))) from None
    except ImportError as error:
        raise Missing(f"{error}, or name it in the preferences of this add-on") from None


class Preferences(bpy.types.AddonPreferences):
    bl_idname = __package__

    folder: StringProperty(
        name="Folder of the module", subtype="DIR_PATH",
        description="Folder that holds the Python package pcvt. Empty: the one in the add-on, or "
                    "the one that Python finds. Read until pcvt is loaded")
    library: StringProperty(
        name="libpcvt", subtype="FILE_PATH",
        description="Path of libpcvt.so. Empty: where the Python package looks for it. Read until "
                    "pcvt is loaded")

    def draw(self, _):
        self.layout.prop(self, "folder")
        self.layout.prop(self, "library")
        try:
            pcvt = load_pcvt()
            self.layout.label(text=f"pcvt {pcvt.version()} in {Path(pcvt.__file__).parent}")
        except Missing as missing:
            self.layout.label(text=str(missing), icon="ERROR")
