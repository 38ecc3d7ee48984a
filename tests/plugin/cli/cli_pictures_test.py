"""pcvt mesh --colour and --background: files with colours, and refusals."""

import json
import re

from support.cli import CliTest, main

GRADED = ("--density", "1 + 9 * u * (1 - u)")


class Colours(CliTest):
    def picture(self, name):
        return self.path(name).read_text()

    def test_each_colouring_shows_its_quantity(self):
        for word, legend in (("sides", ">6 sides: "), ("size", " h: "), ("cells", ">seam (1, 0)<"),
                             ("density", "by density</title>")):
            self.succeed("mesh", "--sites", 60, *GRADED, "--colour", word, "--quiet", "-o",
                         f"{word}.svg", "-o", f"{word}.html")
            self.assertIn(legend, self.picture(f"{word}.svg"))
            self.assertIn(f'"colouring": "{word}"', self.picture(f"{word}.html"))

    def test_meshes_have_the_same_colours_as_pictures(self):
        self.succeed("mesh", "--sites", 60, "--colour", "cells", "--quiet", "-o", "t.svg", "-o",
                     "t.obj", "-o", "t.ply", "-o", "t.gltf")
        in_picture = set(re.findall(r'<path fill="#(\w{6})"', self.picture("t.svg")))
        self.assertGreaterEqual(len(in_picture), 4)
        kinds = re.findall(r"newmtl (cell_colour_\d)\nKd (\S+) (\S+) (\S+)", self.picture("t.mtl"))
        in_obj = {"".join(f"{round(255 * float(part)):02x}" for part in rgb) for _, *rgb in kinds}
        self.assertEqual(in_obj, in_picture)
        faces = [line.split() for line in self.picture("t.ply").splitlines()[-120:-60]]
        in_ply = {"".join(f"{int(part):02x}" for part in face[-4:-1]) for face in faces}
        self.assertEqual(in_ply, in_picture)
        materials = json.loads(self.picture("t.gltf"))["materials"]
        in_gltf = {tuple(m["pbrMetallicRoughness"]["baseColorFactor"]) for m in materials
                   if m["name"].startswith("cell")}
        self.assertEqual(len(in_gltf), len(in_picture))

    def test_phases_have_colours_materials_and_a_legend(self):
        run = ("mesh", "--sites", 40, "--phases", "alpha:0.4,beta:0.6", "--quiet", "--force")
        self.succeed(*run, "--colour", "phase", "--glb-nodes", "one", "-o", "t.svg", "-o", "t.obj", "-o", "t.glb", "-o", "t.ply",
                     "-o", "t.png", "-o", "t.html", "--cells", "c.csv")
        table = self.picture("c.csv")
        for name in ("alpha", "beta"):
            self.assertIn(f">{name}: {table.count(f',{name},')}<", self.picture("t.svg"))
        self.assertEqual(re.findall(r"newmtl (\S+)", self.picture("t.mtl")), ["phase_alpha", "phase_beta"])
        for name in (b"phase_alpha", b"phase_beta"):
            self.assertIn(name, self.path("t.glb").read_bytes())
        self.assertIn('"phases": ["alpha", "beta"]', self.picture("t.html"))
        # Pictures show phases by default.
        self.succeed(*run, "-o", "u.svg")
        self.assertEqual(self.picture("u.svg"), self.picture("t.svg"))
        self.refuse(2, "--colour phase needs --phases or --inclusions", "mesh", "--sites", 9, "--colour", "phase", "-o", "v.svg")

    def test_tags_of_inclusions_are_the_default_and_a_choice(self):
        run = ("mesh", "--sites", 200, "--fibres", "0.3,3", "--tolerance", "1e-3", "--quiet")
        self.succeed(*run, "-o", "default.svg")
        self.succeed(*run, "--colour", "tag", "-o", "tag.svg")
        self.succeed(*run, "--colour", "sides", "-o", "sides.svg")
        self.assertIn("200 cells by tag", self.picture("tag.svg"))
        self.assertEqual(self.picture("default.svg"), self.picture("tag.svg"))
        self.assertIn("fibre: ", self.picture("tag.svg"))
        self.assertNotIn("by tag", self.picture("sides.svg"))
        self.refuse(2, "--colour tag needs --inclusions or --fibres", "mesh", "--sites", 9, "--colour", "tag", "-o", "v.svg")

    def test_every_grain_has_one_colour(self):
        self.succeed("mesh", "--sites", 12, "--mesh", "grains", "--colour", "cells", "--quiet",
                     "-o", "t.ply")
        header, body = self.picture("t.ply").split("end_header\n")
        n_vertices, n_faces = (int(re.search(rf"element {name} (\d+)", header)[1])
                               for name in ("vertex", "face"))
        colour_of = {}
        for line in body.splitlines()[n_vertices:n_vertices + n_faces]:
            *_, r, g, b, site = line.split()
            self.assertEqual(colour_of.setdefault(site, (r, g, b)), (r, g, b))
        self.assertEqual(len(colour_of), 12)
        self.assertGreaterEqual(len(set(colour_of.values())), 4)

    def test_a_background_fills_the_picture(self):
        for word, has_rect in (("none", False), ("#0d1117", True)):
            self.succeed("mesh", "--sites", 9, "--background", word, "--quiet", "--force", "-o",
                         "t.svg")
            self.assertEqual('fill="#0d1117"/>' in self.picture("t.svg"), has_rect)
            self.assertEqual("@media" in self.picture("t.svg"), not has_rect)

    def test_what_cannot_be_shown_is_refused(self):
        for pattern, arguments in (
            ("--colour density needs --density; add it", ("--colour", "density", "-o", "t.svg")),
            ("no output takes a colouring; add one of .obj or .ply", ("--colour", "size", "-o", "t.vtu")),
            ("no output takes a background; add one of .svg,", ("--background", "#ffffff", "-o", "t.obj")),
            ("background white: not a colour; take none or #rrggbb",
             ("--background", "white", "-o", "t.svg")),
            ("--colour sise: unknown; did you mean size", ("--colour", "sise", "-o", "t.svg")),
        ):
            with self.subTest(arguments):
                self.refuse(2, pattern, "mesh", "--sites", 9, *arguments)
        self.assertEqual(self.contents(), {})


if __name__ == "__main__":
    main()
