"""pcvt mesh and pcvt check in three dimensions: formats, proofs, refusals."""

import json
import random
import re
import signal
import subprocess
import time

from support.cli import CliTest, main

LATTICES = {
    "cube": ("--period", "1,1,1"),
    "thin": ("--period", "1,0.01,0.3"),
    "huge": ("--period", "1e6,2e6,1e6"),
    "oblique": ("--lattice", "1,0,0,0.37,0.81,0,0.2,0.4,0.9"),
    "left-handed": ("--lattice", "1,0,0,0,0,1.1,0.3,0.8,0"),
    "skewed": ("--lattice", "1,0,0,7,1,0,-3,5,1"),
}
CUBE = LATTICES["cube"]


def figures(summary):
    """The values of a summary by their labels."""
    return dict(line.split(maxsplit=1) for line in summary.splitlines())


class Runs(CliTest):
    def test_small_numbers_of_sites_on_every_lattice(self):
        for name, lattice in LATTICES.items():
            for n in range(1, 9):
                with self.subTest((name, n)):
                    self.succeed("mesh", "--sites", n, *lattice, "--seed", n, "--force", "-o", "t.vtu", "-o", "t.foam",
                                 "-o", "t.txt")
                    lines = self.succeed("check", "t.vtu", "t.foam", "--cvt").splitlines()
                    cells = "1 cell," if n == 1 else f"{n} cells,"
                    for path, line in zip(("t.vtu", "t.foam"), lines):
                        self.assertTrue(line.startswith(f"{path}: a periodic tile of polyhedra: {cells}"), line)

    def test_the_summary_has_the_figures_of_the_run(self):
        found = figures(self.succeed("mesh", "--sites", 54, *CUBE, "--start", "lattice", "-o", "t.vtu"))
        self.assertEqual(found["sites"], "54")
        self.assertEqual(found["lattice"], "(1, 0, 0) (0, 1, 0) (0, 0, 1)")
        self.assertRegex(found["stop"], r"^converged after 0 iterations, 1 evaluation$")
        self.assertRegex(found["energy"], r"^0\.0164931, 1 of truncated octahedra$")
        self.assertEqual(found["faces"], "14 a cell; cells with 14:54")
        self.assertEqual(found["file"], "t.vtu")

    def test_the_report_has_the_figures_of_the_run(self):
        found = figures(self.succeed("mesh", "--sites", 30, *LATTICES["oblique"], "--seed", 7, "--tolerance", "1e-4",
                                     "--threads", 1, "-o", "t.vtu", "-o", "t.obj", "--report", "r.json"))
        self.assertEqual(found["report"], "r.json")
        report = json.loads(self.path("r.json").read_text())
        self.assertEqual(list(report), [
            "version", "dimension", "sites", "lattice", "seed", "solver", "start", "stop", "iterations", "evaluations",
            "hessians", "cg_products", "energy", "energy_bound", "residual", "rms_residual", "minimum", "valences", "faces",
            "removed_edges", "volume", "boundary_pairs", "translations", "boundary_is_manifold", "mirrors", "threads", "seconds", "files"])
        self.assertEqual(report["lattice"], [[1, 0, 0], [0.37, 0.81, 0], [0.2, 0.4, 0.9]])
        self.assertEqual([report[key] for key in ("sites", "seed", "solver", "start", "stop", "threads", "files")],
                         [30, 7, "lbfgs", "random", "converged", 1, ["t.vtu", "t.obj", "t.mtl"]])
        self.assertEqual(sum(report["faces"].values()), 30)
        self.assertAlmostEqual(report["volume"], 0.81 * 0.9, 12)
        self.assertGreater(report["energy"], report["energy_bound"])
        self.assertLessEqual(report["residual"], 1e-4)
        self.assertLessEqual(report["rms_residual"], report["residual"])
        self.assertIn(f"in {report['boundary_pairs']} pairs by {report['translations']} translations", found["seam"])
        self.write("s.txt", "0.1 0.2 0.3\n")
        self.succeed("mesh", "--input", "s.txt", *CUBE, "--solver", "lloyd", "--quiet", "--report", "q.json")
        report = json.loads(self.path("q.json").read_text())
        self.assertEqual([report[key] for key in ("start", "solver", "files")], ["file", "lloyd", []])
        self.refuse(3, "r.json", "mesh", "--sites", 3, *CUBE, "--report", "r.json")
        self.refuse(2, "--report r.txt: not a .json file", "mesh", "--sites", 3, *CUBE, "--report", "r.txt")

    def test_many_sites_start_from_coarse_to_fine(self):
        def start_of(*words):
            self.succeed("mesh", *CUBE, "--quiet", "--force", "--report", "r.json", *words)
            return json.loads(self.path("r.json").read_text())["start"]

        self.assertEqual(start_of("--sites", 1000, "--max-iterations", 1), "coarse")
        self.assertEqual(start_of("--sites", 1000, "--max-iterations", 0), "random")
        self.assertEqual(start_of("--sites", 999, "--max-iterations", 1), "random")
        self.assertEqual(start_of("--sites", 50, "--start", "coarse"), "coarse")

    def test_random_sites_end_above_the_bound(self):
        found = figures(self.succeed("mesh", "--sites", 250, *CUBE, "--tolerance", "1e-4"))
        ratio = float(found["energy"].split()[1])
        self.assertGreater(ratio, 1)
        self.assertLess(ratio, 1.015)

    def test_the_same_job_gives_the_same_bytes(self):
        run = ("mesh", "--sites", 60, *LATTICES["oblique"], "--quiet", "-o", "t.vtu", "-o", "t.foam", "-o", "t.txt")
        self.succeed(*run, "--threads", 1)
        first = self.contents()
        self.succeed(*run, "--threads", 3, "--force")
        self.assertEqual(self.contents(), first)

    def test_sites_of_a_file_keep_their_order(self):
        drawn = random.Random(4)
        rows = [[drawn.uniform(-3, 3) for _ in range(3)] for _ in range(20)]
        self.write("s.txt", "".join("%r %r %r\n" % tuple(row) for row in rows))
        self.succeed("mesh", "--input", "s.txt", *CUBE, "--max-iterations", 0, "-o", "t.txt", "-o", "t.vtu")
        self.succeed("check", "t.vtu")
        lines = [line for line in self.path("t.txt").read_text().splitlines() if not line.startswith("#")]
        for row, line in zip(rows, lines, strict=True):
            for x, word in zip(row, line.split(), strict=True):
                self.assertTrue(0 <= float(word) < 1)
                self.assertAlmostEqual(x - float(word), round(x - float(word)), 12)

    def test_the_summary_counts_the_sites_outside_of_the_domain(self):
        self.write("s.txt", "0 0 0\n1 0.5 0.2\n1.4 0.7 0.1\n-0.3 0.8 0.6\n")
        run = ("mesh", "--max-iterations", 0, "--input")
        said = figures(self.succeed(*run, "s.txt", *CUBE))["sites"]
        self.assertEqual(said, "4; 2 of the file lie outside of the domain and count modulo the lattice")
        self.assertEqual(figures(self.succeed(*run, "s.txt", "--lattice", "2,0,0,0,1,0,-0.6,0,1"))["sites"], "4")
        self.write("far.txt", "0 0 0\n11 0.5 3\n14 0.7 2\n-3.3 8.2 0\n")
        said = figures(self.succeed(*run, "far.txt", *CUBE))["sites"]
        self.assertRegex(said, "^4; 3 of .* lattice: --period or --lattice may be wrong; the positions extend over 17.3 x 8.2 x 3, "
                               "which takes --period 17.3,8.2,3 or larger, in the same unit$")

    def test_sites_on_the_seam(self):
        corners = "0 0 0\n0.5 0 0\n0 0.5 0\n0 0 0.5\n0.25 0.25 0\n1 0.25 0.75\n"
        done = self.succeed("mesh", "--input", "-", *CUBE, "--max-iterations", 0, "-o", "t.vtu", "-o", "t.foam",
                            input=corners.encode())
        self.assertIn("iteration-limit", done)
        self.succeed("check", "t.vtu", "t.foam")

    def test_standard_input_and_quiet(self):
        self.assertEqual(self.succeed("mesh", "--input", "-", *CUBE, "--quiet", "-o", "t.txt",
                                      input=b"0.1 0.2 0.3\n"), "")

    def test_strict_reports_a_run_that_did_not_converge(self):
        done = self.run_pcvt("mesh", "--sites", 30, *CUBE, "--max-iterations", 2, "--strict", "--quiet", "-o", "t.txt")
        self.assertEqual(done.returncode, 5)
        self.assertIn(b"not converged (iteration-limit", done.stderr)
        self.assertIn("t.txt", self.contents())

    def test_stability_is_answered_on_request(self):
        run = ("mesh", *CUBE, "--report", "r.json", "--force")
        self.assertRegex(self.succeed(*run, "--sites", 40, "--stability"), r"\nminimum +yes\n")
        self.assertEqual(json.loads(self.path("r.json").read_text())["minimum"], "yes")
        self.assertNotIn("minimum", self.succeed(*run, "--sites", 40))
        self.assertIsNone(json.loads(self.path("r.json").read_text())["minimum"])
        self.assertRegex(self.succeed(*run, "--sites", 40, "--stability", "--max-iterations", 3),
                         r"\nminimum +not known: not converged\n")
        self.write("cubes.txt", "".join(f"{i / 2} {j / 2} {k / 2}\n" for i in (0, 1) for j in (0, 1) for k in (0, 1)))
        self.assertRegex(self.succeed("mesh", *CUBE, "--input", "cubes.txt", "--stability"), r"\nminimum +no\n")
        self.refuse(2, "--stability supports at most 2000 sites in space", *run, "--sites", 2001, "--stability")

    def test_short_edges_are_removed_and_stated(self):
        run = ("mesh", "--sites", 200, *CUBE, "--max-iterations", 0, "--force", "-o", "t.vtu", "-o", "t.foam",
               "--report", "r.json")
        self.assertNotIn("edges", figures(self.succeed(*run)))
        before = json.loads(self.path("r.json").read_text())
        found = figures(self.succeed(*run, "--short-edges", "0.02"))
        report = json.loads(self.path("r.json").read_text())
        self.assertEqual(found["edges"], f"{report['removed_edges']} under 0.02 h removed")
        self.assertEqual(before["removed_edges"], 0)
        self.assertGreater(report["removed_edges"], 20)
        self.assertAlmostEqual(report["volume"], 1, 12)
        for line in self.succeed("check", "t.vtu", "t.foam").splitlines():
            self.assertIn(", edges under 0.02 h removed, Voronoi cells of 200 sites within 0.0", line)
        # Without their statement the faces are not plane enough.
        case = self.path("t.foam/constant/polyMesh/boundary")
        case.write_text(case.read_text().replace("// pcvt short_edges 0.02\n", ""))
        self.refuse(2, "is not convex|off the plane", "check", "t.foam")
        grid = self.path("t.vtu").read_text()
        self.write("t.vtu", grid.replace('"ShortEdges" NumberOfTuples="1" format="ascii">\n0.02',
                                         '"ShortEdges" NumberOfTuples="1" format="ascii">\n0.2'))
        self.refuse(2, "the length of removed edges is not one number from 0 to 0.1", "check", "t.vtu")

    def test_short_edges_are_of_cells_and_short(self):
        run = ("mesh", "--sites", 20, *CUBE, "--short-edges")
        for name in ("t.obj", "t.ply", "t.glb", "t.om", "t.msh"):
            self.refuse(2, f"-o {name}: such files cannot say that short edges were removed; take .vtu or .foam",
                        *run, "0.01", "-o", name)
        self.refuse(2, "--short-edges 0.11: such edges are not short in space; take at most 0.1", *run, "0.11")
        self.refuse(2, "--short-edges", *run, "-1")
        self.assertEqual(self.contents(), {})

    def test_lloyd_lowers_the_energy(self):
        one, ten = (float(figures(self.succeed("mesh", "--sites", 40, *CUBE, "--solver", "lloyd",
                                               "--max-iterations", k))["energy"].split(",")[0]) for k in (1, 10))
        self.assertLess(ten, one)

    def test_ctrl_c_writes_nothing(self):
        process = subprocess.Popen([self.binary(), "mesh", "--sites", "100000", "--period", "1,1,1", "-o", "t.vtu"],
                                   cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        time.sleep(1)
        process.send_signal(signal.SIGINT)
        out, err = process.communicate(timeout=60)
        self.assertEqual((process.returncode, out, err), (130, b"", b"pcvt: cancelled; nothing was written\n"))
        self.assertEqual(self.contents(), {})


class Surfaces(CliTest):
    FILES = ("-o", "t.obj", "-o", "t.ply", "-o", "t.glb")

    def test_surfaces_of_cells_on_every_lattice(self):
        for name, words in LATTICES.items():
            with self.subTest(name):
                self.succeed("mesh", "--sites", 12, *words, "--force", "--quiet", *self.FILES)
                obj, ply, glb = self.succeed("check", "t.obj", "t.ply", "t.glb").splitlines()
                for path, line in (("t.obj", obj), ("t.ply", ply)):
                    self.assertRegex(line, rf"^{path}: a periodic tile of polyhedra: 12 cells, .*, Voronoi cells of 12 ")
                self.assertRegex(glb, r"^t\.glb: surfaces of a periodic tile of polyhedra: \d+ triangles in 12 parts, "
                                      r"each closed, volume ")
                self.succeed("check", "t.obj", "t.ply", "--cvt", "1e-5")

    def test_boundary_is_a_closed_surface(self):
        for name, words in LATTICES.items():
            with self.subTest(name):
                self.succeed("mesh", "--sites", 12, *words, "--seed", 3, "--force", "--quiet", "--surface", "boundary",
                             *self.FILES, "-o", "t.om")
                obj, ply, glb, om = self.succeed("check", "t.obj", "t.ply", "t.glb", "t.om").splitlines()
                for path, line in (("t.obj", obj), ("t.ply", ply), ("t.om", om)):
                    self.assertRegex(line, rf"^{path}: the boundary of a periodic tile of polyhedra: \d+ points, .*, a "
                                           "closed manifold in 1 part, Euler characteristic -?\\d+, volume ")
                self.assertIn("which close together", glb)

    def test_the_same_job_gives_the_same_bytes(self):
        self.succeed("mesh", "--sites", 40, *CUBE, "--quiet", *self.FILES, "--threads", 1)
        first = self.contents()
        self.assertEqual(set(first), {"t.obj", "t.mtl", "t.ply", "t.glb"})
        self.succeed("mesh", "--sites", 40, *CUBE, "--quiet", *self.FILES, "--threads", 3, "--force")
        self.assertEqual(self.contents(), first)

    def test_grains_are_proved_tetrahedra_in_cells(self):
        run = ("mesh", "--sites", 8, *CUBE, "--mesh", "grains")
        figures = []
        for size in (0.3, 0.15):
            self.succeed(*run, "--size", size, "-o", "t.msh", "-o", "t.vtu", "--report", "r.json", "--force")
            grains = json.loads(self.path("r.json").read_text())["grains"]
            checked = self.succeed("check", "t.msh", "t.vtu")
            self.assertEqual(checked.count(f"tetrahedra: {grains['tetrahedra']} in 8 cells"), 2)
            self.assertGreater(grains["smallest_angle"], 18)
            figures.append(grains["tetrahedra"])
        self.assertGreater(figures[1], figures[0])
        for name in ("t.msh", "t.vtu"):
            text = self.path(name).read_text()
            # The first tetrahedron of the last cell is taken for one of another cell.
            head, mark, tail = text.partition("<CellData>" if name == "t.vtu" else "$ElementData")
            changed = re.sub(r"([ \n])7\n", r"\g<1>6\n", tail, count=1)
            self.assertNotEqual(tail, changed)
            self.write(name, head + mark + changed)
            self.refuse(2, rf"^{name}:\d+: ", "check", name)
        # Power cells, removed edges, phases and orientations.
        self.succeed(*run, "--volumes", "lognormal:0.3", "--phases", "A:0.5,B:0.5", "--orientations", "random",
                     "-o", "p.vtu", "-o", "p.csv", "-o", "p.msh", "-o", "p.inp")
        self.succeed(*run, "--short-edges", 0.05, "-o", "s.msh")
        self.succeed("check", "p.vtu", "p.msh", "p.inp", "s.msh")
        self.assertIn('"phase_A"', self.path("p.msh").read_text())
        self.assertIn("*ORIENTATION,NAME=ORI_7", self.path("p.inp").read_text())
        self.refuse(2, "^pcvt: Delaunay tetrahedra are not cells, which phases and orientations belong to; take --mesh grains",
                    "mesh", "--sites", 8, *CUBE, "--mesh", "delaunay", "--phases", "A:0.5,B:0.5", "-o", "q.vtu")
        self.refuse(4, "^pcvt: grains of that size are more than pcvt holds", *run, "--size", 1e-4, "-o", "q.msh")

    def test_damage_is_found(self):
        self.succeed("mesh", "--sites", 8, *CUBE, "--quiet", *self.FILES)
        for path, piece, other in (("t.obj", "g cell_5\n", "g cell_6\n"), ("t.mtl", "Kd ", "Kd 0"),
                                   ("t.obj", "pcvt site 0", "pcvt site 1"), ("t.ply", "property int cell", "property int sell")):
            with self.subTest((path, piece)):
                text = self.path(path).read_text()
                self.write(path, text.replace(piece, other, 1))
                checked = "t.obj" if path == "t.mtl" else path
                self.refuse(2, r"write the file again|not|halfway", "check", checked)
                self.write(path, text)
        self.succeed("check", "t.obj", "t.ply")

    def test_refusals(self):
        run = ("mesh", "--sites", 8, *CUBE, "-o", "t.vtu")
        self.refuse(2, r"^pcvt: --surface is for \.obj, \.ply, \.glb or \.stl; add such a file with -o$", *run, "--surface", "cells")
        self.refuse(2, r"--surface boundry: unknown; did you mean boundary\?", *run, "-o", "t.obj", "--surface", "boundry")
        self.refuse(2, r"^pcvt: --surface is for three dimensions", "mesh", "--sites", 8, "-o", "t.obj", "--surface", "cells")
        self.succeed("mesh", "--sites", 8, *CUBE, "--quiet", "--surface", "boundary", *self.FILES)
        for path in ("t.obj", "t.ply", "t.glb"):
            self.refuse(2, rf"^{path}: --cvt needs cells", "check", path, "--cvt")


class Tetrahedra(CliTest):
    def test_file_is_proved_and_checked(self):
        for name, words in LATTICES.items():
            self.succeed("mesh", "--sites", 20, *words, "-o", f"{name}.msh")
            out = self.succeed("check", f"{name}.msh")
            self.assertRegex(out, rf"^{name}\.msh: a periodic tile of tetrahedra: \d+ of 20 sites, .* in \d+ pairs, "
                                  r"periodic within 0 \(tolerance \S+\), Euler characteristic 0 after gluing, volume ")

    def test_vtu_is_proved_and_checked(self):
        for name, words in LATTICES.items():
            self.succeed("mesh", "--sites", 20, *words, "--mesh", "delaunay", "-o", f"{name}.vtu", "-o", f"{name}.msh")
            of_vtu, of_msh = (self.succeed("check", f"{name}.{extension}").split(": ", 1)[1]
                              for extension in ("vtu", "msh"))
            self.assertEqual(of_vtu, of_msh)

    def test_damaged_vtu_is_found(self):
        self.succeed("mesh", "--sites", 20, *CUBE, "--mesh", "delaunay", "-o", "t.vtu")
        text = self.path("t.vtu").read_text()
        self.write("t.vtu", text.replace('"types" format="ascii">\n10\n', '"types" format="ascii">\n12\n'))
        self.refuse(2, r"^t\.vtu:\d+: the cells are not all tetrahedra", "check", "t.vtu")
        self.write("t.vtu", text.replace("<!--", "<!-- Written again.", 1))
        self.succeed("check", "t.vtu")
        # The first site is taken for another one.
        self.write("t.vtu", text.replace('"CellId" format="ascii">\n0\n', '"CellId" format="ascii">\n1\n', 1))
        self.assertNotEqual(text, self.path("t.vtu").read_text())
        self.refuse(2, r"^t\.vtu:\d+: point 1 is point 1 moved by", "check", "t.vtu")

    def test_mesh_names_what_the_files_hold(self):
        run = ("mesh", "--sites", 8, *CUBE)
        self.refuse(2, r"^pcvt: -o t\.foam: the format holds no Delaunay tetrahedra; take \.msh, \.inp or \.vtu, or write the cells in a "
                       "run of their own$", *run, "--mesh", "delaunay", "-o", "t.vtu", "-o", "t.foam")
        self.refuse(2, r"^pcvt: -o t\.msh: the format holds the tetrahedra of --mesh delaunay; leave --mesh out$",
                    *run, "--mesh", "voronoi", "-o", "t.msh")
        self.refuse(2, r"^pcvt: -o t\.obj: the format holds no tetrahedra; take \.msh, \.inp, \.vtu or \.foam", *run, "--mesh", "grains",
                    "-o", "t.obj")
        self.refuse(2, "^pcvt: --mesh: one mesh a run in three dimensions; remove one$", *run, "--mesh", "voronoi",
                    "--mesh", "delaunay", "-o", "t.vtu")
        self.succeed(*run, "--mesh", "voronoi", "-o", "t.vtu", "-o", "t.obj")

    def test_jobs_and_order_2_are_written_and_checked(self):
        run = ("mesh", "--sites", 2, *CUBE, "--mesh", "grains", "--phases", "A:0.5,B:0.5", "--size", 0.5, "--force")
        files = ("t.inp", "t.msh", "t.vtu")
        for order in (1, 2):
            out = self.succeed(*run, "--order", order, "--job", "elastic", "--material", "A:200,0.3", "--material", "B:10,0.4",
                               *(word for name in files for word in ("-o", name)))
            self.assertIn("material   A: E 200, nu 0.3\n", out)
            for line in self.succeed("check", *files).splitlines():
                self.assertEqual(" of order 2, " in line, order == 2, line)
            text = self.path("t.inp").read_text()
            self.assertEqual(re.findall(r"TYPE=(C3D\d+)", text), ["C3D4" if order == 1 else "C3D10"])
            self.assertEqual((text.count("*STEP"), text.count("*SURFACE,NAME=PHASE_")), (6, 2))
        for old, new in (("*SURFACE,NAME=PHASE_A_TO_B,TYPE=ELEMENT\n", "*SURFACE,NAME=PHASE_A_TO_B,TYPE=ELEMENT\n1,S1\n1,S1\n"),
                         ("*NSET,NSET=TRIPLE_LINES\n", "*NSET,NSET=TRIPLE_LINES\n43,\n"),
                         ("\n*ELSET,ELSET=PHASE_A", "\n5\n*ELSET,ELSET=PHASE_A"), ("MATERIAL=A\n", "MATERIAL=B\n"),
                         ("** pcvt site_phases 1 0", "** pcvt site_phases 0 1"), ("** pcvt lattice 1 ", "** pcvt lattice 2 ")):
            with self.subTest(old):
                self.assertTrue(old in text)
                self.write("t.inp", text.replace(old, new, 1))
                self.refuse(2, r"^t\.inp:(\d+:)? ", "check", "t.inp")
        self.refuse(2, "--job elastic would give the phases A, B the same elastic constants", *run, "--job", "elastic",
                    "-o", "t.inp")
        self.refuse(2, r"no output takes a job of a solver; add one of \.inp", *run, "--job", "elastic", "-o", "t.vtu")
        self.refuse(2, r"no output holds the mid-side nodes of order 2; add one of \.msh, \.inp, \.vtu", *run, "--order", 2,
                    "-o", "t.csv")

    def test_damage_is_found(self):
        self.succeed("mesh", "--sites", 20, *CUBE, "-o", "t.msh")
        text = self.path("t.msh").read_text()
        self.write("t.msh", text.replace('"seam_0_0_1"', '"seam_0_0_2"'))
        self.refuse(2, r"^t\.msh:\d+: .*seam_0_0_", "check", "t.msh")

    def test_flat_tetrahedra_are_refused(self):
        self.refuse(2, r"^pcvt: -o t\.msh: \d+ tetrahedra of these sites are flat, the first that of sites \d+, .* on a sphere; "
                    r"move the sites a little, or leave t\.msh out$",
                    "mesh", "--sites", 38, *CUBE, "--start", "lattice", "-o", "t.vtu", "-o", "t.msh")

    def test_cells_are_not_there(self):
        self.succeed("mesh", "--sites", 20, *CUBE, "-o", "t.msh")
        self.refuse(2, r"^t\.msh: --cvt needs cells, and the file holds tetrahedra; check a \.vtu$",
                    "check", "t.msh", "--cvt", "1e-3")


class Boxes(CliTest):
    """--outline box."""

    FILES = ("t.vtu", "t.foam", "t.obj", "t.ply", "t.glb")

    def run_box(self, *words, files=FILES):
        outputs = [word for path in files for word in ("-o", path)]
        text = self.succeed("mesh", *words, "--outline", "box", "--tolerance", "1e-3", "--force", *outputs)
        return figures(text)["box"], self.succeed("check", *files).splitlines()

    def test_small_numbers_of_sites_on_every_lattice(self):
        for k, (name, lattice) in enumerate(LATTICES.items()):
            for n in (1, 2 + k):
                with self.subTest((name, n)):
                    box, lines = self.run_box("--sites", n, *lattice, "--seed", n)
                    pieces = box.split(" of cells")[0]
                    for line in lines[:4]:
                        self.assertIn(f"polyhedra: {pieces} of {n} cell", line)
                        self.assertRegex(line, r"by 3 translations, .* boundary a manifold, .* a box at \(0, 0, 0\)")

    def test_power_cells_and_elongated_cells(self):
        for words, files in ((("--volumes", "lognormal:0.4", "--phases", "a:0.5,b:0.5", "--orientations", "random"), self.FILES),
                             (("--short-edges", "0.05", "--origin", "0.2,0.3,-7"), ("t.vtu", "t.foam")),
                             (("--aspect", "3,1,1,0", "--origin", "0.2,0.3,-7"), ("t.vtu",)),
                             (("--repeat", "2x1x1"), self.FILES), (("--surface", "boundary"), ("t.ply", "t.obj", "t.glb", "t.om"))):
            with self.subTest(words):
                self.run_box("--sites", 12, *CUBE, *words, files=files)

    def test_a_box_that_cuts_no_cell_holds_whole_ones(self):
        self.write("s.txt", "0.1 0.2 0.3\n0.6 0.2 0.3\n")
        slabs = ("--input", "s.txt", *CUBE, "--max-iterations", 0, "--origin", "0.35,0.7,-1.2")
        for words, files in ((("--phases", "a:0.5,b:0.5"), self.FILES), (("--volumes", "equal"), self.FILES),
                             (("--short-edges", "0.1"), ("t.vtu", "t.foam"))):
            with self.subTest(words):
                box, lines = self.run_box(*slabs, *words, files=files)
                self.assertEqual(box, "2 pieces of cells, --origin 0.35,0.7,-1.2")
                for line in lines[:2]:
                    self.assertRegex(line, r"polyhedra: 2 cells, .* by 3 translations, .* a box at \(0\.35, 0\.7, -1\.2\)")

    def test_angles_are_those_at_sharp_places_where_there_are_no_others(self):
        text = self.succeed("mesh", "--sites", 1, "--period", "0.1,1,5", "--mesh", "grains", "-o", "t.vtu", "--report", "r.json")
        self.assertRegex(figures(text)["grains"], r"^\d+ tetrahedra on \d+ points, each beside a sharp place; dihedral angles from [\d.]+ at 2 sharp places of "
                                                  r"the cells \(corners, edges, narrow faces, flat cells\), the sharpest of [\d.]+ degrees$")
        grains = json.loads(self.path("r.json").read_text())["grains"]
        self.assertEqual((grains["smallest_angle"], grains["largest_angle"]), (None, None))
        self.assertGreater(grains["smallest_angle_at_them"], 0)

    def test_volumes_and_centroids_are_those_of_the_cells(self):
        self.succeed("mesh", "--sites", 20, *CUBE, "--volumes", "lognormal:0.4", "--outline", "box", "-o", "t.vtu", "-o", "t.csv")
        self.assertIn("volumes of 20 cells within", self.succeed("check", "t.vtu", "--volumes", "t.csv:volume"))
        self.succeed("mesh", "--sites", 20, *CUBE, "--outline", "box", "-o", "c.vtu")
        self.succeed("check", "c.vtu", "--cvt", "1e-5")

    def test_the_chosen_origin_is_stated_and_gives_the_same_box(self):
        words = ("mesh", "--sites", 12, *CUBE, "--mesh", "grains", "--size", "0.3", "--outline", "box", "--tolerance", "1e-3")
        found = figures(self.succeed(*words, "--origin", "auto", "-o", "a.vtu", "--report", "r.json"))
        origin = found["box"].split("chosen --origin ")[1]
        report = json.loads(self.path("r.json").read_text())
        self.assertEqual(report["box"]["origin"], [float(x) for x in origin.split(",")])
        self.succeed(*words, "--origin", origin, "-o", "b.vtu", "-o", "b.msh")
        self.assertEqual(self.path("a.vtu").read_bytes(), self.path("b.vtu").read_bytes())
        self.assertRegex(self.succeed("check", "b.vtu", "b.msh"), r"in 12 cells on .* a box at .*\n.*in 12 cells on .* a box at ")

    def test_a_job_of_a_box_names_its_sides_edges_and_corners_in_the_order_of_partners(self):
        grains = ("mesh", "--sites", 4, *CUBE, "--max-iterations", 0, "--mesh", "grains", "--size", "0.4", "--outline", "box")
        self.succeed(*grains, "--phases", "a:0.5,b:0.5", "--material", "same", "--job", "elastic", "-o", "t.inp", "-o", "t.vtu")
        self.succeed("check", "t.inp", "t.vtu")
        text = self.path("t.inp").read_text()
        names = re.findall(r"^\*NSET,NSET=(side|edge|corner)_\S+,UNSORTED$", text, re.M)
        self.assertEqual([names.count(kind) for kind in ("side", "edge", "corner")], [6, 12, 8])
        turned = re.sub(r"(NSET=side_1_0_0,UNSORTED\n)(\d+),(\d+)", r"\1\3,\2", text)
        self.assertNotEqual(turned, text)
        self.write("turned.inp", turned)
        self.refuse(2, r"^turned\.inp:\d+: ", "check", "turned.inp")

    def test_a_moved_point_of_a_side_is_refuted(self):
        self.succeed("mesh", "--sites", 5, *CUBE, "--outline", "box", "-o", "t.obj")
        text = self.path("t.obj").read_text()
        self.path("t.obj").write_text(text.replace("\nv 0 0 0\n", "\nv 0 0 0.001\n"))
        self.refuse(2, r"^t\.obj: not a periodic tile of polyhedra: law \(3\), seam: ", "check", "t.obj")

    def test_delaunay_tetrahedra_are_not_cut(self):
        box = ("mesh", "--sites", 8, *CUBE, "--outline", "box")
        self.refuse(2, r"^pcvt: -o t\.msh: --outline box cannot cut Delaunay tetrahedra; add --mesh grains, or leave the outline out$",
                    *box, "-o", "t.msh")
        self.refuse(2, r"^pcvt: -o t\.vtu: --outline box cannot cut Delaunay tetrahedra; add --mesh grains, or leave the outline out$",
                    *box, "--mesh", "delaunay", "-o", "t.vtu")
        self.refuse(2, r"^pcvt: --origin auto is for --outline box; add it, or give X,Y,Z$",
                    "mesh", "--sites", 8, *CUBE, "--origin", "auto", "-o", "t.vtu")


class Refusals(CliTest):
    def test_options_of_the_plane(self):
        for words in (("--density", "1"), ("--symmetry", "p4"),
                      ("--areas", "lognormal:0.3"), ("--walls", "x"), ("--budget", "5"),
                      ("--float32",)):
            self.refuse(2, rf"^pcvt: {words[0]} is not for three dimensions; leave it out, or give two period vectors$",
                        "mesh", "--sites", 8, *CUBE, *words)

    def test_choices_of_the_plane(self):
        self.refuse(2, "^pcvt: --start best: not for three dimensions; take random, coarse or lattice$",
                    "mesh", "--sites", 8, *CUBE, "--start", "best")
        self.refuse(2, "^pcvt: --solver newton: not for three dimensions; take lbfgs or lloyd$",
                    "mesh", "--sites", 8, *CUBE, "--solver", "newton")

    def test_formats_without_volumes(self):
        for extension in ("nc", "dxf", "html"):
            self.refuse(2, rf"^pcvt: -o t\.{extension}: \.{extension} does not support three dimensions; take \.obj, \.ply, \.glb, \.om, \.stl, "
                           r"\.msh, \.inp, \.vtu, \.svg, \.png, \.foam, \.vti, \.csv or \.txt",
                        "mesh", "--sites", 8, *CUBE, "-o", f"t.{extension}")

    def test_an_unknown_extension_is_called_unknown(self):
        for name, words in (("t.unknown", "unknown extension .unknown"), ("t", "no extension")):
            self.refuse(2, rf"^pcvt: -o {re.escape(name)}: {re.escape(words)}; take one of \.obj, \.ply, .* or \.txt$",
                        "mesh", "--sites", 8, *CUBE, "-o", name)

    def test_period_vectors(self):
        for words, pattern in (
                (("--period", "1,1,0"), "--period 1,1,0: a side is not above 0"),
                (("--period", "1,x,1"), "--period 1,x,1: 'x' is not a number"),
                (("--lattice", "1,0,0,0,1,0,1,1,0"), "--lattice 1,0,0,0,1,0,1,1,0: "),
                ((*CUBE, *LATTICES["oblique"]), "exclude each other"),
        ):
            self.refuse(2, pattern, "mesh", "--sites", 8, *words)

    def test_sites(self):
        self.write("flat.txt", "1 2\n")
        self.write("twice.txt", "0 0 0\n0.5 0.5 0.5\n1 0 -2\n")
        self.refuse(2, r"^flat\.txt:1: a site in space has 3 coordinates", "mesh", "--input", "flat.txt", *CUBE)
        self.refuse(2, r"^twice\.txt:3: the site coincides with the site of line 1", "mesh", "--input", "twice.txt",
                    *CUBE)
        self.refuse(2, "no sites", "mesh", *CUBE)
        self.refuse(2, "--seed is for random sites", "mesh", "--input", "twice.txt", *CUBE, "--seed", 1)
        self.refuse(4, "too large", "mesh", "--sites", 10**9, *CUBE)

    def test_outputs_that_exist(self):
        run = ("mesh", "--sites", 8, *CUBE, "-o", "t.vtu", "-o", "t.foam")
        self.succeed(*run)
        self.refuse(3, r"^pcvt: t\.vtu: cannot write: it exists; use --force to replace it$", *run, "--seed", 1)
        self.refuse(2, "t.vtu", "mesh", "--sites", 8, *CUBE, "-o", "t.vtu", "-o", "./t.vtu", "--force")
        self.succeed(*run, "--seed", 1, "--force")
        self.succeed("check", "t.vtu", "t.foam/")


class Checks(CliTest):
    def setUp(self):
        super().setUp()
        self.succeed("mesh", "--sites", 12, *LATTICES["oblique"], "--tolerance", "1e-3", "-o", "t.vtu", "-o", "t.foam")

    def change(self, name, pattern, other):
        text, n = re.subn(pattern, other, self.path(name).read_text(), count=1)
        self.assertEqual(n, 1, (name, pattern))
        self.path(name).write_text(text)

    def test_cvt_is_refuted_where_sites_are_off_the_centroids(self):
        self.refuse(2, r"^t\.vtu: not a periodic tile of polyhedra: a site lies \S+ h off the centroid of its cell",
                    "check", "--cvt", "1e-9", "t.vtu")

    def test_damaged_files_are_refuted(self):
        self.change("t.vtu", r'(Name="Volume".*\n)\S+', r"\g<1>0.5")
        self.refuse(2, r"^t\.vtu:\d+: cell 0 has another volume", "check", "t.vtu")
        self.change("t.foam/constant/polyMesh/boundary", r"nFaces          (\d+)", r"nFaces          1\1")
        self.refuse(2, r"^t\.foam/constant/polyMesh/boundary:\d+: patch 'seam_\S+' has not its faces from \d+ on; ", "check", "t.foam")

    def test_a_cut_file_is_refuted(self):
        text = self.path("t.vtu").read_text()
        for share in (0.1, 0.5, 0.9, 0.99):
            self.path("t.vtu").write_text(text[:int(share * len(text))])
            self.assertEqual(self.run_pcvt("check", "t.vtu").returncode, 2)

    def test_options_of_the_plane_are_refused(self):
        for words in (("--lattice", "1,0,0,1"), ("--period", "1,1"), ("--cvt", "1e-3", "--density", "1")):
            self.refuse(2, r"^t\.vtu: holds a tile in space, which states its lattice", "check", "t.vtu", *words)


if __name__ == "__main__":
    main()
