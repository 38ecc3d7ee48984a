"""pcvt mesh and check with the formats of flow solvers: case folders, C-grids, short edges."""

import json
import os
import re
import shutil
import unittest

from support.cli import CliTest, main

CASE = {f"t.foam/{name}" for name in (
    "constant/polyMesh/points", "constant/polyMesh/faces", "constant/polyMesh/owner",
    "constant/polyMesh/neighbour", "constant/polyMesh/boundary", "constant/polyMesh/cellZones",
    "constant/transportProperties",
    "constant/turbulenceProperties", "system/controlDict", "system/fvSchemes", "system/fvSolution",
    "0/U", "0/p", "0/T", "t.foam")}


class CaseFolder(CliTest):
    def test_it_appears_complete_and_alone(self):
        said = self.succeed("mesh", "--sites", 30, "-o", "t.foam")
        self.assertEqual(set(self.contents()), CASE)
        self.assertRegex(said, r"(?m)^file +t\.foam$")
        self.assertEqual(os.listdir(self.folder), ["t.foam"])

    def test_each_mesh_has_a_separate_folder(self):
        self.succeed("mesh", "--sites", 30, "--mesh", "voronoi", "--mesh", "delaunay", "-o", "t.foam",
                     "--lattice", "1,0,0.3,0.9", "--repeat", "2x1")
        lines = self.succeed("check", "t-voronoi.foam", "t-delaunay.foam", "--cvt").splitlines()
        self.assertRegex(lines[0], r"60 faces.*genus 1.*area 0?1\.8.*stored pairs agree, .*centroidal")
        self.assertRegex(lines[1], r"120 faces.*stored pairs agree, .*Delaunay")

    def test_force_replaces_what_pcvt_writes_and_nothing_else(self):
        self.succeed("mesh", "--sites", 30, "-o", "t.foam", "--quiet")
        before = self.contents()
        self.path("t.foam/0.05").mkdir()
        self.write("t.foam/0.05/U", "a result")
        shutil.rmtree(self.path("t.foam/system"))
        self.refuse(3, r"t\.foam: cannot write: it exists; use --force", "mesh", "--sites", 30, "-o", "t.foam")
        self.succeed("mesh", "--sites", 30, "-o", "t.foam/", "--quiet", "--force")
        self.assertEqual(self.contents(), {**before, "t.foam/0.05/U": b"a result"})

    def test_a_foreign_entry_at_the_path_is_refused_with_or_without_force(self):
        self.write("t.foam", "a file")
        for force in ((), ("--force", )):
            self.refuse(3, r"t\.foam: .*not a folder", "mesh", "--sites", 3, "-o", "t.foam", *force)
        self.path("u.foam/constant/polyMesh/points").mkdir(parents=True)
        self.refuse(3, "points: .*Is a directory", "mesh", "--sites", 3, "-o", "u.foam", "--force")
        self.refuse(3, "folder /dev/null: Not a dir", "mesh", "--sites", 3, "-o", "/dev/null/t.foam")
        self.refuse(2, "another output", "mesh", "--sites", 3, "-o", "t.foam", "-o", "./t.foam")

    def test_grains_are_accepted_and_cut_cells_are_not(self):
        box = ("mesh", "--sites", 30, "--outline", "box", "-o", "t.foam")
        self.refuse(2, "-o t.foam: cells that the box cuts .*; take the whole outline", *box)
        self.succeed(*box, "--mesh", "grains", "--quiet")
        self.assertIn("stored pairs agree", self.succeed("check", "t.foam"))

    def test_the_layer_has_the_thickness_that_was_given(self):
        for period, given, height in (("1,1", (), None), ("1,1", ("--thickness", "0.3"), 0.3),
                                      ("2e-3,1e-3", ("--thickness", "1e-4"), 1e-4)):
            self.succeed("mesh", "--sites", 30, "--period", period, *given, "-o", "t.foam", "--quiet", "--force")
            points = self.path("t.foam/constant/polyMesh/points").read_text()
            heights = {float(z) for z in re.findall(r"^\(\S+ \S+ (\S+)\)$", points, re.M)}
            self.assertEqual(heights, {0, height or 30 ** -0.5})
            self.succeed("check", "t.foam")
        for wrong, words in (("0", "--thickness"), ("-1", "--thickness"), ("x", "--thickness"), ("nan", "--thickness"),
                             ("1e9", "not between 0.001 and 1000 times"), ("1e-9", "not between 0.001")):
            self.refuse(2, words, "mesh", "--sites", 30, "--thickness", wrong, "-o", "u.foam")
        self.refuse(2, r"no output takes a thickness; add one of \.inp or \.foam", "mesh", "--sites", 30, "--thickness", "0.3",
                    "-o", "u.obj")

    def test_paths_that_openfoam_cannot_open_are_refused(self):
        for path in ("my case.foam", "my folder/case.foam", "it's.foam", 'a"b.foam'):
            for period in ("1,1", "1,1,1"):
                self.refuse(2, "-o .*: OpenFOAM leaves blanks and quotes out of paths", "mesh", "--sites", 30, "--period",
                            period, "-o", path)
        self.succeed("mesh", "--sites", 30, "-o", "my tile.obj", "--quiet")

    def test_a_run_that_fails_leaves_no_folder(self):
        self.write("sites.txt", "0 0\n0.5 0\n0 0.5\n0.5 0.5\n")
        self.refuse(2, "90.0 degrees", "mesh", "--input", "sites.txt", "--max-iterations", 0, "-o",
                    "t.foam", "-o", "t.nc")
        self.assertEqual(os.listdir(self.folder), ["sites.txt"])
        self.path("t.foam").mkdir()
        self.refuse(2, "90.0 degrees", "mesh", "--input", "sites.txt", "--max-iterations", 0, "-o",
                    "t.foam", "-o", "t.nc", "--force")
        self.assertEqual(os.listdir(self.path("t.foam")), [])

    def test_damaged_cases_are_refused(self):
        self.succeed("mesh", "--sites", 30, "-o", "t.foam", "--quiet")
        for name, old, new in (("points", r"^\(0\.(\d)", r"(0.0\1"), ("owner", r"^0$", "1"),
                               ("boundary", r"seam_1_0\n", "seam_2_0\n"), ("faces", r"^4\(", "3("),
                               ("boundary", r"separationVector \(1 ", "separationVector (1.1 ")):
            path = self.path("t.foam/constant/polyMesh") / name
            whole = path.read_text()
            damaged, count = re.subn(old, new, whole, count=1, flags=re.M)
            self.assertEqual(count, 1)
            path.write_text(damaged)
            with self.subTest(name):
                self.refuse(2, r"^t\.foam", "check", "t.foam")
            path.write_text(whole)
        self.succeed("check", "t.foam/")
        self.path("t.foam").rename(self.path("renamed.foam"))
        self.succeed("check", "renamed.foam")
        self.path("renamed.foam").rename(self.path("t.foam"))
        os.remove(self.path("t.foam/constant/polyMesh/neighbour"))
        self.refuse(2, "no constant/polyMesh/neighbour", "check", "t.foam")

    def test_same_input_gives_same_bytes(self):
        for name in ("one", "two"):
            self.path(name).mkdir()
            self.succeed("mesh", "--sites", 50, "-o", "t.foam", "-o", "t.nc", "--quiet", cwd=self.path(name))
        self.assertEqual(self.contents(self.path("one")), self.contents(self.path("two")))


class CGrid(CliTest):
    def test_it_is_proved_and_shared_by_all_meshes(self):
        self.succeed("mesh", "--sites", 60, "--period", "1,0.7", "--mesh", "voronoi", "--mesh",
                     "delaunay", "--repeat", "2x1", "-o", "t.nc", "--quiet")
        self.assertEqual(set(self.contents()), {"t.nc", "t.graph.info"})
        line = self.succeed("check", "t.nc", "--period", "2,0.7")
        self.assertRegex(line, r"^t\.nc: an MPAS mesh: 120 cells, 360 edges, 240 vertices, period 2 x 0\.7, "
                         r".*TRiSK identity within \S+e-1[3-9]\n$")

    def test_wrong_requests_name_the_remedy(self):
        run = ("mesh", "--sites", 60, "-o", "t.nc")
        self.refuse(2, "-o t.nc: MPAS supports only periods along x and y; use a rectangular lattice", *run,
                    "--lattice", "1,0,0.3,0.9")
        self.refuse(2, "Delaunay triangle of sites .*MPAS needs acute triangles; .*leave --max-iterations 0 out",
                    *run, "--max-iterations", 0)
        self.refuse(2, "half a period apart.*repeat", "mesh", "--sites", 2, "-o", "t.nc", "--period", "1,1.3")
        self.refuse(2, "remove no short edges", *run, "--short-edges", "0.1")

    # Twelve iterations leave obtuse triangles for some seeds and none for others.
    HARD = ("mesh", "--sites", 30, "--max-iterations", 12, "-o", "t.nc", "-o", "s.txt")

    def suits(self, seed):
        done = self.run_pcvt(*self.HARD, "--seed", seed, "--force")
        self.assertIn(done.returncode, (0, 2))
        for path in self.folder.iterdir():
            path.unlink()
        return done.returncode == 0

    def hard_seed(self, n_refused):
        """Returns a seed that is refused like those that follow, n_refused in all; the next suits."""
        suited = [self.suits(seed) for seed in range(40)]
        for seed in range(40 - n_refused):
            if not any(suited[seed:seed + n_refused]) and suited[seed + n_refused]:
                return seed
        return self.fail(f"no such seed: {suited}")

    def test_a_retry_takes_the_next_seed_that_suits(self):
        seed = self.hard_seed(2)
        self.refuse(2, "MPAS needs acute triangles; try another --seed or a smaller --tolerance, or add --retry",
                    *self.HARD, "--seed", seed)
        self.refuse(2, f"MPAS needs acute triangles; 2 seeds from {seed} on were tried", *self.HARD, "--seed",
                    seed, "--retry", 1)
        text = self.succeed(*self.HARD, "--seed", seed, "--retry", 5, "--report", "r.json")
        self.assertRegex(text, rf"(?m)^seed +{seed + 2}, because an output refused the cells of seed {seed} "
                         rf"to {seed + 1}$")
        report = json.loads(self.path("r.json").read_text())
        self.assertEqual(report["seed"], seed + 2)
        self.assertEqual(report["files"], ["t.nc", "t.graph.info", "s.txt"])
        # The history in t.nc states the command.
        retried = {name: data for name, data in self.contents().items() if name not in ("r.json", "t.nc")}
        self.succeed(*self.HARD, "--seed", seed + 2, "--force")
        self.assertEqual({name: self.contents()[name] for name in retried}, retried)

    def test_a_retry_without_effect_is_refused(self):
        self.write("sites.txt", "0 0\n0.5 0.5\n")
        self.refuse(2, "--retry is for random sites, but --input gives them", "mesh", "--input", "sites.txt", "-o",
                    "t.nc", "--retry", 3)
        self.refuse(2, "--retry is for outputs that refuse some cells", "mesh", "--sites", 30, "-o", "t.obj",
                    "--retry", 3)
        self.refuse(2, "--retry takes other seeds", "mesh", "--sites", 30, "-o", "t.nc", "--start", "lattice",
                    "--retry", 3)
        self.refuse(2, "--retry is not for pattern", "pattern", "--sites", 30, "-o", "t.nc", "--retry", 3)

    def test_the_graph_lists_the_neighbours_of_each_cell(self):
        self.succeed("mesh", "--sites", 60, "--period", "1,0.7", "-o", "grid.nc", "--quiet")
        head, *lines = self.path("grid.graph.info").read_text().splitlines()
        self.assertEqual(head, "60 180")
        neighbours = [set(map(int, line.split())) for line in lines]
        self.assertEqual(sum(map(len, neighbours)), 360)
        self.assertEqual(len(neighbours), 60)
        for cell, others in enumerate(neighbours, 1):
            self.assertNotIn(cell, others)
            self.assertTrue(all(cell in neighbours[other - 1] for other in others))

    def test_damaged_files_are_refused(self):
        self.succeed("mesh", "--sites", 60, "--period", "1,0.7", "-o", "t.nc", "--quiet")
        whole = self.path("t.nc").read_bytes()
        swapped = bytearray(whole)
        middle = len(whole) // 2
        swapped[middle:middle + 64] = whole[middle:middle + 64][::-1]
        for name, damaged in (("half", whole[:len(whole) // 2]), ("empty", b""), ("swapped", bytes(swapped)),
                              ("noise", bytes(range(256)) * 8)):
            with self.subTest(name):
                self.write(f"{name}.nc", damaged)
                self.refuse(2, rf"^{name}\.nc: ", "check", f"{name}.nc")
        self.refuse(2, "not the one that was given", "check", "t.nc", "--period", "1,1")
        self.refuse(2, "--cvt is not for MPAS", "check", "t.nc", "--cvt")


class ShortEdges(CliTest):
    def test_they_are_removed_and_the_seam_still_matches(self):
        run = ("mesh", "--sites", 400, "--seed", 3, "--max-iterations", 0, "--quiet")
        self.succeed(*run, "-o", "all.foam", "-o", "all.ply")
        self.succeed(*run, "-o", "t.foam", "-o", "t.ply", "--short-edges", "0.2")
        lines = self.succeed("check", "all.foam", "t.foam", "t.ply").splitlines()
        vertices = [int(re.search(r"(\d+) vertices, 400 faces", line)[1]) for line in lines]
        self.assertLess(vertices[1], 0.9 * vertices[0])
        self.assertEqual(vertices[1], vertices[2])

    def test_nonsense_is_refused(self):
        run = ("mesh", "--sites", 30, "-o", "t.ply", "--short-edges")
        self.refuse(2, "--short-edges 0.6: .* take at most 0.5", *run, "0.6")
        self.refuse(2, "--short-edges", *run, "-1")
        self.refuse(2, "take --mesh voronoi", *run, "0.1", "--mesh", "delaunay")


if __name__ == "__main__":
    main()
