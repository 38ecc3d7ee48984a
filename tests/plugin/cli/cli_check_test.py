"""pcvt check proves the files of pcvt mesh and refuses damaged ones."""

import json
import re
import unittest

from support.cli import CliTest, main

READABLE = ("obj", "ply", "glb", "gltf", "om", "vtu")
TRIANGLES = ("msh", "inp")
OBLIQUE = ("--lattice", "1,0,0.37,0.81")


class Check(CliTest):
    def mesh(self, *arguments):
        self.succeed("mesh", *arguments, "--quiet")

    def test_every_readable_format_is_proved(self):
        outputs = [word for e in READABLE for word in ("-o", f"t.{e}")]
        self.mesh("--sites", 40, *OBLIQUE, "--mesh", "voronoi", "--mesh", "delaunay", *outputs)
        for kind, faces in (("voronoi", 40), ("delaunay", 80)):
            names = [f"t-{kind}.{e}" for e in READABLE]
            lines = self.succeed("check", *names, "--cvt").splitlines()
            self.assertEqual(len(lines), len(READABLE))
            for name, line in zip(names, lines):
                self.assertRegex(line, rf"^{name}: a periodic tile: \d+ vertices, \d+ faces, .*"
                                 r"genus 1 after gluing, area 0\.81.*pairs agree.*within")
                if not name.endswith(("glb", "gltf")):
                    self.assertIn(f" {faces} faces, ", line)

    def test_formats_of_solvers_are_proved(self):
        outputs = [word for e in TRIANGLES for word in ("-o", f"t.{e}")]
        self.mesh("--sites", 40, *OBLIQUE, "--mesh", "delaunay", *outputs)
        for line in self.succeed("check", *(f"t.{e}" for e in TRIANGLES), "--cvt").splitlines():
            self.assertRegex(line, r" 80 faces, .*genus 1.*pairs agree.*Delaunay within")

    def test_grains_of_second_order_are_proved_in_formats_that_hold_them(self):
        names = [f"t.{e}" for e in ("msh", "inp", "vtu")]
        outputs = [word for name in names for word in ("-o", name)]
        for outline in ("whole", "box"):
            self.mesh("--sites", 12, *OBLIQUE, "--mesh", "grains", "--order", 2, "--force",
                      "--outline", outline, "--tolerance", "1e-3", *outputs)
            for line in self.succeed("check", *names).splitlines():
                self.assertRegex(line, r"genus 1 after gluing, area 0\.81.*pairs agree")

    def target_areas(self, n):
        areas = [1 + (7 * k) % 11 / 5 for k in range(n)]
        self.write("areas.txt", "".join(f"{a}\n" for a in areas))
        return areas

    def test_power_cells_are_proved_with_their_areas(self):
        areas = self.target_areas(40)
        outputs = [word for e in (*READABLE, "foam") for word in ("-o", f"t.{e}")]
        self.mesh("--sites", 40, *OBLIQUE, "--areas", "areas.txt", "--max-iterations", 3, *outputs)
        names = [f"t.{e}" for e in (*READABLE, "foam")]
        for line in self.succeed("check", *names, "--areas", "areas.txt").splitlines():
            self.assertRegex(line, r", 40 sites agree, power cells, areas of 40 cells within "
                                   r"\S+ of areas\.txt \(tolerance \S+\)$")
        self.write("other.txt", "".join(f"{a}\n" for a in reversed(areas)))
        self.refuse(2, r"^t\.obj: not a periodic tile: law of the areas: the cell of site \d+ has",
                    "check", "t.obj", "--areas", "other.txt")
        self.write("few.txt", "1\n2\n")
        self.refuse(2, r"^few\.txt.*40", "check", "t.obj", "--areas", "few.txt")

    def test_diameters_are_areas_too_and_each_mesh_carries_the_weights(self):
        self.write("sizes.txt", "diameter\n" + "".join(f"{1 + k / 20}\n" for k in range(20)))
        outputs = [word for e in ("obj", "vtu") for word in ("-o", f"t.{e}")]
        for kind in ("delaunay", "grains"):
            self.mesh("--sites", 20, "--areas", "sizes.txt", "--aspect", "2,30", "--repeat", "2x1",
                      "--mesh", kind, "--force", *outputs, "-o", "t.msh", "-o", "t.inp")
            names = [f"t.{e}" for e in ("obj", "vtu", "msh", "inp")]
            for line in self.succeed("check", *names, "--areas", "sizes.txt").splitlines():
                self.assertRegex(line, r", 20 sites agree, power cells, elongated 2:1 at 30 degrees "
                                       r"as stated, areas of 20 cells within")

    def test_areas_need_a_file_and_weights(self):
        self.target_areas(8)
        self.mesh("--sites", 8, "-o", "t.obj")
        self.refuse(2, r"^t\.obj: states no weights of its sites", "check", "t.obj", "--areas",
                    "areas.txt")
        self.refuse(2, r"--areas of check takes a file", "check", "t.obj", "--areas", "equal")

    def test_centroidal_power_cells_are_proved(self):
        self.target_areas(30)
        self.mesh("--sites", 30, *OBLIQUE, "--areas", "areas.txt", "--aspect", "3,30", "-o", "t.obj")
        line = self.succeed("check", "t.obj", "--cvt")
        self.assertRegex(line, r"power cells, elongated 3:1 at 30 degrees, centroidal power cells "
                               r"within \S+ h")
        self.mesh("--sites", 30, *OBLIQUE, "--areas", "areas.txt", "--max-iterations", 2, "-o",
                  "u.obj", "-o", "d.obj", "--mesh", "voronoi")
        self.refuse(2, r"^u\.obj: .*lies off the centroid of its cell", "check", "u.obj", "--cvt")
        self.mesh("--sites", 30, *OBLIQUE, "--areas", "areas.txt", "--max-iterations", 2, "-o",
                  "d.obj", "--mesh", "delaunay", "--force")
        self.assertRegex(self.succeed("check", "d.obj", "--cvt"), r", regular within \S+ h")

    def test_elongated_cells_are_proved_in_their_metric(self):
        self.mesh("--sites", 30, "--aspect", "3,30", "-o", "t.obj", "-o", "t.glb", "-o", "t.om")
        for line in self.succeed("check", "t.obj", "t.glb", "t.om", "--cvt").splitlines():
            self.assertRegex(line, r", 30 sites agree, elongated 3:1 at 30 degrees, centroidal "
                                   r"Voronoi within")
        self.write("u.obj", self.path("t.obj").read_text().replace("metric 3 30", "metric 3 31"))
        self.refuse(2, r"^u\.obj: .*law of the sites", "check", "u.obj")

    def test_a_moved_node_and_a_wrong_tie_are_refused(self):
        self.mesh("--sites", 30, "--mesh", "delaunay", "-o", "t.msh", "-o", "t.inp", "-o", "t.vtu")
        for name, pattern, other in (("t.msh", r"^(-?0\.\d+) (-?0\.\d+) 0$", r"0.5 \2 0"),
                                     ("t.inp", r"^(\d+),1,1,(\d+),1,-1,", r"\1,1,1,3,1,-1,"),
                                     ("t.vtu", r"^1 0$", "0 1")):
            text = self.path(name).read_text()
            damaged = re.sub(pattern, other, text, count=1, flags=re.M)
            self.assertNotEqual(damaged, text)
            self.write(name, damaged)
            self.refuse(2, rf"^{name}", "check", name)

    def test_wrong_groups_and_fields_of_solvers_are_refused_with_file_and_field(self):
        self.mesh("--sites", 30, "--mesh", "grains", "-o", "t.msh", "-o", "t.inp", "-o", "t.vtu",
                  "-o", "t.foam")
        for check, path, pattern, other, said in (
                ("t.msh", "t.msh", r"\$Periodic\n(\d+)\n0 (\d+) \d+\n", r"$Periodic\n\1\n0 \2 2\n",
                 r"t\.msh:\d+: \$Periodic has '2' where its tile has"),
                ("t.inp", "t.inp", r"NSET=FIXED\n1\n", "NSET=FIXED\n2\n",
                 r"t\.inp:\d+: \*NSET,NSET=FIXED has '2' where its tile has '1'; "),
                ("t.vtu", "t.vtu", r'"GlobalIds" format="ascii">\n0\n',
                 '"GlobalIds" format="ascii">\n1\n', r"t\.vtu:\d+: PointData/GlobalIds has '1' "),
                ("t.foam", "t.foam/0/T", "cyclic", "empty", r"t\.foam/0/T:\d+: the file has 'empty'")):
            text = self.path(path).read_text()
            damaged = re.sub(pattern, other, text, count=1)
            self.assertNotEqual(damaged, text)
            self.write(path, damaged)
            self.refuse(2, said, "check", check)
            self.write(path, text)
        self.succeed("check", "t.msh", "t.inp", "t.vtu", "t.foam")

    def test_smallest_tiles_are_proved(self):
        for n in (1, 2, 3):
            self.mesh("--sites", n, "--mesh", "voronoi", "--mesh", "delaunay", "-o", f"t{n}.obj", "-o",
                      f"t{n}.glb", "-o", f"t{n}.vtu")
            self.mesh("--sites", n, "--mesh", "delaunay", "-o", f"s{n}.msh", "-o", f"s{n}.inp")
        names = [f"s{n}.{e}" for n in (1, 2, 3) for e in TRIANGLES]
        names += [f"t{n}-{k}.{e}" for n in (1, 2, 3) for k in ("voronoi", "delaunay")
                  for e in ("obj", "glb", "vtu")]
        self.assertEqual(len(self.succeed("check", *names).splitlines()), len(names))

    def test_a_moved_vertex_is_refused(self):
        self.mesh("--sites", 30, "-o", "t.obj")
        text = self.path("t.obj").read_text()
        on_the_seam = int(re.search(r"^# pcvt vertex_pair (\d+)", text, re.M).group(1))
        x = list(re.finditer(r"^v (\S+)", text, re.M))[on_the_seam - 1]
        moved = text[:x.start(1)] + str(float(x.group(1)) + 1e-9) + text[x.end(1):]
        self.write("t.obj", moved)
        self.refuse(2, r"^t\.obj: not a periodic tile: ", "check", "t.obj")

    def test_a_removed_face_is_refused(self):
        self.mesh("--sites", 30, "-o", "t.obj")
        lines = self.path("t.obj").read_text().splitlines(keepends=True)
        lines.remove(next(line for line in lines if line.startswith("f ")))
        self.write("hole.obj", "".join(lines))
        self.refuse(2, r"^hole\.obj", "check", "hole.obj")

    def test_a_wrong_stored_pair_is_refused(self):
        self.mesh("--sites", 30, "-o", "t.gltf")
        document = json.loads(self.path("t.gltf").read_text())
        node = next(n for n in document["nodes"] if "periodic" in n.get("extras", {}))
        node["extras"]["periodic"]["vertexPairs"][0][2] += 1
        self.write("t.gltf", json.dumps(document))
        self.refuse(2, r"^t\.gltf: ", "check", "t.gltf")

    def test_damaged_files_are_refused(self):
        for mesh, extensions in (("voronoi", READABLE), ("delaunay", TRIANGLES)):
            outputs = [word for e in extensions for word in ("-o", f"t.{e}")]
            self.mesh("--sites", 30, "--mesh", mesh, *outputs)
        for e in READABLE + TRIANGLES:
            whole = self.path(f"t.{e}").read_bytes()
            for name, damaged in (("half", whole[:len(whole) // 2]), ("empty", b""),
                                  ("noise", bytes(range(256)) * 8)):
                with self.subTest(f"{name}.{e}"):
                    self.write(f"{name}.{e}", damaged)
                    self.refuse(2, rf"^{name}\.{e}", "check", f"{name}.{e}")

    def test_another_lattice_than_the_stated_one_is_refused(self):
        self.mesh("--sites", 30, "-o", "t.obj")
        self.refuse(2, "states the lattice 1,0,0,1", "check", "t.obj", "--period", "2,1")
        self.succeed("check", "t.obj", "--lattice", "1,0,0,1")

    def test_files_that_cannot_be_read_back_are_refused(self):
        self.mesh("--sites", 3, "-o", "t.svg")
        self.path("folder.obj").mkdir()
        for name in ("t.svg", "t.xyz", "missing.obj", "folder.obj"):
            with self.subTest(name):
                self.refuse(2, f"^{re.escape(name)}: .*; give", "check", name)

    def test_it_continues_after_a_refused_file(self):
        self.mesh("--sites", 3, "-o", "t.obj")
        done = self.run_pcvt("check", "missing.obj", "t.obj")
        self.assertEqual(done.returncode, 2)
        self.assertRegex(done.stderr.decode(), r"^missing\.obj: [^\n]*\n$")
        self.assertRegex(done.stdout.decode(), r"^t\.obj: a periodic tile: [^\n]*\n$")

    def test_the_voronoi_property_of_the_centroids_is_checked_on_request_only(self):
        self.mesh("--sites", 30, "--max-iterations", 0, "-o", "raw.obj")
        self.succeed("check", "raw.obj")
        self.refuse(2, r"^raw\.obj: not a periodic tile: ", "check", "--cvt", "raw.obj")
        self.mesh("--sites", 30, "--tolerance", "1e-9", "-o", "t.obj")
        self.assertIn("t.obj", self.succeed("check", "--cvt", "t.obj"))
        self.succeed("check", "t.obj", "--cvt", "1e-7")
        self.refuse(2, "--cvt 0: ", "check", "t.obj", "--cvt", "0")


if __name__ == "__main__":
    main()
