"""samples/stress_picture and flow_picture: their pictures, and the line with which they refuse files."""

import math
import os
import random
import re

from support.cli import main
from support.samples import LONG, SampleTest, printed, sample

WALLS = {"": [(0, 0), (2, 0), (0, 1), (2, 1)], "y": [(0, 0), (2, 0)], "x": [(0, 0), (0, 1)], "xy": [(0, 0)]}
JOB = """*INCLUDE, INPUT={}
*MATERIAL, NAME=M
*ELASTIC
1, 0.3
*SOLID SECTION, ELSET=EALL, MATERIAL=M
1.
*STEP
*STATIC
*EL PRINT, ELSET=EALL
S
*END STEP
"""


def copies(svg):
    """Returns the translations of the tile in a picture, in units of its lower left period."""
    return [tuple(map(float, found)) for found in re.findall(r'<use href="#tile" x="([^"]*)" y="([^"]*)"/>', svg)]


class Pictures(SampleTest):
    def stress(self, walls=""):
        """Writes a job that includes a mesh, and a table of stresses; returns the arguments of stress_picture."""
        self.succeed("mesh", "--sites", 12, "--period", "2,1", "--mesh", "grains", "--max-iterations", 5, "--quiet", "--force",
                     *(["--walls", walls] if walls else []), "-o", "tile.inp")
        self.path("job.inp").write_text(JOB.format("tile.inp"))
        mesh = self.path("tile.inp").read_text()
        elements = re.findall(r"^(\d+),", mesh.split(",ELSET=EALL\n")[1].split("\n*")[0], re.M)
        rows = "".join(f"{int(element):10} {point} {'1.0E+00 ' * 6}\n" for element in elements for point in (1, 2, 3))
        title = " stresses (elem, integ.pnt.,sxx,syy,szz,sxy,sxz,syz) for set EALL and time  0.1000000E+01\n\n"
        self.path("job.dat").write_text("\n" + title + rows + "\n")
        self.set_age("job.dat", -LONG)
        return self.path("job.inp"), self.path("job.dat"), "1"

    def stress_in_space(self, *options):
        """The same of tetrahedra in 5 cells of a box; the first cell has twice the stress."""
        self.succeed("mesh", "--sites", 5, "--period", "1,2,1", "--mesh", "grains", "--max-iterations", 5, "--quiet", "--force",
                     *options, "-o", "tile.inp")
        self.path("job.inp").write_text(JOB.format("tile.inp"))
        mesh = self.path("tile.inp").read_text()
        elements = re.findall(r"^(\d+),(?:\d+,?)+\n", mesh.split(",ELSET=EALL\n")[1].split("\n*")[0] + "\n", re.M)
        first = set(re.findall(r"\d+", mesh.split("*ELSET,ELSET=CELL_0\n")[1].split("*")[0]))
        rows = "".join(f"{int(e):10} 1 {'2.0E+00 ' if e in first else '1.0E+00 '}{'0.0E+00 ' * 5}\n" for e in elements)
        title = " stresses (elem, integ.pnt.,sxx,syy,szz,sxy,sxz,syz) for set EALL and time  0.1000000E+01\n\n"
        self.path("job.dat").write_text("\n" + title + rows + "\n")
        self.set_age("job.dat", -LONG)
        return self.path("job.inp"), self.path("job.dat"), "1"

    @staticmethod
    def area(svg):
        """The area of all polygons of a picture, and that of the brightest ones."""
        sums = {}
        for points, shade in re.findall(r'<polygon points="([^"]*)" fill="([^"]*)"', svg):
            corners = [complex(*map(float, point.split(","))) for point in points.split()]
            area = abs(sum((p.conjugate() * q).imag for p, q in zip(corners, corners[1:] + corners[:1]))) / 2
            sums[shade] = sums.get(shade, 0) + area
        return sum(sums.values()), sums.get("#fcf496", 0)

    def test_slices_fill_their_plane_and_show_the_cells(self):
        for options in ((), ("--outline", "box"), ("--order", 2)):
            arguments = self.stress_in_space(*options)
            for word, share in (("w=0.5", 1 / 2), ("u=0.25", 2), ("v=0.125", 1)):
                with self.subTest(options=options, slice=word):
                    svg = self.draw("stress_picture", (*arguments, word))
                    width, height = (int(re.search(rf'{name}="(\d+)"', svg)[1]) for name in ("width", "height"))
                    self.assertEqual(len(copies(svg)), 4)
                    # The picture has two periods along each axis, and the scale below.
                    whole, first = self.area(svg)
                    self.assertAlmostEqual(4 * whole / (width * (height - 70)), 1, 2)
                    self.assertAlmostEqual(width / (height - 70), share, 1)
                    self.assertLess(first, 0.6 * whole)
        # Cell 0 fills a fifth of the volume: the mean over planes.
        parts = [self.area(self.draw("stress_picture", (*arguments, f"w={k / 20 + 0.01}"))) for k in range(20)]
        self.assertAlmostEqual(sum(first / whole for whole, first in parts) / 20, 0.2, 1)

    def test_open_picture_shows_six_faces(self):
        arguments = self.stress_in_space()
        svg = self.draw("stress_picture", arguments)
        self.assertEqual(svg, self.draw("stress_picture", (*arguments, "open")))
        self.assertEqual(len(copies(svg)), 1)
        self.assertEqual(len(set(re.findall(r'fill="(#[0-9a-f]{6})"', svg)) & {"#fcf496"}), 1)
        # The faces cover the outline of the period once.
        ends = [complex(*map(float, point.split(","))) for row in re.findall(r'<polygon points="([^"]*)"', svg)
                for point in row.split()]
        hull = [max(ends, key=lambda p, turn=turn: (p * turn).real) for turn in
                (complex(math.cos(t), math.sin(t)) for t in (k * math.pi / 180 for k in range(360)))]
        area = abs(sum((p.conjugate() * q).imag for p, q in zip(hull, hull[1:] + hull[:1]))) / 2
        self.assertAlmostEqual(self.area(svg)[0] / area, 1, 2)

    def test_slices_that_are_none_are_refused(self):
        job, data, step = self.stress_in_space()
        for word in ("w=2", "z=0.5", "w", "w=", "w=-1", "w=nan"):
            self.expect_refusal("stress_picture", (job, data, step, word), rf"job\.inp: '{re.escape(word)}' is no slice")
        job, data, step = self.stress()
        self.expect_refusal("stress_picture", (job, data, step, "w=0.5"), r"job\.inp: its elements lie in the plane, which has no ")

    def flow(self, walls=""):
        """Writes a case with the field of a solver at time 0.5; returns the arguments of flow_picture."""
        self.succeed("mesh", "--sites", 12, "--period", "2,1", "--max-iterations", 5, "--quiet", "--force",
                     *(["--walls", walls] if walls else []), "-o", "case.foam")
        solved = self.path("case.foam/0.5")
        solved.mkdir(exist_ok=True)
        vectors = "\n".join(f"({k} {k % 3} 0)" for k in range(12))
        field = f"internalField   nonuniform List<vector> \n12\n(\n{vectors}\n)\n;\n\nboundaryField\n{{\n}}\n"
        (solved / "U").write_text(f"FoamFile\n{{\n    format      ascii;\n    object      U;\n}}\n{field}")
        return self.path("case.foam"), "0.5"

    def draw(self, name, arguments):
        out = self.path("out.svg")
        self.assertEqual(sample(name, *arguments, out), (0, ""))
        return out.read_text()

    def expect_refusal(self, name, arguments, pattern):
        self.path("out.svg").unlink(missing_ok=True)
        self.expect_line(name, (*arguments, self.path("out.svg")), pattern)
        self.assertFalse(self.path("out.svg").exists())

    def test_a_tile_repeats_along_its_periods_and_not_across_walls(self):
        for name, make in (("stress_picture", self.stress), ("flow_picture", self.flow)):
            for walls, expected in WALLS.items():
                with self.subTest(name, walls=walls):
                    found = copies(self.draw(name, make(walls)))
                    width, height = (max(abs(shift[k]) for shift in found) or 1 for k in (0, 1))
                    self.assertEqual([(2 * x / width, -y / height) for x, y in found], expected)

    def test_a_field_may_be_uniform_or_short_or_that_of_the_start(self):
        case, _ = self.flow()
        body = "".join(f"({k} 0 0)" for k in range(12))
        for text in ("uniform (1 2 0)", f"nonuniform List<vector> 12({body})"):
            (case / "0.5/U").write_text(f"internalField   {text};\n")
            self.assertEqual(self.draw("flow_picture", (case, "0.5")).count("<polygon"), 12)
        self.draw("flow_picture", (case, "0"))
        self.assertEqual(self.draw("flow_picture", (case, "last")).count("<polygon"), 12)

    def test_stresses_of_zero_are_drawn(self):
        job, data, _ = self.stress()
        data.write_text(data.read_text().replace("1.0E+00", "0.0E+00"))
        self.assertNotIn("nan", self.draw("stress_picture", (job, data, "1")))

    def test_the_last_tick_tells_whether_stresses_exceed_it(self):
        job, data, _ = self.stress()
        self.assertNotIn("≥", self.draw("stress_picture", (job, data, "1")))
        row = f"{1:10} 1 "
        data.write_text(data.read_text().replace(row + "1.0E+00", row + "9.0E+00"))
        ticks = re.findall(r"<text [^>]*>([^<]*)</text>", self.draw("stress_picture", (job, data, "1")))
        self.assertEqual([tick.startswith("≥ ") for tick in ticks], [False] * 5 + [True])

    def test_stresses_of_another_job_are_refused(self):
        job, data, _ = self.stress()
        foreign = f"{999999:10} 1 {'1.0E+00 ' * 6}\n"
        data.write_text(data.read_text()[:-1] + foreign)
        self.expect_refusal("stress_picture", (job, data, "1"), "job.dat: step 1 has a stress of element 999999, which ")

    def test_an_included_mesh_may_be_newer_than_the_results(self):
        arguments = self.stress()
        self.draw("stress_picture", arguments)
        tile = self.path("tile.inp")
        os.utime(tile, (tile.stat().st_atime, tile.stat().st_mtime + 2 * LONG))
        self.expect_refusal("stress_picture", arguments, r"job\.dat: it is older than \S*/tile\.inp")

    def test_files_that_are_none_are_refused(self):
        job, data, _ = self.stress()
        case, _ = self.flow()
        mesh, field = case / "constant/polyMesh", case / "0.5/U"
        self.path("empty").write_text("")
        self.path("binary").write_bytes(bytes(range(256)))
        for file, words in (("empty", ""), ("binary", "this is not a text file"), ("none", "No such file"),
                            ("case.foam", "Is a directory")):
            path = self.path(file)
            self.expect_refusal("stress_picture", (path, data, "1"), f"{file}: .*{words}")
            self.expect_refusal("stress_picture", (job, path, "1"), f"{file}: .*{words}")
        for case_name in ("none", "job.inp"):
            self.expect_refusal("flow_picture", (self.path(case_name), "last"), f"{case_name}: there is no such folder")
        for step in ("0", "2", "one", "-1", "²", "9" * 5000):
            self.expect_refusal("stress_picture", (job, data, step), f"job.dat: it has no step '{step}'")
        self.expect_refusal("flow_picture", (case, "7"), "case.foam: it has no time '7' ")
        for text, words in (("format binary;", "it is binary"), ("internalField uniform (1 2);", "'1 2' is not 3 numbers"),
                            ("internalField uniform (nan 0 0);", "not finite"), ("internalField uniform 3;", "no internalField of vectors"),
                            ("internalField nonuniform List<vector> 2((1 2 3)(4 5 6));", "2 vectors, but the mesh 12 cells")):
            field.write_text(text)
            self.expect_refusal("flow_picture", (case, "0.5"), f"case.foam/0.5/U: .*{words}")
        field.rename(case / "0.5/U.gz")
        self.expect_refusal("flow_picture", (case, "0.5"), "case.foam/0.5/U.gz: it is compressed")
        faces = (mesh / "faces").read_text()
        for corner in ("²", "9" * 5000):
            (mesh / "faces").write_text(re.sub(r"^(\d*\(\d+) \d+", rf"\1 {corner}", faces, flags=re.M))
            self.expect_refusal("flow_picture", (case, "0"), "case.foam/constant/polyMesh/faces: face .* has no three points")
        (mesh / "faces").write_text(faces)
        for name, words in (("boundary", "no patch 'back'"), ("points", "no list"), ("faces", "no list")):
            kept = (mesh / name).read_text()
            (mesh / name).write_text("FoamFile {}\n")
            self.expect_refusal("flow_picture", (case, "0"), f"case.foam/constant/polyMesh/{name}: .*{words}")
            (mesh / name).write_text(kept)

    def test_meshes_of_other_programs_are_refused(self):
        job, data, _ = self.stress()
        mesh = self.path("tile.inp").read_text()
        for text, words in ((mesh.replace("pcvt lattice", "lattice"), "no comment 'pcvt lattice'"),
                            (mesh.replace("ELSET=CELL_", "ELSET=GRAIN_"), "in no set CELL_s"),
                            ("*NODE\n1,0,0,0\n*ELEMENT,TYPE=C3D8\n1,1,2,3,4,5,6,7,8\n", "8 nodes and is not a tetrahedron"),
                            ("*NODE\n1,0,0,0\n*ELEMENT,TYPE=CPE3\n1,1,2,3\n", "no comment")):
            self.path("tile.inp").write_text(text)
            self.expect_refusal("stress_picture", (job, data, "1"), rf"(job|tile)\.inp(:\d+)?: .*{words}")
        for include, words in (("none.inp", "there is no file"), ("job.inp", "includes itself")):
            job.write_text(JOB.format(include))
            self.expect_refusal("stress_picture", (job, data, "1"), f"job.inp:1: .*{words}")
        case, _ = self.flow()
        boundary = case / "constant/polyMesh/boundary"
        boundary.write_text(boundary.read_text().replace("pcvt lattice", "lattice"))
        self.expect_refusal("flow_picture", (case, "0"), "case.foam/constant/polyMesh/boundary: it has no comment 'pcvt lattice'")
        self.succeed("mesh", "--sites", 8, "--period", "1,1,1", "-o", "space.foam")
        self.expect_refusal("flow_picture", (self.path("space.foam"), "0"), "space.foam/constant/polyMesh/boundary: it has no patch 'back'")

    def test_damaged_files_are_drawn_or_refused_in_one_line(self):
        source = random.Random(1)
        job, data, _ = self.stress()
        case, _ = self.flow()
        mesh, out = case / "constant/polyMesh", self.path("out.svg")
        for name, arguments, files in (("stress_picture", (job, data, "1", out), (job, data, self.path("tile.inp"))),
                                       ("flow_picture", (case, "0.5", out),
                                        (case / "0.5/U", *(mesh / n for n in ("boundary", "faces", "points"))))):
            self.damage(source, name, arguments, files)

    def test_a_picture_that_cannot_be_written_is_reported(self):
        code, line = sample("flow_picture", *self.flow(), self.path("none/out.svg"))
        self.assertEqual(code, 3)
        self.assertRegex(line, r"none/out\.svg: cannot write: No such file or directory; .*\n$")


if __name__ == "__main__":
    main()
