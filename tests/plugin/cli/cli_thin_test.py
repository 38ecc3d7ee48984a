"""Cells that are wider than a period, and cells too thin for grains."""

from support.cli import CliTest, main


class ThinCells(CliTest):
    def test_short_edges_are_removed_from_cells_wider_than_a_period(self):
        for seed in range(4):
            self.succeed("mesh", "--sites", 2, "--period", "1,10", "--seed", seed, "--short-edges", 0.5, "--repeat", "2x1", "-o",
                         "t.obj", "-o", "t.vtu", "--force")
            self.succeed("check", "t.obj", "t.vtu")
        self.succeed("mesh", "--sites", 20, "--period", "1,1000", "--short-edges", 0.3, "--repeat", "2x1", "-o", "t.obj", "--force")

    def test_elongated_cells_whose_reduced_basis_is_longer_than_the_tile_keep_their_seam(self):
        for seed, n in ((8, 9), (19, 17), (53, 9)):
            self.succeed("mesh", "--sites", n, "--seed", seed, "--max-iterations", 0, "--aspect", "40,45",
                         "--lattice=-0.358143494,1.31129277,1,-0.13394816", "--mesh", "delaunay", "-o", "t.obj", "-o", "t.msh",
                         "-o", "t.vtu", "--force")
            self.succeed("check", "t.obj", "t.msh", "t.vtu")

    def test_grains_name_the_cell_and_a_remedy_that_applies(self):
        self.refuse(4, r"^pcvt: the cell of site \d is too thin to be meshed by grains; take more sites, optimise them, or "
                    "shorten the longer period$", "mesh", "--sites", 10, "--period", "1,1e5", "--mesh", "grains", "-o", "t.vtu")
        self.write("shapes.txt", "polygon t 0.00000001 0.2 0.3 0.2 0.3 0.6 0.00000001 0.6\n")
        self.refuse(4, r"^pcvt: a piece of the cell of site \d+ is too thin to be meshed by grains; give another origin, or use "
                    "the whole outline$", "mesh", "--sites", 900, "--mesh", "grains", "--outline", "box", "--inclusions",
                    "shapes.txt", "-o", "t.msh", "--tolerance", "1e-2")

    def test_a_tile_has_at_most_10000_periods_in_a_row(self):
        for repeat in ("10001x1", "1x20000"):
            self.refuse(4, rf"^pcvt: --repeat {repeat}: more than 10000 periods in a row; repeat less often$", "mesh", "--sites", 1,
                        "--repeat", repeat, "-o", "t.obj")


if __name__ == "__main__":
    main()
