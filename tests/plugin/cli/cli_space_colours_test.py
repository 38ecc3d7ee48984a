"""Colours, materials and zones in files of cells in space."""

import json
import re
import struct

from support.cli import CliTest, main

CUBE = ("--period", "1,1,1", "--max-iterations", 5)
RUN = ("mesh", "--sites", 40, *CUBE, "--force")
MATERIALS = ("--phases", "soft:0.3,hard:0.7", "--orientations", "random")
SURFACES = ("t.obj", "t.ply", "t.glb")


def outputs(*names):
    return [word for name in names for word in ("-o", name)]


class Colours(CliTest):
    def glb(self, name):
        """The JSON of a GLB."""
        data = self.path(name).read_bytes()
        (length,) = struct.unpack_from("<I", data, 12)
        return json.loads(data[20:20 + length])

    def test_each_colouring_gives_files_that_are_proved(self):
        for colour in ("faces", "size", "cells", "phase", "orientation"):
            self.succeed(*RUN, *MATERIALS, "--colour", colour, *outputs(*SURFACES, "t.svg", "t.png"))
            for name in SURFACES:
                self.succeed("check", name)
            text = self.path("t.obj").read_text()
            prefix = {"cells": "cell_colour", "orientation": "ipf"}.get(colour, colour)
            used = re.findall(r"^usemtl (.*)$", text, re.M)
            self.assertTrue(used and all(name.startswith(prefix + "_") for name in used), used)
            # Each cell has one material.
            self.assertEqual(len(used), 40)
            defined = re.findall(r"^newmtl (.*)$", self.path("t.mtl").read_text(), re.M)
            self.assertEqual(sorted(set(used)), sorted(defined))
            names = [material["name"] for material in self.glb("t.glb")["materials"]]
            self.assertTrue(set(used) <= set(names))

    def test_materials_of_glb_are_those_of_the_table(self):
        self.succeed(*RUN, *MATERIALS, "--colour", "phase", "-o", "t.glb", "--cells", "t.csv")
        glb = self.glb("t.glb")
        periodic = glb["nodes"][0]["extras"]["periodic"]
        rows = [line.split(",") for line in self.path("t.csv").read_text().splitlines() if not line.startswith("#")]
        phase = rows[0].index("phase")
        names = [periodic["phases"][k] for k in periodic["sitePhases"]]
        self.assertEqual(names, [row[phase] for row in rows[1:]])
        self.assertEqual([f"{x:.6g}" for x in periodic["orientations"][7]],
                         [f"{float(x):.6g}" for x in rows[8][phase + 2:phase + 5]])
        of_cells = [glb["materials"][glb["meshes"][node["mesh"]]["primitives"][0]["material"]]["name"]
                    for node in glb["nodes"][1:]]
        self.assertEqual(of_cells, [f"phase_{name}" for name in names])

    def test_sizes_are_those_of_prescribed_volumes(self):
        self.succeed("mesh", "--sites", 60, "--period", "1,1,1", "--volumes", "lognormal:0.35", "--colour", "size",
                     *outputs("t.obj", "t.ply", "t.glb", "t.foam", "t.svg"), "--force")
        self.succeed("check", "t.glb")
        self.assertRegex(self.succeed("check", "t.foam"), "power cells of 60 sites")
        self.assertRegex(self.succeed("check", "t.obj"), "power cells of 60 sites")
        self.assertRegex(self.succeed("check", "t.ply"), "power cells of 60 sites")
        svg = self.path("t.svg").read_text()
        counts = [int(n) for n in re.findall(r" h: (\d+)<", svg)]
        self.assertEqual(sum(counts), 60)
        self.assertGreater(len(counts), 3)

    def test_the_default_shows_materials(self):
        self.succeed(*RUN, "--orientations", "random", "-o", "t.obj")
        self.assertIn("usemtl ipf_", self.path("t.obj").read_text())
        self.succeed(*RUN, *MATERIALS, "-o", "t.obj", "-o", "t.glb")
        self.assertIn("usemtl phase_", self.path("t.obj").read_text())
        self.succeed(*RUN, "-o", "t.obj")
        self.assertIn("usemtl faces_", self.path("t.obj").read_text())

    def test_impossible_colours_are_refused(self):
        for colour, words in (("sides", "--colour sides: not for three dimensions; take size, cells, phase, faces or orientation"),
                              ("tag", "--colour tag: not for three dimensions"),
                              ("phase", "--colour phase needs --phases"),
                              ("orientation", "--colour orientation needs --orientations; add it")):
            self.refuse(2, words, *RUN, "--colour", colour, "-o", "t.obj")
        self.refuse(2, "--colour faces is for three dimensions", "mesh", "--sites", 9, "--colour", "faces", "-o", "p.obj")
        self.refuse(2, "no output takes a colouring; add one of .obj or .ply or .glb or .svg or .png", *RUN, "--colour",
                    "size", "-o", "t.vtu")
        self.refuse(2, "--surface boundary has the colours of its seam", *RUN, "--colour", "size", "--surface", "boundary",
                    "-o", "t.obj")

    def test_threads_do_not_change_files(self):
        files = {}
        for threads in (1, 2):
            self.succeed(*RUN, *MATERIALS, "--threads", threads, "--colour", "cells", *outputs(*SURFACES, "t.svg"))
            files[threads] = self.contents()
        self.assertEqual(files[1], files[2])


class Zones(CliTest):
    def test_cases_have_a_zone_for_each_phase(self):
        self.succeed(*RUN, *MATERIALS, "-o", "t.foam", "--cells", "t.csv")
        self.succeed("check", "t.foam")
        rows = [line.split(",") for line in self.path("t.csv").read_text().splitlines() if not line.startswith("#")]
        phase = rows[0].index("phase")
        text = self.path("t.foam/constant/polyMesh/cellZones").read_text()
        for name in ("soft", "hard"):
            cells = re.search(rf"^phase_{name}\n{{\n.*\n.*\n\d+\n\(\n([\d\n]*)\n\)", text, re.M)[1].split()
            self.assertEqual([int(s) for s in cells],
                             [s for s, row in enumerate(rows[1:]) if row[phase] == name])
        self.write("t.foam/constant/polyMesh/cellZones", text.replace("phase_soft", "phase_sft"))
        self.refuse(2, "cellZones:.*phase_sft", "check", "t.foam")


if __name__ == "__main__":
    main()
