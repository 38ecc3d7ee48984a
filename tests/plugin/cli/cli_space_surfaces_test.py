"""`.stl` files of cells and grains in space, and OpenFOAM cases of the tetrahedra inside of grains."""

import re

from support.cli import CliTest, main, outputs

CUBE = ("mesh", "--sites", 5, "--period", "1,1,1", "--tolerance", "1e-2")
GRAINS = (*CUBE, "--mesh", "grains")
BOX = ("--outline", "box")
PHASES = ("--phases", "a:0.5,b:0.5")


class SpaceSurfaces(CliTest):
    def surfaces(self, *words):
        """Writes an STL. Returns the numbers of its triangles and surfaces."""
        said = self.succeed(*words, "-o", "t.stl", "--force")
        self.assertIn("t.stl\n           STL states no unit and no cells; lengths are those of --period, rounded to 32 bits\n", said)
        proof = self.succeed("check", "t.stl")
        found = re.match(r"t\.stl: closed surfaces of triangles: (\d+) triangles in (\d+) surfaces?, each closed and oriented "
                         r"outwards, volume 1, that of the periods in its header \(tolerance \S+\), translations by which map the boundary "
                         r"onto itself; not proved, because STL does not hold them: unit, cells\n", proof)
        self.assertEqual(self.path("t.stl").stat().st_size, 84 + 50 * int(found[1]))
        return int(found[1]), int(found[2])

    def test_stl_has_a_closed_surface_of_each_cell_or_piece(self):
        n_triangles, n_surfaces = self.surfaces(*CUBE)
        self.assertEqual(n_surfaces, 5)
        self.assertGreater(n_triangles, 5 * 14)
        n_pieces = self.surfaces(*CUBE, *BOX)[1]
        self.assertGreater(n_pieces, 5)
        self.assertEqual(self.surfaces(*CUBE, *BOX, "--surface", "boundary")[1], 1)
        n_of_grains, n_surfaces = self.surfaces(*GRAINS)
        self.assertEqual(n_surfaces, 5)
        self.assertGreater(n_of_grains, 3 * n_triangles)
        self.assertEqual(self.surfaces(*GRAINS, *BOX)[1], n_pieces)
        self.assertEqual(self.surfaces(*GRAINS, "--surface", "boundary")[1], 1)

    def test_stl_takes_cells_that_state_nothing(self):
        self.surfaces(*CUBE, "--short-edges", 0.05)
        self.surfaces(*CUBE, "--volumes", "lognormal:0.3")
        self.surfaces(*CUBE, "--aspect", 2)

    def test_header_states_the_periods_where_they_fit(self):
        long = ("--lattice", "1.0123456789,0,0,0.3123456789,1,0,0.21234567891,-0.4123456789,0.9")
        self.succeed("mesh", "--sites", 5, *long, "-o", "t.stl", "--quiet")
        self.assertTrue(self.path("t.stl").read_bytes().startswith(b"pcvt cells   "))
        self.assertRegex(self.succeed("check", "t.stl"), r", volume 0\.91\d+ \(tolerance")

    def test_foam_of_grains_is_a_case_of_tetrahedra(self):
        for outline in ((), BOX):
            said = self.succeed(*GRAINS, *PHASES, *outline, "-o", "t.foam", "-o", "t.vtu", "--force")
            n = re.search(r"grains +(\d+) tetrahedra", said)[1]
            first, second = self.succeed("check", "t.foam", "t.vtu").splitlines()
            self.assertEqual(first[len("t.foam"):], second[len("t.vtu"):])
            self.assertIn(f": {n} in 5 cells on ", first)
            zones = self.path("t.foam/constant/polyMesh/cellZones").read_text()
            names = re.findall(r"^((?:cell|phase)_\w+)$", zones, re.M)
            self.assertEqual(names, [*(f"cell_{s}" for s in range(5)), "phase_a", "phase_b"])
        self.refuse(2, r"^pcvt: --cvt|^t\.foam: --cvt needs cells", "check", "t.foam", "--cvt")

    def test_threads_change_no_byte(self):
        words = (*GRAINS, *PHASES, *outputs("foam"), "-o", "c.csv", "--quiet", "--force")
        self.succeed(*words, "--threads", 1)
        first = self.contents()
        self.succeed(*words, "--threads", 2)
        self.assertEqual(self.contents(), first)

    def test_refusals_name_what_to_take(self):
        self.refuse(2, r"-o t\.stl: \.stl holds tiles in space only; give three period vectors, or take another format, such as "
                       r"\.obj", "mesh", "--sites", 5, "-o", "t.stl")
        for name in ("t.stl", "t.foam"):
            self.refuse(2, r"the format holds no Delaunay tetrahedra; take \.msh, \.inp or \.vtu, or write the cells in a run of "
                           "their own", *CUBE, "--mesh", "delaunay", "-o", name)
            self.refuse(2, r"no output holds the mid-side nodes of order 2; add one of \.msh, \.inp, \.vtu", *GRAINS, "--order", 2,
                        "-o", name)
        self.refuse(2, "no output takes phases", *CUBE, *PHASES, "-o", "t.stl")
        self.refuse(2, "^t.stl: --cvt needs cells, and the file holds closed surfaces; check a .vtu", "check",
                    self.stl_of_another_program(), "--cvt")

    def stl_of_another_program(self):
        self.succeed(*CUBE, "-o", "t.stl", "--quiet")
        data = self.path("t.stl").read_bytes()
        return self.write("t.stl", b"exported by another program".ljust(80) + data[80:])

    def test_stl_of_another_program_is_proved_without_periods(self):
        name = self.stl_of_another_program()
        self.assertIn(" in 5 surfaces, each closed and oriented outwards, volume 1 (tolerance", self.succeed("check", name))
        self.write(name, b"solid ascii\nendsolid\n")
        self.refuse(2, "^t.stl: an STL in ASCII; export it as a binary STL", "check", name)

    def test_coarse_precision_leaves_the_file_out(self):
        done = self.run_pcvt("mesh", "--sites", 60, "--max-iterations", 0, "--period", "1,1,1", "--origin", "200000,0,0", "-o", "t.stl", "-o", "t.vtu", "--quiet")
        self.assertEqual(done.returncode, 2)
        self.assertRegex(done.stderr.decode(), r"t\.stl: the single precision of STL would merge points or turn facets of this tile; "
                                               r"take an --origin nearer to 0, --short-edges, or a format of double "
                                               r"precision, such as \.obj")
        self.assertEqual(set(self.contents()), {"t.vtu"})


if __name__ == "__main__":
    main()
