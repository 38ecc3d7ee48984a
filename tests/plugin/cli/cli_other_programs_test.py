"""Files of other programs: pcvt check with a tolerance of their sides, and arrays of earlier versions."""

import re

from support.cli import CliTest, main, outputs

OBLIQUE = ("--lattice", "1,0,0.5,0.8660254037844386")


def rounded(text, digits, rows):
    """Rounds the real numbers of the lines that `rows` matches."""
    def shorter(line):
        return re.sub(r"-?\d+\.\d+(e-?\d+)?", lambda word: f"{float(word[0]):.{digits}f}", line[0])
    return re.sub(rf"(?m)^{rows}.*$", shorter, text)


class OtherPrograms(CliTest):
    def mesh(self, *arguments):
        self.succeed("mesh", "--tolerance", "1e-3", "--force", "--quiet", *arguments)

    def write_rounded(self, digits=6):
        """Writes an OBJ with only vertices and faces, as other programs do."""
        self.mesh("--sites", 30, *OBLIQUE, "-o", "t.obj")
        lines = [re.sub(r"/\d+", "", line) for line in self.path("t.obj").read_text().splitlines()
                 if line.startswith(("v ", "f "))]
        self.write("other.obj", rounded("\n".join(lines) + "\n", digits, "v"))

    def test_a_refusal_states_the_mismatch_and_the_tolerance_that_suffices(self):
        for digits in (5, 6, 9):
            self.write_rounded(digits)
            done = self.run_pcvt("check", *OBLIQUE, "other.obj")
            line = done.stderr.decode()
            self.assertEqual((done.returncode, line.count("\n")), (2, 1))
            found = re.search(r"law \(2\), seam: .*off by \S+; the tile is periodic within (\S+), so --tolerance (\S+) "
                              r"accepts it$", line.strip())
            self.assertTrue(found, line)
            mismatch, tolerance = map(float, found.groups())
            self.assertLess(10**-digits / 10, mismatch)
            self.assertLess(mismatch, tolerance)
            self.assertLess(tolerance, 4 * 10**-digits)
            line = self.succeed("check", *OBLIQUE, "--tolerance", found[2], "other.obj")
            self.assertIn(f", periodic within {found[1]}, genus 1", line)
            self.assertIn(f"(tolerance {found[2]})", line)
            self.refuse(2, "law", "check", *OBLIQUE, "--tolerance", repr(mismatch / 3), "other.obj")

    def test_a_tolerance_does_not_hide_a_hole_or_a_moved_vertex(self):
        self.write_rounded()
        text = self.path("other.obj").read_text()
        self.write("other.obj", text[:text.rindex("f ")])
        self.refuse(2, "law", "check", *OBLIQUE, "--tolerance", "2e-6", "other.obj")
        self.write_rounded()
        self.write("other.obj", re.sub(r"v (\S+)", "v 0.4321", self.path("other.obj").read_text(), count=1))
        self.refuse(2, "law", "check", *OBLIQUE, "--tolerance", "2e-6", "other.obj")

    def test_a_tolerance_as_large_as_a_period_is_refused(self):
        self.write_rounded()
        self.refuse(2, "tolerance of positions, 0.5, .* not small against the shortest period", "check", *OBLIQUE,
                    "--tolerance", "0.5", "other.obj")
        for wrong in ("0", "-1", "x", "nan"):
            self.refuse(2, f"--tolerance {wrong}: ", "check", *OBLIQUE, "--tolerance", wrong, "other.obj")

    def test_files_of_pcvt_are_periodic_to_the_last_digits(self):
        self.mesh("--sites", 30, *OBLIQUE, "--origin", "0.3,0.2", *outputs("obj", "vtu", "glb"))
        for line in self.succeed("check", "t.obj", "t.vtu", "t.glb").splitlines():
            mismatch, tolerance = map(float, re.search(r"periodic within (\S+), .*\(tolerance (\S+)\)", line).groups())
            self.assertLessEqual(mismatch, 4 * tolerance)
        self.mesh("--sites", 30, "--walls", "xy", "-o", "box.obj")
        self.assertNotIn("periodic within", self.succeed("check", "box.obj"))

    def test_tiles_in_space_have_a_tolerance_too(self):
        for mesh, kind in (("voronoi", "polyhedra"), ("delaunay", "tetrahedra")):
            self.mesh("--sites", 12, "--lattice", "1,0,0,0.31415926535898,0.9,0,0.27182818284590,0.4,0.8",
                      "--mesh", mesh, "-o", "t.vtu")
            self.assertRegex(self.succeed("check", "t.vtu"), rf"of {kind}: .*periodic within \S+ \(tolerance \S+\)")
            head, points, rest = re.split(r"(<Points>.*?</Points>)", self.path("t.vtu").read_text(), flags=re.S)
            text = head + rounded(points, 10, r"[-\d]") + rest
            self.write("other.vtu", text.replace("written by pcvt", "written by another program"))
            done = self.run_pcvt("check", "other.vtu")
            found = re.search(r"periodic within (\S+), so --tolerance (\S+) accepts it$", done.stderr.decode().strip())
            self.assertTrue(found, done.stderr)
            self.assertLess(float(found[2]), 1e-9)
            self.assertIn(f"(tolerance {found[2]})", self.succeed("check", "--tolerance", found[2], "other.vtu"))
        self.mesh("--sites", 12, "--period", "1,1,1", "--surface", "boundary", "-o", "b.obj")
        self.refuse(2, "--tolerance is for cells and tetrahedra", "check", "--tolerance", "1e-9", "b.obj")

    def test_grids_and_voxels_take_no_tolerance(self):
        self.mesh("--sites", 30, "--retry", 40, "-o", "t.nc", "-o", "t.vti", "--voxels", "8,8")
        for name in ("t.nc", "t.vti"):
            self.refuse(2, "--tolerance is not for", "check", "--tolerance", "1e-9", name)

    def test_names_in_string_arrays_are_read(self):
        self.mesh("--sites", 30, "--phases", "soft:0.7,2nd:0.3", "-o", "t.vtu")
        text = self.path("t.vtu").read_text()
        self.assertIn('type="UInt8" Name="PhaseNames" NumberOfTuples="9"', text)
        self.write("old.vtu", text.replace('type="UInt8" Name="PhaseNames" NumberOfTuples="9"',
                                           'type="String" Name="PhaseNames" NumberOfTuples="2"'))
        self.succeed("check", "t.vtu", "old.vtu")


if __name__ == "__main__":
    main()
