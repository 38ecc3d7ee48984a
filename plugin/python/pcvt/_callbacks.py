"""The functions of a caller, as the library may call them."""

import os
import signal
from ctypes import c_double
from typing import NamedTuple

import numpy as np

from ._shown import one_line

PHASES = ("start", "optimise", "build", "prove", "write")


class Progress(NamedTuple):
    """The state of a run. `energy_bound` is NaN with a density.

    phase       start, optimise, build, prove or write
    fraction    the part of the phase that is done, 0 to 1; negative: unknown
    phase_text  the phase in words: "writing tile.msh, 1 of 1"
    """

    iteration: int
    evaluations: int
    energy: float
    energy_bound: float
    residual: float
    rms_residual: float
    phase: str
    fraction: float
    phase_text: str

    @one_line
    def __repr__(self):
        if self.phase == "optimise" and self.evaluations != 0:
            return f"{self.phase_text}, iteration {self.iteration}, residual {self.residual:.2g}"
        return self.phase_text + (f", {self.fraction:.0%}" if self.fraction >= 0 else "")


def _copy(view):
    fields = {name: getattr(view, name) for name in Progress._fields}
    fields["phase"] = PHASES[view.phase]
    fields["phase_text"] = os.fsdecode(view.phase_text)
    return Progress(**fields)


class Callbacks:
    """The callbacks of the library inside of a `with` block, and the exception that they raised.

    Python raises KeyboardInterrupt on entry into a function. If ctypes called that function, Python
    prints the exception and drops it. So Ctrl-C is noted here, and raised where it can propagate:
    inside of the caller's own functions, or after the call of the library.
    """

    def __init__(self, density, progress):
        self.density, self.progress = density, progress
        self.error = None
        self.noted = None
        self.inside = False
        self.buffers = None

    def __enter__(self):
        self.handler = signal.getsignal(signal.SIGINT)
        if callable(self.handler):
            try:
                signal.signal(signal.SIGINT, self.note)
            except ValueError:  # Only the main thread gets signals.
                self.handler = None
        return self

    def __exit__(self, *_):
        if callable(self.handler):
            signal.signal(signal.SIGINT, self.handler)
        self.deliver()

    def note(self, *interrupt):
        self.noted = interrupt
        if self.inside:
            self.inside = False
            self.deliver()
            self.inside = True

    def deliver(self):
        if self.noted:
            interrupt, self.noted = self.noted, None
            self.handler(*interrupt)

    def keep(self, error):
        """Keeps the exception and ends the run; no exception may pass through the library."""
        self.inside = False
        self.error = error
        return 1

    def look_at(self, *buffers):
        """Makes arrays of the buffers. The library reuses its buffers, so this is rarely called."""
        points, n_points, values = self.buffers = buffers
        pairs = np.frombuffer((c_double * (2 * n_points)).from_address(points))
        self.positions = pairs.reshape(n_points, 2).T
        self.values = np.frombuffer((c_double * n_points).from_address(values))

    def ask_density(self, points, n_points, values, _):
        try:
            self.inside = True
            self.deliver()
            if self.buffers != (points, n_points, values):
                self.look_at(points, n_points, values)
            x, y = self.positions.copy("C")
            self.values[:] = self.density(x, y)
            self.inside = False
            return 0
        except BaseException as error:
            return self.keep(error)

    def show_progress(self, progress, _):
        try:
            self.inside = True
            self.deliver()
            answer = self.progress is not None and bool(self.progress(_copy(progress.contents)))
            self.inside = False
            return answer
        except BaseException as error:
            return self.keep(error)
