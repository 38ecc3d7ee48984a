"""pcvt mesh --outline box and --mesh grains: files, proofs, reports and refusals."""

import json
import re
import unittest

from support.cli import CliTest, main, outputs

READABLE = ("obj", "ply", "glb", "gltf", "om")
OBLIQUE = ("--lattice", "1,0,0.37,0.81")
GRAINS = ("mesh", "--sites", 30, "--mesh", "grains")
BOX = ("mesh", "--sites", 30, "--outline", "box")


class Outlines(CliTest):
    def prove(self, *names):
        lines = self.succeed("check", *names).splitlines()
        self.assertEqual(len(lines), len(names))
        for line in lines:
            self.assertRegex(line, "a periodic tile: .* genus 1 after gluing")
        return lines

    def test_both_meshes_in_both_outlines_are_proved_in_every_format(self):
        for outline in ("whole", "box"):
            self.succeed("mesh", "--sites", 40, *OBLIQUE, "--mesh", "voronoi", "--mesh", "grains",
                         "--outline", outline, "--force", "--quiet", *outputs(*READABLE, "svg"))
            self.prove(*(f"t-{kind}.{e}" for kind in ("voronoi", "grains") for e in READABLE))

    def test_small_numbers_on_an_unreduced_basis_are_proved(self):
        for n in (1, 2, 3):
            self.succeed("mesh", "--sites", n, "--lattice", "1,0,7,1", "--outline", "box", "--mesh",
                         "voronoi", "--mesh", "grains", "--quiet", "-o", f"t{n}.obj")
        self.prove(*(f"t{n}-{kind}.obj" for n in (1, 2, 3) for kind in ("voronoi", "grains")))

    def test_a_repeated_box_is_proved(self):
        self.succeed(*BOX, "--repeat", "2x3", "--mesh", "grains", "--quiet", "-o", "t.ply")
        self.assertIn(" area 6 ", self.prove("t.ply")[0])

    def expect_corner(self, corner, *origin):
        self.succeed(*BOX, *origin, "--quiet", "--force", "-o", "t.obj")
        points = [tuple(map(float, line.split()[1:3]))
                  for line in self.path("t.obj").read_text().splitlines() if line.startswith("v ")]
        x, y = corner
        left, right = ({q for p, q in points if p == side} for side in (x, x + 1))
        self.assertEqual(left, right)
        self.assertEqual({min(left), max(left)}, {y, y + 1})
        self.assertEqual({p for p, q in points if q == y}, {p for p, q in points if q == y + 1})
        self.assertGreater(len(left), 5)

    def test_the_box_has_its_corner_at_the_given_origin(self):
        self.expect_corner((0.25, -0.5), "--origin", "0.25,-0.5")

    def test_the_box_has_its_corner_at_zero_by_default(self):
        self.expect_corner((0, 0))

    def test_origin_auto_makes_the_shortest_edge_of_the_cut_longer(self):
        shortest = []
        for origin in ("0,0", "auto"):
            self.succeed(*BOX, "--origin", origin, "--report", "r.json", "--quiet", "--force")
            shortest.append(json.loads(self.path("r.json").read_text())["box_shortest_edge"])
        self.assertGreater(shortest[1], 2 * shortest[0])

    def test_the_report_describes_the_cut_and_the_grains(self):
        self.succeed(*BOX, "--origin", "auto", "--mesh", "grains", "--report", "run.json", "--quiet")
        report = json.loads(self.path("run.json").read_text())
        self.assertGreater(report["box_shortest_edge"], 0.02)
        self.assertLess(report["box_shortest_edge"], 0.5)
        self.assertGreater(report["grains"]["triangles"], 300)
        self.assertGreater(report["grains"]["smallest_angle"], 20)
        for site, x, y, angle in report["grains"]["sharp_corners"]:
            self.assertTrue(0 <= site < 30 and angle <= 60)

    def test_size_sets_the_number_of_triangles(self):
        counts = []
        for size in (0.04, 0.02):
            self.succeed(*GRAINS, "--size", size, "--report", "r.json", "--quiet", "--force")
            counts.append(json.loads(self.path("r.json").read_text())["grains"]["triangles"])
        self.assertTrue(3 * counts[0] < counts[1] < 5 * counts[0], counts)

    def test_per_edge_sets_the_parts_of_each_edge(self):
        counts = []
        for parts in (2, 4):
            self.succeed(*GRAINS, "--per-edge", parts, "-o", "t.ply", "--report", "r.json", "--quiet", "--force")
            counts.append(json.loads(self.path("r.json").read_text())["grains"]["triangles"])
            self.prove("t.ply")
        self.assertTrue(3 * counts[0] < counts[1] < 5 * counts[0], counts)

    def test_same_input_gives_same_bytes(self):
        run = (*BOX, "--mesh", "grains", "--force", "--quiet", *outputs("obj", "om", "glb", "svg"))
        self.succeed(*run, "--threads", 1)
        first = self.contents()
        self.succeed(*run, "--threads", 3)
        self.assertEqual(first, self.contents())

    def test_grains_store_their_site_in_every_format(self):
        self.succeed(*GRAINS, "--quiet", *outputs("ply", "obj"))
        faces = self.path("t.ply").read_text().split("end_header\n")[1].splitlines()
        sites = [int(line.split()[-1]) for line in faces if line.startswith("3 ")]
        self.assertEqual(set(sites), set(range(30)))
        text = self.path("t.obj").read_text()
        self.assertIn("# pcvt kind grains\n", text)
        stated = [int(w) for row in re.findall("# pcvt sites (.*)", text) for w in row.split()]
        self.assertEqual(sorted(stated), sorted(sites))

    def test_a_damaged_box_is_refuted(self):
        self.succeed(*BOX, "--origin", "0,0", "--mesh", "grains", "--quiet", "-o", "t.ply")
        text = self.path("t.ply").read_text()
        self.write("moved.ply", text.replace("\n0 0.", "\n1e-9 0.", 1))
        self.refuse(2, "moved.ply: not a periodic tile: law", "check", "moved.ply")

    def test_wrong_requests_name_the_remedy(self):
        mesh = ("mesh", "--sites", 9)
        for pattern, *arguments in (
            ("cannot cut Delaunay triangles; take --mesh grains, or --outline whole", *mesh, "--outline", "box", "--mesh",
             "delaunay"),
            ("--size is for grains; add --mesh grains", *mesh, "--size", 0.1),
            ("--per-edge is for grains; add --mesh grains", *mesh, "--per-edge", 2),
            ("--per-edge replaces --size", *mesh, "--mesh", "grains", "--size", 0.1, "--per-edge", 2),
            ("--per-edge 0: ", *mesh, "--mesh", "grains", "--per-edge", 0),
            ("--order is for grains; add --mesh grains", *mesh, "--order", 2),
            ("--order 3: unknown; take 1 or 2", *mesh, "--mesh", "grains", "--order", 3),
            ("--size 0: not above 0", *mesh, "--mesh", "grains", "--size", 0),
            ("--outline ragged: unknown; take whole or box", *mesh, "--outline", "ragged"),
            ("order 2; add one of", *mesh, "--mesh", "grains", "--order", 2, "-o", "t.obj"),
        ):
            self.refuse(2, pattern, *arguments)
        self.refuse(4, "grains of that size.*take larger", *mesh, "--mesh", "grains", "--size", 1e-6)

    def test_grains_are_refused_for_the_voronoi_property(self):
        self.succeed(*GRAINS, "--quiet", *outputs("obj", "glb"))
        for name in ("t.obj", "t.glb"):
            self.refuse(2, "grains are neither", "check", name, "--cvt")


if __name__ == "__main__":
    main()
