"""samples/stiffness: its figures, and the line with which it and stress_picture refuse the results of other jobs."""

import random
import re
import subprocess

from support.cli import main
from support.samples import LONG, SAMPLES, SampleTest, printed, sample


def table(title, rows):
    """Returns a table as CalculiX prints it."""
    return f"\n {title}\n\n" + "".join(f"{row}\n" for row in rows)


def stress_of(element, point, step):
    return [1e3 * step + 10 * element + point + k / 8 for k in range(6)]


def areas_of(job):
    """Returns the area of each element of a job."""
    def rows(card):
        text = job.split(card, 1)[1].split("\n", 1)[1].split("\n*")[0]
        return {int(row[0]): row[1:] for row in (line.split(",") for line in text.splitlines())}

    points = {node: complex(float(row[0]), float(row[1])) for node, row in rows("*NODE,").items()}
    areas = {}
    for element, corners in rows("*ELEMENT,").items():
        a, b, c = (points[int(corner)] for corner in corners[:3])
        areas[element] = ((b - a).conjugate() * (c - a)).imag / 2
    return areas


class Stiffness(SampleTest):
    def stiffness(self, *options):
        """Writes a job and the .dat file of a run; returns both, and the number of elements."""
        self.succeed("mesh", "--sites", 4, "--period", "2,1", "--mesh", "grains", "--size", 1, "--max-iterations", 5, "--quiet",
                     "--force", "--job", "elastic", *options, "-o", "job.inp")
        job, data = self.path("job.inp"), self.path("job.dat")
        areas = areas_of(job.read_text())
        elements = list(areas)
        volumes = [f"{element:10} {area:13.6E}" for element, area in areas.items()]
        text = ""
        for step in (1, 2, 3):
            where = f"for set EALL and time  0.{step}000000E+01"
            stresses = [f"{element:10} {point:3}" + "".join(f" {s:13.6E}" for s in stress_of(element, point, step))
                        for element in elements for point in (1, 2)]
            text += table(f"stresses (elem, integ.pnt.,sxx,syy,szz,sxy,sxz,syz) {where}", stresses)
            text += table(f"strains (elem, integ.pnt.,exx,eyy,ezz,exy,exz,eyz) {where}", stresses[:3])
            text += table(f"volume (element, volume) {where}", volumes)
        data.write_text(text)
        self.set_age("job.dat", -LONG)
        return job, data, len(elements)

    def test_stiffness_is_the_mean_stress_of_each_step(self):
        job, data, _ = self.stiffness()
        areas = areas_of(job.read_text())
        means = {name: [sum(area * stress_of(element, point, step)[k] for element, area in areas.items() for point in (1, 2)) / 4
                        for step in (1, 2, 3)] for name, k in (("xx", 0), ("yy", 1), ("xy", 3))}
        for options, holes in (((), 1), (("--volume", "8"), 4)):
            code, output, _ = printed("stiffness", data, *options)
            rows = [line.split() for line in output.splitlines() if not line.startswith("#")]
            self.assertEqual((code, [row[0] for row in rows]), (0, list(means)))
            for name, *values in rows:
                for value, mean in zip(map(float, values), means[name], strict=True):
                    self.assertAlmostEqual(value * holes / mean, 1, 4)

    def bounds(self, *options):
        """Returns the least and the greatest xx, yy and xy that the script prints for a job."""
        data = self.stiffness(*options)[1]
        line = printed("stiffness", data)[1].splitlines()[-1]
        found = re.fullmatch(r"# by the materials of the elements \(Reuss to Voigt\): xx (\S+) to (\S+), yy (\S+) to (\S+), "
                             r"xy (\S+) to (\S+)", line)
        return [(float(found[k]), float(found[k + 1])) for k in (1, 3, 5)]

    def test_bounds_are_the_means_of_the_materials(self):
        def strain(modulus, nu):
            return modulus * (1 - nu) / ((1 + nu) * (1 - 2 * nu)), modulus / (2 * (1 + nu))

        parts = ("--phases", "a:0.5,b:0.5", "--material", "a:10,0", "--material", "b:30,0")
        for options, wanted in (((), [(strain(210000, 0.3)[0],) * 2, (strain(210000, 0.3)[1],) * 2]),
                                (("--element", "CPS"), [(210000 / (1 - 0.09),) * 2, (strain(210000, 0.3)[1],) * 2]),
                                # Crystals that are isotropic have one stiffness, however they are turned.
                                (("--orientations", "random", "--material", "GRAINS:30,10,10"), [(30, 30), (10, 10)])):
            (xx, yy, xy) = self.bounds(*options)
            for found, expected in ((xx, wanted[0]), (yy, wanted[0]), (xy, wanted[1])):
                for value, number in zip(found, expected, strict=True):
                    self.assertAlmostEqual(value / number, 1, 4)
        # Two phases without Poisson's ratio, a part p of the area hard: p 30 + (1 - p) 10, and 1 / (p / 30 + (1 - p) / 10).
        least, most = self.bounds(*parts)[0]
        p = (most - 10) / 20
        self.assertTrue(0.3 < p < 0.7)
        self.assertAlmostEqual(least * (p / 30 + (1 - p) / 10), 1, 4)

    def test_mean_stress_of_any_steps(self):
        job, data, _ = self.stiffness()
        areas = areas_of(job.read_text())
        tables = data.read_text().split("\n stresses")
        data.write_text("\n stresses" + "\n stresses".join(tables[2:]))
        lines = printed("stiffness", data, "--mean")[1].splitlines()
        self.assertEqual([line.split()[0] for line in lines], ["#", "#", "1", "2"])
        means = [sum(area * stress_of(element, point, 2)[k] for element, area in areas.items() for point in (1, 2)) / 4
                 for k in (0, 1, 2, 5, 4, 3)]
        for value, mean in zip(map(float, lines[2].split()[1:]), means, strict=True):
            self.assertAlmostEqual(value / mean, 1, 4)
        self.assertEqual(printed("stiffness", data)[0], 2)
        data.write_text("")
        self.expect_line("stiffness", (data, "--mean"), "job.dat: it does not hold the stresses and volumes of each step")

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

    def test_results_of_an_earlier_job_are_refused(self):
        job, data, n = self.stiffness()
        out = self.path("out.svg")
        for name, arguments in (("stiffness", (data,)), ("stress_picture", (job, data, "1", out))):
            self.assertEqual(sample(name, *arguments), (0, ""))
            self.set_age("job.dat", 60)
            self.expect_line(name, arguments, r"job\.dat: it is older than \S*/job\.inp", r"run ccx job again, or .* touch \S*job\.dat")
            self.set_age("job.dat", 0)
            self.assertEqual(sample(name, *arguments), (0, ""))
        # The elements of another mesh have the same numbers.
        rows = re.findall(r"^\d+,\d+,\d+,\d+$", job.read_text(), re.M)[:2]
        swapped = [f"{rows[k].split(',')[0]},{rows[1 - k].split(',', 1)[1]}" for k in (0, 1)]
        job.write_text(job.read_text().replace("\n".join(rows), "\n".join(swapped)))
        self.assertEqual(len(areas_of(job.read_text())), n)
        self.set_age("job.dat", -LONG)
        for name, arguments in (("stiffness", (data,)), ("stress_picture", (job, data, "1", out))):
            self.expect_line(name, arguments, r"job\.dat: element 1 has the volume \S+, and in \S*job\.inp \S+, so ccx ran on another",
                             "run ccx job again")

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

    def test_numbers_that_cannot_be_printed_are_reported(self):
        _, data, _ = self.stiffness()
        with open("/dev/full", "wb") as full:
            done = subprocess.run([SAMPLES / "stiffness", data], stdout=full, stderr=subprocess.PIPE, text=True, check=False)
        self.assertEqual((done.returncode, done.stderr.count("\n")), (3, 1), done.stderr)
        self.assertRegex(done.stderr, "^standard output: cannot write: No space left on device; ")

    def test_damaged_files_are_refused_in_one_line(self):
        job, data, _ = self.stiffness()
        self.damage(random.Random(3), "stiffness", (data,), (job, data))


if __name__ == "__main__":
    main()
