"""Functions of a caller that the Python package calls back: densities, progress, Ctrl-C."""

import os
import signal
import tempfile
import threading
import unittest

from support.cli import main
from support.python_package import pcvt

import numpy as np


class Density(unittest.TestCase):
    def test_a_function_gives_the_result_of_its_expression(self):
        seen = set()

        def density(x, y):
            seen.add((x.shape, y.shape, x.dtype.char))
            return 1.5 + np.sin(2 * np.pi * x)

        by_function = pcvt.mesh(3, density=density, max_iterations=1)
        by_text = pcvt.mesh(3, density="1.5 + sin(2*_pi*x)", max_iterations=1)
        np.testing.assert_allclose(by_function.sites, by_text.sites, atol=1e-9)
        self.assertTrue(np.isnan(by_function.statistics.energy_bound))
        for x, y, kind in seen:
            self.assertEqual((x, kind), (y, "d"))

    def test_its_exceptions_come_through(self):
        with self.assertRaises(ZeroDivisionError):
            pcvt.mesh(10, density=lambda x, y: 1 / 0)
        with self.assertRaisesRegex(ValueError, "broadcast"):
            pcvt.mesh(10, density=lambda x, y: np.ones(len(x) + 2))

    def test_bad_values_are_refused(self):
        for value in (float("nan"), 0, -1):
            with self.assertRaisesRegex(pcvt.DensityError, "positive"):
                pcvt.mesh(10, density=lambda x, y, value=value: value)


class Stopping(unittest.TestCase):
    def tearDown(self):
        self.assertIs(signal.getsignal(signal.SIGINT), signal.default_int_handler)

    def test_a_true_answer_cancels(self):
        seen = []

        def progress(state):
            seen.append(state)
            return state.iteration == 7

        with self.assertRaisesRegex(pcvt.Cancelled, "cancelled"):
            pcvt.mesh(1000, progress=progress)
        self.assertEqual([state.iteration for state in seen], list(range(8)))
        self.assertLess(seen[-1].energy, seen[0].energy)
        self.assertGreater(seen[-1].energy, seen[-1].energy_bound)

    def test_phases_are_named_and_a_write_can_be_cancelled(self):
        seen = []
        result = pcvt.mesh(1000, progress=seen.append)
        self.assertEqual(list(dict.fromkeys(state.phase for state in seen)), ["start", "optimise"])
        self.assertEqual(seen[-1].phase_text, "optimising")
        self.assertEqual(seen[-1].fraction, 1)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "t.vtu")
            with self.assertRaisesRegex(pcvt.Cancelled, "cancelled"):
                result.write(path, progress=lambda state: state.phase == "write")
            self.assertEqual(os.listdir(folder), [])
            seen.clear()
            result.write(path, "grains", progress=seen.append)
            self.assertEqual(list(dict.fromkeys(state.phase for state in seen)), ["build", "prove", "write"])
            self.assertEqual(seen[-1].phase_text, "writing t.vtu, 1 of 1")
            with self.assertRaisesRegex(LookupError, "mine"):
                result.write(path, replace=True, progress=lambda _: {}["mine"])

    def test_exceptions_of_progress_come_through(self):
        for error in (KeyboardInterrupt, SystemExit, LookupError):
            def progress(_, error=error):
                raise error("mine")

            with self.assertRaisesRegex(error, "mine"):
                pcvt.mesh(100, progress=progress)

    def test_an_interrupt_inside_of_a_function_comes_through(self):
        went_on = []

        def interrupted(*_):
            signal.raise_signal(signal.SIGINT)
            went_on.append(True)
            return 1

        with self.assertRaises(KeyboardInterrupt):
            pcvt.mesh(100, progress=interrupted)
        with self.assertRaises(KeyboardInterrupt):
            pcvt.mesh(100, density=interrupted)
        self.assertEqual(went_on, [])

    def test_an_interrupt_while_the_library_computes_comes_through(self):
        timer = threading.Timer(0.1, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        self.addCleanup(timer.join)
        with self.assertRaises(KeyboardInterrupt):
            pcvt.mesh(30000, tolerance=1e-12)

    def test_any_thread_may_generate(self):
        found = []
        thread = threading.Thread(target=lambda: found.append(pcvt.mesh(100, seed=4)))
        thread.start()
        thread.join()
        np.testing.assert_array_equal(found[0].sites, pcvt.mesh(100, seed=4).sites)


if __name__ == "__main__":
    main()
