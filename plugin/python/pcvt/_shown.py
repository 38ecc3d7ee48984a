"""What consoles and notebooks show of results."""

import functools
import os
import tempfile

# Pictures of more cells or triangles are not shown in notebooks: they take megabytes.
MOST_SHOWN = 20000


def one_line(describe):
    """Makes a __repr__ of a method that returns the figures. It never fails."""
    @functools.wraps(describe)
    def shown(self):
        try:
            figures = describe(self)
        except Exception:
            figures = ""
        return f"<pcvt.{type(self).__name__}{': ' if figures else ''}{figures}>"
    shown.__doc__ = None
    return shown


def count(number, name):
    """3 sites, 1 site."""
    return f"{number} {name}" + ("" if number == 1 else "s")


def outcome(statistics):
    return (f"{count(statistics.n_sites, 'site')}, {statistics.stop.replace('-', ' ')}, "
            f"residual {statistics.residual:.2g}")


def svg_of(write):
    """The text of the .svg file that a function writes to the path that it gets."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "tile.svg")
        write(path)
        with open(path, encoding="utf-8") as file:
            return file.read()
