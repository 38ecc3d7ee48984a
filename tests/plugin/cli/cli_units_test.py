"""Units of length, and files of single precision: tiles that 32-bit floats hold are written, others are refused."""

import json
import struct

from support.cli import CliTest, main, outputs

CUBE = ("--period", "1,1,1")


def node_of_tile(bytes_of_glb):
    length = struct.unpack_from("<I", bytes_of_glb, 12)[0]
    return json.loads(bytes_of_glb[20 : 20 + length])["nodes"][0]


class Units(CliTest):
    def test_periods_have_the_stated_lengths(self):
        for unit in (1e-60, 1e-55, 1e55, 1e59):
            for mesh in ("voronoi", "delaunay", "grains"):
                with self.subTest(unit=unit, mesh=mesh):
                    self.succeed("mesh", "--sites", 20, f"--period={unit},{unit}", "--mesh", mesh,
                                 *outputs("obj", "vtu", "svg"), "--force")
                    self.succeed("check", "t.obj", "t.vtu")

    def test_periods_in_space_have_the_stated_lengths(self):
        for unit in (1e-40, 1e-30, 1e30, 1e40):
            with self.subTest(unit=unit):
                self.succeed("mesh", "--sites", 20, f"--period={unit},{unit},{unit}", "--tolerance", "1e-3",
                             *outputs("obj", "vtu", "foam", "msh"), "--force")
                self.succeed("check", "t.obj", "t.vtu", "t.foam", "t.msh")

    def test_areas_are_prescribed_in_any_unit(self):
        for unit in (1e-50, 1e50):
            self.succeed("mesh", "--sites", 20, f"--period={unit},{unit}", "--areas", "lognormal:0.3", "-o", "t.obj", "--force")
            self.succeed("check", "t.obj")


class Floats(CliTest):
    """Lengths that floats do not hold."""

    def test_units_are_refused_before_the_run(self):
        coordinates = r"^pcvt: -o t\.(glb|gltf|ply): 32-bit floats do not hold coordinates in this unit of length; take another unit"
        weights = "32-bit floats do not hold the weights of prescribed areas, squares of lengths, in this unit"
        areas = ("--areas", "lognormal:0.3")
        for message, period, options in (
                (coordinates, "1e40,1e40", outputs("glb")), (coordinates, "1e-40,1e-40", outputs("gltf")),
                (coordinates, "1e40,1e40", (*outputs("ply"), "--float32")), (coordinates, "1e-40,1e-40,1e-40", outputs("glb")),
                (coordinates, "1e-59,2e-59", ("--mesh", "grains", *outputs("ply"), "--float32")),
                (weights, "1e20,1e20", (*areas, *outputs("glb"))), (weights, "1e-20,1e-20", (*areas, *outputs("glb"))),
                (weights, "1e30,1e30", (*areas, *outputs("ply"), "--float32"))):
            self.refuse(2, message, "mesh", "--sites", 1000000, f"--period={period}", *options)

    def test_units_that_floats_hold_are_written(self):
        for period in ("1e20,1e20", "1e-30,1e-30", "1e30,1e30,1e30", "1e-30,1e-30,1e-30"):
            self.succeed("mesh", "--sites", 20, f"--period={period}", "--tolerance", "1e-3", *outputs("glb"), "--force")
            self.succeed("check", "t.glb")
        for unit in ("1e15", "1e-15"):
            self.succeed("mesh", "--sites", 20, f"--period={unit},{unit}", "--areas", "gamma:0.3", *outputs("glb", "ply"),
                         "--float32", "--force")
            self.succeed("check", "t.glb", "t.ply")

    def test_a_distant_origin_is_refused_where_floats_cannot_move(self):
        self.refuse(2, r"-o t\.ply: 32-bit floats do not resolve cells that are so small beside their coordinates; take an "
                    "origin nearer to 0", "mesh", "--sites", 1000000, "--origin", "1e3,0", *outputs("ply"), "--float32")

    def test_the_other_files_of_the_run_are_written(self):
        done = self.run_pcvt("mesh", "--sites", 30, "--period", "1,1e-4", *outputs("glb", "obj", "gltf"), "--report", "r.json",
                             "--quiet")
        self.assertEqual(done.returncode, 2)
        self.assertRegex(done.stderr.decode(), r"^pcvt: t\.glb: the format's single precision is too coarse for this tile; take "
                         r"another format; so for t\.gltf; the other files are written\n$")
        self.assertEqual(sorted(self.contents()), ["r.json", "t.mtl", "t.obj", "t.seam.json"])
        self.assertEqual(json.loads(self.contents()["r.json"])["files"], ["t.obj", "t.mtl", "t.seam.json"])
        self.succeed("check", "t.obj")


class DistantTiles(CliTest):
    def test_the_node_of_the_tile_has_the_translation(self):
        near = self.origin("3,-2")
        self.assertNotIn("translation", near)
        for origin in ("20,20", "-25,0", "0,150", "9000,9000", "2e4,-3e4"):
            with self.subTest(origin=origin):
                node = self.origin(origin)
                for stated, wanted in zip(node["translation"], (*map(float, origin.split(",")), 0)):
                    self.assertLessEqual(abs(stated - wanted), 1)

    def origin(self, origin):
        for mesh in ("voronoi", "delaunay", "grains"):
            self.succeed("mesh", "--sites", 50, "--tolerance", "1e-2", "--mesh", mesh, f"--origin={origin}",
                         *outputs("glb", "gltf"), "--force")
            self.succeed("check", "t.glb", "t.gltf")
        return node_of_tile(self.contents()["t.glb"])

    def test_projected_coordinates_and_a_case_in_one_run(self):
        self.succeed("mesh", "--sites", 200, "--period", "100,100", "--origin", "448200.5,4649776.25", "--short-edges", 0.15,
                     *outputs("foam", "glb"))
        self.succeed("check", "t.foam", "t.glb")

    def test_shapes_and_densities_lie_where_they_are(self):
        self.write("shapes.txt", "circle t 0.4 0.5 0.2\n")
        self.succeed("mesh", "--sites", 200, "--inclusions", "shapes.txt", "--origin", "30.25,0", "--tolerance", "1e-3",
                     *outputs("glb"))
        self.assertIn("1 inclusions", self.succeed("check", "t.glb", "--inclusions", "shapes.txt"))
        self.succeed("mesh", "--sites", 100, "--density", "1 + 3 * u", "--origin", "30.25,0", *outputs("glb"), "--force")
        self.assertIn("centroidal Voronoi", self.succeed("check", "t.glb", "--cvt", "1e-4", "--density", "1 + 3 * u"))


class Rounding(CliTest):
    """Tolerances follow from the rounding of positions."""

    def test_boxes_of_lattices_that_are_not_reduced(self):
        for lattice in ("1,0.3,2.2,1.1", "-0.31,0.95,-0.86,1.81", "1,0,20.37,0.81"):
            for seed in range(4):
                self.succeed("mesh", "--sites", 20 + 80 * (seed % 2), f"--lattice={lattice}", "--outline", "box", "--seed", seed,
                             "--max-iterations", 2, *outputs("glb", "gltf"), "--force")

    def test_outlines_of_triangles_with_holes(self):
        for seed in (3, 6, 7):
            self.succeed("mesh", "--sites", 400, "--fibres", "0.2,5", "--seed", seed, "--hole", "fibre", "--mesh", "delaunay",
                         "--max-iterations", 0, *outputs("glb"), "--force")

    def test_tiny_faces_in_space(self):
        self.write("pair.txt", "0.5 0.5 0.5\n0.50000001 0.5 0.5\n0.2 0.3 0.4\n0.7 0.9 0.1\n")
        # Many of these lie on one sphere.
        self.write("sphere.txt", "".join(f"{0.5 + x} {0.5 + y} {0.5 + z}\n" for x, y, z in (
            (0.3, 0, 0), (-0.3, 0, 0), (0, 0.3, 0), (0, -0.3, 0), (0, 0, 0.3), (0, 0, -0.3), (0.18, 0.24, 0), (-0.18, 0.24, 0),
            (0.18, 0, 0.24), (0, 0.18, -0.24))))
        for options in (("--sites", 8, "--period", "1,1,2", "--seed", 1), ("--sites", 7, *CUBE, "--seed", 7, "--tolerance", "1e-9"),
                        ("--sites", 7, "--lattice", "0,1,1,1,0,1,1,1,0", "--tolerance", "1e-10"),
                        ("--input", "pair.txt", *CUBE, "--max-iterations", 0), ("--input", "sphere.txt", *CUBE, "--max-iterations", 0)):
            for surface in ("cells", "boundary"):
                self.succeed("mesh", *options, "--surface", surface, *outputs("glb"), "--force")
                self.succeed("check", "t.glb")


if __name__ == "__main__":
    main()
