"""samples/stress_picture, flow_picture and stiffness: their pictures and texts, and the line with which they refuse files."""

import contextlib
import io
import pathlib
import random
import re
import runpy
import subprocess
import sys
from unittest import mock

from support.cli import CliTest, main

SAMPLES = pathlib.Path(__file__).resolve().parents[3] / "samples"
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
DAMAGES = ("nan", "inf", "1e999", "-1", "99999999", "²", "x", "", "(", ")", "{", ";", "7 7", "*NODE", "\0", "\u00e9")


def printed(name, *arguments):
    """Runs a sample; returns its exit code, its standard output and its standard error."""
    output, errors = io.StringIO(), io.StringIO()
    code = 0
    with mock.patch.object(sys, "argv", [name, *map(str, arguments)]), contextlib.redirect_stderr(errors), \
            contextlib.redirect_stdout(output), mock.patch.object(sys, "path", [str(SAMPLES), *sys.path]):
        try:
            runpy.run_path(str(SAMPLES / name), run_name="__main__")
        except SystemExit as end:
            code = end.code
    return code or 0, output.getvalue(), errors.getvalue()


def sample(name, *arguments):
    """Runs a sample; returns its exit code and its standard error."""
    code, _, errors = printed(name, *arguments)
    return code, errors


def table(title, rows):
    """Returns a table as CalculiX prints it."""
    return f"\n {title}\n\n" + "".join(f"{row}\n" for row in rows)


def stress_of(element, point, step):
    return [1e3 * step + 10 * element + point + k / 8 for k in range(6)]


def copies(svg):
    """Returns the translations of the tile in a picture, in units of its lower left period."""
    return [tuple(map(float, found)) for found in re.findall(r'<use href="#tile" x="([^"]*)" y="([^"]*)"/>', svg)]


class Pictures(CliTest):
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
        return self.path("job.inp"), self.path("job.dat"), "1"

    def stiffness(self):
        """Writes a job and the .dat file of a run whose elements have equal volumes; returns both, and the number of elements."""
        self.succeed("mesh", "--sites", 4, "--period", "2,1", "--mesh", "grains", "--size", 1, "--max-iterations", 5, "--quiet",
                     "--force", "--job", "elastic", "-o", "job.inp")
        job, data = self.path("job.inp"), self.path("job.dat")
        elements = re.findall(r"^(\d+),", job.read_text().split(",ELSET=EALL\n")[1].split("\n*")[0], re.M)
        volumes = [f"{int(element):10} {2 / len(elements):13.6E}" for element in elements]
        text = ""
        for step in (1, 2, 3):
            where = f"for set EALL and time  0.{step}000000E+01"
            stresses = [f"{int(element):10} {point:3}" + "".join(f" {s:13.6E}" for s in stress_of(int(element), point, step))
                        for element in elements for point in (1, 2)]
            text += table(f"stresses (elem, integ.pnt.,sxx,syy,szz,sxy,sxz,syz) {where}", stresses)
            text += table(f"strains (elem, integ.pnt.,exx,eyy,ezz,exy,exz,eyz) {where}", stresses[:3])
            text += table(f"volume (element, volume) {where}", volumes)
        data.write_text(text)
        return job, data, len(elements)

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

    def expect_line(self, name, arguments, pattern, remedy=""):
        code, output, line = printed(name, *arguments)
        self.assertEqual((code, output, line.count("\n")), (2, "", 1), line)
        self.assertRegex(line, f"^{re.escape(str(self.folder))}/{pattern}.*; {remedy}.*\n$")

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

    def test_stiffness_is_the_mean_stress_of_each_step(self):
        _, data, n = self.stiffness()
        means = {name: [sum(stress_of(element, point, step)[k] for element in range(1, n + 1) for point in (1, 2)) / (2 * n)
                        for step in (1, 2, 3)] for name, k in (("xx", 0), ("yy", 1), ("xy", 3))}
        for options, holes in (((), 1), (("--volume", "8"), 4)):
            code, output, _ = printed("stiffness", data, *options)
            rows = [line.split() for line in output.splitlines() if not line.startswith("#")]
            self.assertEqual((code, [row[0] for row in rows]), (0, list(means)))
            for name, *values in rows:
                for value, mean in zip(map(float, values), means[name], strict=True):
                    self.assertAlmostEqual(value * holes / mean, 1, 4)

    def test_stiffness_refuses_a_run_that_ended_early(self):
        _, data, n = self.stiffness()
        text = data.read_text()
        lines = text.splitlines(keepends=True)
        last_stress = max(k for k, line in enumerate(lines) if line.startswith(f"{n:10}   2"))
        for damaged, words in (("".join(lines[:-1]), "step 3 has other elements or points"),
                               ("".join(lines[:last_stress] + lines[last_stress + 1:]), "step 3 has other elements or points"),
                               (text.replace(f"{n:10}   ", f"{n + 1:10}   "), "step 1 has stresses and volumes of different"),
                               (text[:-3] + "1\n", f"the volume of element {n} in step 3 is not that in step 1"),
                               (text[:-1], "it ends in the middle of a line"),
                               (text[:text.rindex("\n volume")], "it does not hold the stresses and volumes of 3 steps"),
                               (text + lines[-1], f"element {n} has this row twice"),
                               (text[:-1] + " 1\n", "the row has 3 numbers"),
                               ("", "it does not hold the stresses and volumes of 3 steps")):
            for options in ((), ("--volume", "2")):
                with self.subTest(words, options=options):
                    data.write_text(damaged)
                    self.expect_line("stiffness", (data, *options), rf"job.dat(:\d+)?: {words}", "run ccx again")

    def test_stiffness_is_that_of_the_whole_file_or_none(self):
        source = random.Random(2)
        _, data, _ = self.stiffness()
        text = data.read_text()
        whole = printed("stiffness", data)
        self.assertEqual(whole[0], 0)
        for end in [*source.sample(range(len(text)), 100), *range(len(text) - 60, len(text))]:
            data.write_text(text[:end])
            found = printed("stiffness", data)
            if found != whole:
                self.assertEqual((found[0], found[1], found[2].count("\n")), (2, "", 1), found)

    def test_stiffness_refuses_elements_that_do_not_fill_the_job(self):
        job, data, n = self.stiffness()
        text = job.read_text()
        row = re.search(rf"^{n},.*\n", text.split(",ELSET=EALL\n")[1], re.M)[0]
        for damaged, words, remedy in ((text.replace(row, ""),
                                        rf"it has {n} elements, but \S*job\.inp {n - 1}", "run ccx job again"),
                                       (text.replace(row, f"9{row}"), f"it has the element {n}, but ", "run ccx job again"),
                                       (text.replace("period is 2,", "period is 1.99999,"), "the volume of its elements is 2",
                                        "run ccx again")):
            job.write_text(damaged)
            self.expect_line("stiffness", (data,), f"job.dat: {words}", remedy)
        self.expect_line("stiffness", (data, "--volume", "1.9"), "job.dat: the volume of its elements is 2, ", "give the volume")
        mesh = text[:text.index("** Materials")]
        self.path("mesh.inp").write_text(mesh)
        job.write_text(text.replace(mesh, "*INCLUDE,INPUT=mesh.inp\n"))
        self.assertEqual(sample("stiffness", data), (0, ""))
        self.path("mesh.inp").write_text(mesh.replace(row, ""))
        self.expect_line("stiffness", (data,), f"job.dat: it has {n} elements")

    def test_stiffness_refuses_files_that_are_none(self):
        job, data, _ = self.stiffness()
        self.path("binary.dat").write_bytes(bytes(range(256)))
        self.path("folder.dat").mkdir()
        for name, words, remedy in (("none.dat", "there is no such file, for ccx has not run yet", "run ccx none"),
                                    ("binary.dat", "this is not a text file", "give the .dat file"),
                                    ("folder.dat", "Is a directory", "give the .dat file"),
                                    ("job.inp", "it does not hold the stresses", "run ccx again")):
            self.expect_line("stiffness", (self.path(name),), f"{name}: {words}", remedy)
        text = job.read_text()
        job.write_bytes(f"** Maße\n{text}".encode("latin-1"))
        self.expect_line("stiffness", (data,), "job.inp: this is not a text file in UTF-8", "save the job in UTF-8")
        self.assertEqual(sample("stiffness", data, "--volume", "2"), (0, ""))
        job.write_text(text.replace("area of the period", "area"))
        self.expect_line("stiffness", (data,), "job.inp: it does not state the area of the period", "give --volume V")
        job.unlink()
        self.expect_line("stiffness", (data,), "job.inp: there is no such file, ", "give --volume V")
        for volume in ("0", "-1", "nan", "inf"):
            code, line = sample("stiffness", data, f"--volume={volume}")
            self.assertEqual((code, line.count("\n")), (2, 1), line)
            self.assertRegex(line, "^--volume: .* is not a volume; ")

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
                            ("*NODE\n1,0,0,0\n*ELEMENT,TYPE=C3D8\n1,1,2,3,4,5,6,7,8\n", "8 nodes and is not a triangle"),
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
                                        (case / "0.5/U", *(mesh / n for n in ("boundary", "faces", "points")))),
                                       ("stiffness", (data,), (job, data))):
            if name == "stiffness":
                self.stiffness()
            for path in files:
                text = path.read_text()
                for _ in range(25):
                    words = re.split(r"([\s,()]+)", text)
                    k = source.randrange(len(words))
                    damaged = "".join([*words[:k], source.choice(DAMAGES), *words[k + 1:]])
                    path.write_text(damaged if source.random() < 0.7 else damaged[:source.randrange(len(damaged))])
                    code, line = sample(name, *arguments)
                    self.assertIn((code, line.count("\n")), ((0, 0), (2, 1)), (path, line))
                path.write_text(text)

    def test_a_picture_that_cannot_be_written_is_reported(self):
        code, line = sample("flow_picture", *self.flow(), self.path("none/out.svg"))
        self.assertEqual(code, 3)
        self.assertRegex(line, r"none/out\.svg: cannot write: No such file or directory; .*\n$")

    def test_numbers_that_cannot_be_printed_are_reported(self):
        _, data, _ = self.stiffness()
        with open("/dev/full", "wb") as full:
            done = subprocess.run([SAMPLES / "stiffness", data], stdout=full, stderr=subprocess.PIPE, text=True, check=False)
        self.assertEqual((done.returncode, done.stderr.count("\n")), (3, 1), done.stderr)
        self.assertRegex(done.stderr, "^standard output: cannot write: No space left on device; ")


if __name__ == "__main__":
    main()
