"""The Python package in three dimensions: arrays, the seam, files, refusals."""

import json
import gc

from support.cli import CliTest, main
from support.python_package import pcvt

import numpy as np

OBLIQUE = np.array([[1, 0, 0], [0.37, 0.81, 0], [0.2, 0.4, 0.9]])
LEFT_HANDED = np.array([[1, 0, 0], [0, 0, 1.1], [0.3, 0.8, 0]])


def cone(corners):
    """Six times the volume between a face and the origin."""
    return sum(np.linalg.det(np.stack([corners[0], p, q])) for p, q in zip(corners[1:], corners[2:]))


class Arrays(CliTest):
    def test_volumes_follow_from_the_faces(self):
        for lattice in (np.eye(3), OBLIQUE, LEFT_HANDED):
            tile = pcvt.space(30, lattice, seed=3).tile()
            np.testing.assert_array_equal(tile.lattice, lattice)
            found = np.zeros(30)
            for face, corners in enumerate(tile.polygons()):
                found[tile.owner[face]] += cone(corners) / 6
                if tile.neighbour[face] >= 0:
                    found[tile.neighbour[face]] -= cone(corners) / 6
            np.testing.assert_allclose(tile.volumes, found, rtol=1e-11)
            self.assertAlmostEqual(tile.volumes.sum(), abs(np.linalg.det(lattice)), 12)
            self.assertTrue((tile.neighbour[:tile.n_inner_faces] > tile.owner[:tile.n_inner_faces]).all())
            self.assertTrue((tile.neighbour[tile.n_inner_faces:] == -1).all())

    def test_partners_are_translations(self):
        for lattice in (np.eye(3), OBLIQUE, LEFT_HANDED):
            tile = pcvt.space(30, lattice).tile()
            polygons = tile.polygons()
            boundary = np.arange(tile.n_inner_faces, len(tile.owner))
            np.testing.assert_array_equal(tile.partner[tile.partner - tile.n_inner_faces], boundary)
            self.assertTrue((tile.partner != boundary).all())
            for face, partner, offset in zip(boundary, tile.partner, tile.partner_offset):
                self.assertTrue(offset.any())
                there = np.roll(polygons[face][::-1], 1, axis=0) + offset @ tile.lattice
                np.testing.assert_allclose(polygons[partner], there, rtol=0, atol=4e-15)

    def test_points_are_translations_of_their_orbit(self):
        tile = pcvt.space(30, OBLIQUE).tile()
        self.assertTrue((tile.point_orbit <= np.arange(len(tile.points))).all())
        moved = tile.points[tile.point_orbit] + tile.point_offset @ tile.lattice
        np.testing.assert_allclose(tile.points, moved, rtol=0, atol=4e-15)

    def test_sites_keep_their_order(self):
        given = np.random.default_rng(4).uniform(-3, 3, (20, 3))
        result = pcvt.space(given, max_iterations=0)
        self.assertEqual(result.sites.shape, (20, 3))
        np.testing.assert_allclose(result.sites, given - np.floor(given), rtol=0, atol=1e-14)
        moved = result.tile().site_points - result.sites
        np.testing.assert_allclose(moved, np.round(moved), atol=1e-14)

    def test_statistics_describe_the_run(self):
        figures = pcvt.space(16, period=(2, 2, 2), start="lattice").statistics
        energy = 19 / (192 * 2 ** (1 / 3)) * 3 * 8 ** (5 / 3) * 16 ** (-2 / 3)
        self.assertAlmostEqual(figures.energy / energy, 1, 12)
        self.assertAlmostEqual(figures.energy_bound / energy, 1, 12)
        self.assertEqual((figures.stop, figures.n_sites, figures.valences[14]), ("converged", 16, 16))
        limited = pcvt.space(50, max_iterations=3, threads=1, solver="lloyd").statistics
        self.assertEqual((limited.stop, limited.iterations, limited.n_threads), ("iteration-limit", 3, 1))
        self.assertEqual(limited.valences.sum(), 50)

    def test_a_period_is_the_lattice_of_a_box(self):
        result = pcvt.space(20, period=(2, 0.5, 1))
        np.testing.assert_array_equal(result.tile().lattice, np.diag((2, 0.5, 1)))
        np.testing.assert_array_equal(result.sites, pcvt.space(20, np.diag((2, 0.5, 1))).sites)

    def test_arrays_are_views_that_keep_the_result_alive(self):
        points = pcvt.space(300, max_iterations=0).tile().points
        self.assertFalse(points.flags.owndata or points.flags.writeable)
        before = points.copy()
        gc.collect()
        others = [pcvt.space(300, seed=seed, max_iterations=0).tile() for seed in (1, 2)]
        np.testing.assert_array_equal(points, before)
        self.assertNotEqual(others[0].points.ctypes.data, points.ctypes.data)


class Files(CliTest):
    def test_files_are_those_of_the_command(self):
        names = ("vtu", "foam", "msh", "obj", "ply", "glb", "txt")
        self.succeed("mesh", "--sites", 40, "--seed", 6, "--lattice", "1,0,0,0.37,0.81,0,0.2,0.4,0.9", "--quiet",
                     *(word for name in names for word in ("-o", f"command/a.{name}")))
        result = pcvt.space(40, OBLIQUE, seed=6)
        for name in names:
            result.write(self.path(f"python/a.{name}"))
        folders = {folder: {str(path.relative_to(self.path(folder))): path.read_bytes()
                            for path in self.path(folder).rglob("*") if path.is_file()}
                   for folder in ("command", "python")}
        self.assertGreater(len(folders["command"]), 10)
        self.assertEqual(folders["python"], folders["command"])

    def test_periods_are_repeated_as_by_the_command(self):
        self.succeed("mesh", "--sites", 20, "--period", "1,1,1", "--repeat", "2x1x3", "--quiet", "-o", "a.vtu", "-o", "a.glb")
        result = pcvt.mesh(20, period=(1, 1, 1), repeat=(2, 1, 3))
        for name in ("vtu", "glb"):
            result.write(self.path(f"b.{name}"))
            self.assertEqual(self.path(f"b.{name}").read_bytes(), self.path(f"a.{name}").read_bytes())
        # Arrays are those of one period.
        self.assertEqual(len(result.tile().volumes), 20)
        self.assertAlmostEqual(result.tile().volumes.sum(), 1, 12)

    def test_colours_are_those_of_the_command(self):
        self.succeed("mesh", "--sites", 12, "--period", "1,1,1", "--orientations", "random", "--colour", "orientation", "--quiet",
                     "-o", "a.obj", "-o", "a.glb")
        result = pcvt.mesh(12, period=(1, 1, 1), orientations="random")
        for name in ("obj", "glb"):
            result.write(self.path(f"b.{name}"), colour="orientation")
        files = self.contents()
        self.assertEqual(files["b.glb"], files["a.glb"])
        self.assertEqual(files["b.obj"].replace(b"b.mtl", b"a.mtl"), files["a.obj"])
        with self.assertRaisesRegex(pcvt.ArgumentError, "'sides' is unknown; take one of default, size"):
            result.write(self.path("c.obj"), colour="sides")

    def test_short_edges_are_removed_as_by_the_command(self):
        self.succeed("mesh", "--sites", 60, "--period", "1,1,1", "--max-iterations", 0, "--short-edges", "0.05",
                     "--quiet", "-o", "a.vtu")
        result = pcvt.space(60, max_iterations=0, short_edges=0.05)
        self.assertLess(len(result.tile().points), len(pcvt.space(60, max_iterations=0).tile().points))
        result.write(self.path("b.vtu"))
        self.assertEqual(self.path("b.vtu").read_bytes(), self.path("a.vtu").read_bytes())
        with self.assertRaisesRegex(pcvt.ArgumentError, "cannot say that short edges were removed; take .vtu or .foam"):
            result.write(self.path("b.obj"))

    def test_boundaries_are_those_of_the_command(self):
        names = [f"a.{extension}" for extension in ("obj", "ply", "glb")]
        self.succeed("mesh", "--sites", 12, "--period", "1,1,1", "--surface", "boundary", "--quiet",
                     *(word for name in names for word in ("-o", name)))
        of_command = self.contents()
        result = pcvt.space(12)
        for name in names:
            result.write(self.path(name), surface="boundary", replace=True)
        self.assertEqual(self.contents(), of_command)
        for name in names:
            result.write(self.path(name), replace=True)
            self.assertNotEqual(self.contents()[name], of_command[name])
        with self.assertRaisesRegex(pcvt.ArgumentError, "surface is for .obj, .ply, .glb or .stl"):
            result.write(self.path("a.foam"), surface="boundary")
        with self.assertRaisesRegex(pcvt.ArgumentError, "surface 'skin' is unknown; take one of cells, boundary"):
            result.write(self.path("a.obj"), surface="skin")

    def test_minimum_is_known_of_converged_runs(self):
        self.assertIs(pcvt.space(16, start="lattice").minimum, True)
        self.assertIsNone(pcvt.space(40, max_iterations=0).minimum)

    def test_tetrahedra_are_those_of_the_command(self):
        self.succeed("mesh", "--sites", 12, "--period", "1,1,1", "--mesh", "delaunay", "--quiet", "-o", "a.vtu")
        of_command = self.contents()
        result = pcvt.space(12)
        result.write(self.path("a.vtu"), mesh="delaunay", replace=True)
        self.assertEqual(self.contents(), of_command)
        with self.assertRaisesRegex(pcvt.ArgumentError, "the format holds no tetrahedra; take .msh, .inp or .vtu"):
            result.write(self.path("a.obj"), mesh="delaunay")
        self.succeed("mesh", "--sites", 12, "--period", "1,1,1", "--mesh", "grains", "--size", "0.2", "--quiet", "-o",
                     "a.vtu", "--force")
        of_command = self.contents()
        pcvt.space(12, grain_size=0.2).write(self.path("a.vtu"), mesh="grains", replace=True)
        self.assertEqual(self.contents(), of_command)
        self.succeed("mesh", "--sites", 2, "--period", "1,1,1", "--mesh", "grains", "--size", "0.5", "--order", "2", "--job",
                     "elastic", "--quiet", "-o", "a.inp")
        of_command = self.contents()
        result = pcvt.mesh(2, period=(1, 1, 1), grain_size=0.5, grain_order=2)
        result.write(self.path("a.inp"), mesh="grains", job="elastic", replace=True)
        self.assertEqual(self.contents(), of_command)
        with self.assertRaisesRegex(pcvt.ArgumentError, "mesh 'cubes' is unknown; take one of voronoi, delaunay, grains"):
            result.write(self.path("a.vtu"), mesh="cubes", replace=True)

    def test_report_has_the_figures_of_the_run(self):
        result = pcvt.space(12, tolerance=1e-4)
        result.write(None, report=self.path("r.json"))
        result.write(self.path("t.om"), report=self.path("s.json"))
        without, beside = (json.loads(self.path(name).read_text()) for name in ("r.json", "s.json"))
        self.assertEqual((without["files"], beside["files"]), ([], [str(self.path("t.om"))]))
        for found in (without, beside):
            self.assertEqual(found["energy"], result.statistics.energy)
            self.assertEqual(found["iterations"], result.statistics.iterations)
            self.assertEqual(sum(found["faces"].values()), 12)
        with self.assertRaisesRegex(pcvt.ArgumentError, "neither path nor report"):
            result.write(None)

    def test_files_are_replaced_on_request_only(self):
        result = pcvt.space(10)
        result.write(self.path("t.vtu"))
        with self.assertRaisesRegex(pcvt.OutputError, "t.vtu.*replace"):
            result.write(self.path("t.vtu"))
        result.write(self.path("t.vtu"), replace=True)

    def test_voxels_are_those_of_the_command(self):
        self.succeed("mesh", "--sites", 20, "--period", "1,2,1", "--phases", "a:0.5,b:0.5", "--material", "a:200,0.3",
                     "--material", "b:3,2,1", "--voxels", "8,12,6", "-o", "a.vti", "--quiet")
        result = pcvt.mesh(20, ((1, 0, 0), (0, 2, 0), (0, 0, 1)), phases={"a": 0.5, "b": 0.5})
        result.write(self.path("b.vti"), voxels=(8, 12, 6), materials={"a": (200, 0.3), "b": (3, 2, 1)})
        for end in (".vti", ".material.yaml"):
            self.assertEqual(self.path(f"a{end}").read_bytes(), self.path(f"b{end}").read_bytes())
        result.write(self.path("c.vti"))
        with self.assertRaisesRegex(pcvt.ArgumentError, "three counts, NX,NY,NZ"):
            result.write(self.path("d.vti"), voxels=(8, 12))

    def test_a_write_and_a_run_can_be_cancelled(self):
        seen = []
        result = pcvt.space(200, tolerance=1e-2, progress=seen.append)
        self.assertEqual(list(dict.fromkeys(state.iteration for state in seen))[:3], [0, 1, 2])
        self.assertAlmostEqual(seen[0].energy_bound, result.statistics.energy_bound)
        with self.assertRaisesRegex(pcvt.Cancelled, "cancelled"):
            result.write(self.path("t.vtu"), progress=lambda state: state.phase == "write")
        self.assertEqual(self.contents(), {})
        with self.assertRaisesRegex(pcvt.Cancelled, "cancelled"):
            pcvt.space(200, progress=lambda _: True)
        with self.assertRaisesRegex(LookupError, "mine"):
            pcvt.space(200, progress=lambda _: {}["mine"])


class Mesh(CliTest):
    """pcvt.mesh() with three period vectors."""

    def test_three_periods_mean_space(self):
        for arguments, same in (({"period": (2, 0.5, 1)}, {"period": (2, 0.5, 1)}),
                                ({"lattice": OBLIQUE}, {"lattice": OBLIQUE}),
                                ({"lattice": OBLIQUE.ravel()}, {"lattice": OBLIQUE}),
                                ({"lattice": np.eye(3).tolist()}, {}), ({"period": (1, 1, 1)}, {})):
            result = pcvt.mesh(20, seed=3, **arguments)
            self.assertIs(type(result), pcvt.SpaceResult)
            np.testing.assert_array_equal(result.sites, pcvt.space(20, seed=3, **same).sites)

    def test_two_periods_mean_the_plane(self):
        for arguments in ({"lattice": (2, 0, 0.5, 1)}, {"lattice": ((2, 0), (0.5, 1))}):
            result = pcvt.mesh(20, **arguments)
            self.assertIs(type(result), pcvt.Result)
            np.testing.assert_array_equal(result.lattice, ((2, 0), (0.5, 1)))
        np.testing.assert_array_equal(pcvt.mesh(20, period=(2, 1)).sites, pcvt.mesh(20, (2, 0, 0, 1)).sites)

    def test_arguments_for_the_plane_are_refused_by_name_at_once(self):
        shapes = (("circle", "a", 0.5, 0.5, 0.1), ("polygon", "b", ((0, 0), (0.1, 0), (0, 0.1))))
        for name, value in (("density", "1 + x"), ("density", lambda x, y: 1), ("density_range", (1, 2)),
                            ("grain_per_edge", 2), ("budget", 9), ("areas", "equal"),
                            ("areas", np.ones(9)), ("symmetry", "p2"),
                            ("walls", "x"), ("wall_cells", "half"), ("fixed", ((0, 0),)), ("inclusions", shapes),
                            ("fibres", (0.2, 3)), ("holes", ["a"])):
            with self.subTest(name), self.assertRaisesRegex(
                    pcvt.ArgumentError, f"^{name} is not for three dimensions; leave it out, or give two period"):
                pcvt.mesh(9, period=(1, 1, 1), **{name: value})
        with self.assertRaisesRegex(pcvt.ArgumentError, "^areas and walls are not for three .*; leave them out"):
            pcvt.mesh(9, period=(1, 1, 1), walls="x", areas="equal")

    def test_defaults_of_the_plane_are_no_choice(self):
        result = pcvt.mesh(9, period=(1, 1, 1), origin=[0, 0], repeat=np.array((1, 1)), walls="none", aspect=1,
                           holes=[], density=None)
        np.testing.assert_array_equal(result.sites, pcvt.space(9).sites)

    def test_words_are_those_of_space(self):
        with self.assertRaisesRegex(pcvt.ArgumentError, "solver 'newton' is unknown; take one of default, lbfgs, lloyd$"):
            pcvt.mesh(9, period=(1, 1, 1), solver="newton")
        with self.assertRaisesRegex(pcvt.ArgumentError, r"sites has the shape \(1, 2\); give \(1, 3\)"):
            pcvt.mesh([[0, 0]], period=(1, 1, 1))


class Refusals(CliTest):
    def refuse(self, error, pattern, sites=10, **arguments):
        with self.assertRaisesRegex(error, pattern) as refusal:
            pcvt.space(sites, **arguments)
        self.assertNotIn("\n", str(refusal.exception))

    def test_arguments(self):
        self.refuse(pcvt.ArgumentError, "n_sites is not between", 0)
        self.refuse(pcvt.ArgumentError, r"sites has the shape \(1, 2\)", [[0, 0]])
        self.refuse(pcvt.ArgumentError, "site 1 is not finite", [[0, 0, 0], [np.nan, 1, 0]])
        self.refuse(pcvt.GeometryError, "sites 0 and 1 coincide", [[0, 0, 0], [1, 1, -2]])
        self.refuse(pcvt.GeometryError, "sites 0 and 1 coincide", [[0, 0, 0], [1, 1e-11, -2]])
        self.refuse(pcvt.ArgumentError, "duplicates 'keep' is unknown", duplicates="keep")
        self.refuse(pcvt.ArgumentError, r"lattice has the shape \(2, 2\)", lattice=((1, 0), (0, 1)))
        self.refuse(pcvt.ArgumentError, "lattice3: ", lattice=((1, 0, 0), (0, 1, 0), (1, 1, 0)))
        self.refuse(pcvt.ArgumentError, "exclude each other", lattice=OBLIQUE, period=(1, 1, 1))
        self.refuse(pcvt.ArgumentError, r"period \(1, 0, 1\): a side is not above 0", period=(1, 0, 1))
        self.refuse(pcvt.ArgumentError, "start 'best' is unknown; take one of default, random, coarse, lattice",
                    start="best")
        self.refuse(pcvt.ArgumentError, "solver 'newton' is unknown", solver="newton")
        self.refuse(pcvt.ArgumentError, "tolerance", tolerance=0)
        self.refuse(pcvt.LimitError, "memory", 2**26)

    def test_near_sites_are_dropped(self):
        result = pcvt.space([[0, 0, 0], [0.5, 0.5, 0.5], [1, 1e-11, -2]], max_iterations=0, duplicates="drop")
        self.assertEqual(result.statistics.dropped.tolist(), [[2, 0]])
        self.assertEqual(len(result.sites), 2)

    def test_formats_without_volumes(self):
        result = pcvt.space(3)
        with self.assertRaisesRegex(pcvt.ArgumentError, "html does not support three dimensions; take .obj, .ply, .glb, .om, .stl, .msh, .inp, .vtu, .svg, .png, .foam, .vti, .csv or .txt"):
            result.write(self.path("t.html"))


class Materials(CliTest):
    def test_phases_orientations_and_the_table(self):
        result = pcvt.mesh(40, OBLIQUE, phases={"a": 0.25, "b": 0.75}, orientations="random", origin=(5, -1, 2))
        cells = result.cells
        self.assertEqual(result.phase_names, ("a", "b"))
        np.testing.assert_array_equal(cells["phase"], result.phases)
        np.testing.assert_array_equal(np.stack([cells[name] for name in ("phi1", "Phi", "phi2")], axis=1),
                                      result.orientations)
        self.assertAlmostEqual(cells["volume"][cells["phase"] == 0].sum() / 0.729, 0.25, delta=0.02)
        at = (result.sites - (5, -1, 2)) @ np.linalg.inv(OBLIQUE)
        self.assertLess(np.ptp(at, axis=0).max(), 2.5)
        result.write(self.path("t.csv"))
        result.write(self.path("t.vtu"))
        self.succeed("check", "t.vtu")
        with open(self.path("t.csv"), encoding="utf-8") as file:
            rows = [line.rstrip("\n").split(",") for line in file if not line.startswith("#")]
        names = rows[0]
        for cell, row in zip(cells, rows[1:], strict=True):
            of = dict(zip(names, row))
            self.assertEqual([int(of["site"]), int(of["faces"])], [cell["site"], cell["faces"]])
            for name in ("x", "y", "z", "phi1", "Phi", "phi2"):
                self.assertEqual(float(of[name]), cell[name])
            for name in ("volume", "diameter", "sphericity"):
                self.assertAlmostEqual(float(of[name]) / cell[name], 1, delta=1e-10)
            self.assertEqual(of["phase"], result.phase_names[cell["phase"]])
            self.assertEqual([int(word) for word in of["neighbours"].split()], cell["neighbours"].tolist())

    def test_boxes_are_those_of_the_command(self):
        for origin, option in (((0.1, 0.2, 0.3), "0.1,0.2,0.3"), ("auto", "auto")):
            with self.subTest(option):
                result = pcvt.mesh(9, period=(1, 1, 1), origin=origin)
                for mesh in ("voronoi", "grains"):
                    self.succeed("mesh", "--sites", 9, "--period", "1,1,1", "--outline", "box", "--origin", option,
                                 "--mesh", mesh, "-o", "command.vtu", "--force")
                    result.write(self.path("python.vtu"), mesh=mesh, outline="box", replace=True)
                    self.assertEqual(self.path("python.vtu").read_bytes(), self.path("command.vtu").read_bytes())

    def test_an_origin_has_three_numbers(self):
        for origin in ((1, 0), (1, 2, 3, 4), "best"):
            with self.subTest(origin), self.assertRaisesRegex(pcvt.ArgumentError, "^origin"):
                pcvt.mesh(9, period=(1, 1, 1), origin=origin)

    def test_elongated_cells_are_long_along_their_axis(self):
        def extents(result):
            tile = result.tile()
            low, high = np.full((100, 3), np.inf), np.full((100, 3), -np.inf)
            for face, corners in enumerate(tile.polygons()):
                for cell in {tile.owner[face], tile.neighbour[face]} - {-1}:
                    low[cell] = np.minimum(low[cell], corners.min(axis=0))
                    high[cell] = np.maximum(high[cell], corners.max(axis=0))
            return (high - low).mean(axis=0)
        for aspect, long in ((4, 0), ((4, (0, 0, 2)), 2), (np.float64(4), 0)):
            found = extents(pcvt.mesh(100, period=(1, 1, 1), aspect=aspect, tolerance=1e-3))
            self.assertAlmostEqual(found[long] / np.delete(found, long).mean(), 4, delta=0.4)
        with self.assertRaisesRegex(pcvt.ArgumentError, "aspect"):
            pcvt.mesh(9, period=(1, 1, 1), aspect=(2, 30))

    def test_cells_of_measured_grains_are_found(self):
        known = pcvt.mesh(30, period=(1, 1, 1), volumes="lognormal:0.35").tile()
        centroids, polygons = np.zeros((30, 3)), known.polygons()
        for cell in range(30):
            origin = known.site_points[cell]
            for face, sign in [(f, 1) for f in np.flatnonzero(known.owner == cell)] + [
                    (f, -1) for f in np.flatnonzero(known.neighbour == cell)]:
                a = polygons[face] - origin
                for b, c in zip(a[1:], a[2:]):
                    centroids[cell] += sign * np.linalg.det((a[0], b, c)) / 24 * (a[0] + b + c)
            centroids[cell] = origin + centroids[cell] / known.volumes[cell]
        found = pcvt.mesh(centroids, period=(1, 1, 1), volumes=known.volumes, sites_are_centroids=True)
        self.assertEqual(found.statistics.stop, "converged")
        self.assertLess(found.statistics.residual, 1e-6)
        np.testing.assert_allclose(found.tile().volumes, known.volumes, atol=1e-9 / 30)
        with self.assertRaisesRegex(pcvt.ArgumentError, "sites_are_centroids needs the sizes of the grains; add areas, "
                                                        "in space volumes"):
            pcvt.mesh(centroids, period=(1, 1, 1), sites_are_centroids=True)

    def test_volumes_of_a_law_and_of_an_array(self):
        drawn = pcvt.mesh(60, period=(1, 1, 1), volumes="lognormal:0.35")
        self.assertAlmostEqual(drawn.cells["volume"].sum(), 1, delta=1e-12)
        spread = drawn.cells["diameter"].std() / drawn.cells["diameter"].mean()
        self.assertTrue(0.2 < spread < 0.5, spread)
        mixed = pcvt.mesh(8, OBLIQUE, volumes="0.75*equal@1+0.25*equal@2", max_iterations=0).cells["volume"] / 0.729
        np.testing.assert_allclose(np.sort(mixed), np.array([1] * 6 + [8] * 2) / 22, rtol=1e-9)
        wanted = np.arange(1, 21)
        given = pcvt.mesh(20, OBLIQUE, volumes=wanted, max_iterations=0)
        np.testing.assert_allclose(given.cells["volume"], wanted * 0.729 / wanted.sum(), rtol=1e-9)
        np.testing.assert_array_equal(given.cells["weight"], given.weights)
        self.assertAlmostEqual(given.weights.sum(), 0, delta=1e-12)
        given.write(self.path("t.vtu"))
        self.assertIn("power cells of 20 sites", self.succeed("check", "t.vtu"))
        np.savetxt(self.path("v.txt"), wanted)
        np.savetxt(self.path("w.txt"), wanted[::-1])
        self.assertIn("volumes of 20 cells within", str(pcvt.check(self.path("t.vtu"), volumes=self.path("v.txt"))))
        self.assertFalse(pcvt.check(self.path("t.vtu"), volumes=self.path("w.txt")))
        with self.assertRaisesRegex(pcvt.ArgumentError, "n_volumes is not n_sites; give one volume for each site"):
            pcvt.mesh(4, period=(1, 1, 1), volumes=[1, 2, 3])
        with self.assertRaisesRegex(pcvt.ArgumentError, "volumes is for three dimensions"):
            pcvt.mesh(3, volumes=[1, 2, 3])

    def test_weights_give_power_cells(self):
        sites = np.random.default_rng(3).random((30, 3))
        result = pcvt.mesh(sites, period=(1, 1, 1), weights=np.linspace(0.01, 0.012, 30), max_iterations=0)
        np.testing.assert_array_equal(result.weights, np.linspace(0.01, 0.012, 30))
        self.assertAlmostEqual(result.cells["volume"].sum(), 1, delta=1e-12)
        self.assertIsNone(pcvt.mesh(9, period=(1, 1, 1)).weights)

    def test_cells_without_materials(self):
        result = pcvt.mesh(2, period=(1, 1, 1), start="lattice")
        self.assertIsNone(result.phases)
        self.assertIsNone(result.orientations)
        self.assertEqual(result.phase_names, ())
        self.assertTrue((result.cells["phase"] == -1).all() and np.isnan(result.cells["Phi"]).all())
        self.assertEqual(result.cells["faces"].tolist(), [14, 14])
        np.testing.assert_allclose(result.cells["sphericity"], 0.9099177, rtol=1e-6)
        phased = pcvt.mesh(3, period=(1, 1, 1), phases=["x", "y", "x"])
        self.assertEqual([phased.phase_names[k] for k in phased.phases], ["x", "y", "x"])


if __name__ == "__main__":
    main()
