"""Phases and orientations in Python."""

import unittest

from support.cli import CliTest, main
from support.python_package import pcvt

import numpy as np


class Materials(CliTest):
    def test_phases_have_their_fractions(self):
        result = pcvt.mesh(200, phases={"soft": 0.3, "hard": 0.7}, tolerance=1e-3)
        self.assertEqual(result.phase_names, ("soft", "hard"))
        areas = result.cells["area"]
        self.assertLess(abs(areas[result.phases == 0].sum() - 0.3), areas.min() / 2 * (1 + 1e-9))
        self.assertIsNone(result.orientations)
        same = pcvt.mesh(200, phases="soft:0.3,hard:0.7", tolerance=1e-3)
        np.testing.assert_array_equal(same.phases, result.phases)

    def test_orientations_are_given_or_drawn(self):
        angles = np.arange(60.0).reshape(20, 3)
        result = pcvt.mesh(20, orientations=angles)
        np.testing.assert_array_equal(result.orientations, angles)
        self.assertIsNone(result.phases)
        self.assertEqual(result.phase_names, ())
        drawn = pcvt.mesh(20, orientations="random", seed=3).orientations
        np.testing.assert_array_equal(drawn, pcvt.mesh(20, orientations="random", seed=3).orientations)
        self.assertEqual(drawn.shape, (20, 3))
        # Arrays are degrees, also where a file with these numbers would look like radians.
        small = np.linspace(0, 3, 60).reshape(20, 3)
        np.testing.assert_array_equal(pcvt.mesh(20, orientations=small).orientations, small)

    def test_orientations_are_drawn_from_a_list(self):
        angles = np.arange(60.0).reshape(20, 3)
        drawn = pcvt.mesh(8, orientations=angles).orientations
        self.assertEqual(len(np.unique(drawn[:, 0])), 8)
        self.assertTrue(set(map(tuple, drawn)) <= set(map(tuple, angles)))
        weighted = pcvt.mesh(20, orientations=angles[:3], orientation_weights=(1, 0, 3)).orientations
        self.assertEqual([(weighted[:, 0] == x).sum() for x in (0, 3, 6)], [5, 0, 15])
        space = pcvt.mesh(8, period=(1, 1, 1), orientations=angles).orientations
        np.testing.assert_array_equal(space, drawn)

    def test_files_are_those_of_the_command(self):
        options = ("--phases", "a:0.5,b:0.5", "--orientations", "random", "--job", "elastic",
                   "--material", "a:231400,134700,116400", "--material", "b:162.4,92,69,180.7,46.7")
        self.succeed("mesh", "--sites", 12, "--mesh", "grains", *options, "-o", "command.inp")
        result = pcvt.mesh(12, phases={"a": 0.5, "b": 0.5}, orientations="random")
        constants = {"a": (231400, 134700, 116400), "b": (162.4, 92, 69, 180.7, 46.7)}
        result.write(self.path("python.inp"), "grains", job="elastic", materials=constants)
        files = self.contents()
        self.assertEqual(files["python.inp"], files["command.inp"])
        # Files of other formats and kinds do not state the materials.
        result.write(self.path("t.obj"))
        result.write(self.path("delaunay.inp"), "delaunay")
        self.assertNotIn(b"\n*SOLID SECTION", self.contents()["delaunay.inp"])

    def test_colours_show_phases(self):
        self.succeed("mesh", "--sites", 12, "--phases", "a:0.5,b:0.5", "--colour", "phase", "-o", "command.svg")
        result = pcvt.mesh(12, phases={"a": 0.5, "b": 0.5}, orientations="random")
        result.write(self.path("python.svg"), colour="phase")
        files = self.contents()
        self.assertEqual(files["python.svg"], files["command.svg"])
        with self.assertRaisesRegex(pcvt.Error, "colour phase needs phases"):
            pcvt.mesh(12).write(self.path("t.svg"), colour="phase")

    def test_a_job_of_several_phases_needs_constants(self):
        result = pcvt.mesh(12, phases={"a": 0.5, "b": 0.5})
        job = self.path("t.inp"), "grains"
        for options, words in (({}, "would give the phases a, b the same"), ({"materials": {"a": (1, 0.3)}}, "the phase b has"),
                               ({"materials": "b"}, "materials: 'b': no material"),
                               ({"materials": {"a": (1, 0.5), "b": (1, 0)}}, "no material is stable")):
            with self.assertRaisesRegex(pcvt.ArgumentError, words):
                result.write(*job, job="elastic", **options)
        with self.assertRaisesRegex(pcvt.ArgumentError, "Delaunay triangles one material"):
            result.write(self.path("t.inp"), "delaunay", job="elastic", materials="same")
        result.write(*job, job="elastic", materials="same")
        self.assertEqual(self.path("t.inp").read_text().count("\n*ELASTIC\n210000.,0.3\n"), 2)

    def test_wrong_materials_are_refused(self):
        for options, words in (({"phases": {"a": 0.5}}, "make the sum 1"), ({"phases": "a"}, "NAME:FRACTION"),
                               ({"phases": {"a b": 1}}, "letters"), ({"orientations": "rolled"}, "random"),
                               ({"orientations": [[1, 2, 3]]}, "n_orientations"),
                               ({"orientation_weights": [1]}, "give one"),
                               ({"orientations": "random", "orientation_weights": [1]}, "give one"),
                               ({"orientations": [[1, 2, 3]], "orientation_weights": [1, 2]}, "orientation_weights"),
                               ({"orientations": [[1, 2, 3]], "orientation_weights": [-1]}, "from 0 to 1e150"),
                               ({"orientations": [[1, 2, 400]] * 5}, "-360 to 360"),
                               ({"orientations": "random", "fibres": (0.3, 2)}, "leave it out")):
            with self.assertRaisesRegex(pcvt.ArgumentError, words):
                pcvt.mesh(5, **options)


if __name__ == "__main__":
    main()
