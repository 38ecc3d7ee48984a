"""Bad input gives one clear line and the right exit code, and leaves all files unchanged."""

import os
import resource
import subprocess
import unittest

from support.cli import CliTest, limit, main

THREE = "0.1 0.2\n0.4 0.9\n0.7 0.3\n"


class BadOption(CliTest):
    def refuse_all(self, code, rows):
        for pattern, *arguments in rows:
            with self.subTest(arguments=arguments):
                self.refuse(code, pattern, *arguments)

    def test_the_command_line_is_refused_in_one_line(self):
        self.refuse_all(
            2,
            [
                ("frobnicate", "frobnicate"),
                ("--frobnicate.*--help", "mesh", "--sites", 3, "--frobnicate"),
                ("stray", "mesh", "--sites", 3, "stray"),
                ("--sites", "mesh", "--sites"),
                ("--sites", "mesh", "--sites", 3, "--sites", 4),
                ("--sites.*--input", "mesh", "-o", "t.obj"),
                ("--sites.*--input", "mesh", "--sites", 3, "--input", "x.txt"),
                ("--period.*--lattice", "mesh", "--sites", 3, "--period", "1,1", "--lattice",
                 "1,0,0,1"),
                ("--seed.*--input", "mesh", "--input", "x.txt", "--seed", 3),
                ("no file", "check"),
            ],
        )

    def test_a_misspelled_word_names_the_nearest_one(self):
        mesh = ("mesh", "--sites", 3)
        self.refuse_all(2, [
            ("^pcvt: unknown option --tolerence; did you mean --tolerance\\?$", *mesh, "--tolerence", 1),
            ("unknown option --seeds; did you mean --seed\\?", *mesh, "--seeds=4"),
            ("unknown option --tolerence; see pcvt pattern --help", "pattern", "--tolerence", 1),
            ("^pcvt: unknown command mehs; did you mean mesh\\?$", "mehs", "--sites", 3),
            ("--sites.*write pcvt mesh --sites", "--sites", 3),
            ("--solver lbgfs: unknown; did you mean lbfgs\\?", *mesh, "--solver", "lbgfs"),
            ("--mesh voronio: unknown; did you mean voronoi\\?", *mesh, "--mesh", "voronio"),
            ("--outline whol: unknown; did you mean whole\\?", *mesh, "--outline", "whol"),
            ("--start rnadom: unknown; did you mean random\\?", *mesh, "--start", "rnadom"),
            ("'tabel1': unknown; did you mean table1\\?", "study", "tabel1"),
            ("unknown extension .ojb; did you mean .obj\\?", *mesh, "-o", "t.ojb"),
        ])

    def test_values_in_several_words_name_the_remedy(self):
        mesh = ("mesh", "--sites", 3)
        self.refuse_all(2, [
            ("b.obj: give each file its own -o$", *mesh, "-o", "a.obj", "b.obj"),
            ("grains: give each kind its own --mesh$", *mesh, "--mesh", "voronoi", "grains"),
            (r"\+: put the formula of --density in quotes$", *mesh, "--density", "1", "+", "u"),
            (r"--period without blanks, as W,H\|auto$", *mesh, "--period", 2, 1),
        ])

    def test_numbers_are_read_strictly(self):
        rows = [(f"--sites {n}: ", "mesh", "--sites", n) for n in ("0", "-3", "1.5", "3x", "1e3")]
        rows += [(f"--seed {s}: ", "mesh", "--sites", 3, "--seed", s) for s in ("-1", "x", "2" * 20)]
        rows += [
            (f"--tolerance {t}: ", "mesh", "--sites", 3, "--tolerance", t)
            for t in ("0", "-1e-6", "nan", "inf", "1e-6x", "1,5")
        ]
        rows += [
            (f"--repeat {r}: ", "mesh", "--sites", 3, "--repeat", r)
            for r in ("2", "0x1", "2x", "x2", "2x3x4", "-1x1", "1.5x1")
        ]
        rows += [
            (f"--origin {o}: ", "mesh", "--sites", 3, "--origin", o) for o in ("1", "1,nan", "1,2,3")
        ]
        rows += [("origin", "mesh", "--sites", 3, "--origin", o) for o in ("1e300,0", "1e9,0")]
        rows += [("origin", "mesh", "--sites", 5, "--lattice", "1,0,999999,1", "--origin", o)
                 for o in ("5000000000,5000", "0,5000")]
        rows += [("origin", "mesh", "--sites", 100000, "--origin", "1048576,0")]
        rows += [("--input: .*empty", "mesh", "--input", "")]
        rows += [(r"--report -: .*\.json", "mesh", "--sites", 3, "--report", "-")]
        rows += [("repeated 3 x 2", "mesh", "--sites", 3, "--lattice", "999999,1,1,0", "--repeat",
                  "3x2")]
        rows += [("repeated 100 x 1", "mesh", "--sites", 1, "--lattice", "1,0,0,1e-5", "--repeat",
                  "100x1")]
        rows += [("--max-iterations -1: ", "mesh", "--sites", 3, "--max-iterations", "-1")]
        rows += [("--threads 0: ", "mesh", "--sites", 3, "--threads", "0")]
        self.refuse_all(2, rows)

    def test_strips_whose_cells_floats_do_not_hold_are_refused(self):
        for n in (1, 2, 3, 8, 30):
            for period in ("1,1e-4", "1,2e-5", "1,1e-5"):
                done = self.run_pcvt("mesh", "--sites", n, "--period", period, "-o", "t.glb", "--quiet")
                self.assertEqual((done.returncode, done.stdout), (2, b""), (n, period))
                self.assertRegex(done.stderr.decode(), r"^pcvt: t\.glb: .*(precision|float32).*another format\n$")
                self.assertEqual(self.contents(), {})

    def test_a_singular_or_non_finite_lattice_is_refused(self):
        periods = ("1,0", "0,1", "-1,1", "1", "1,1,1,1", "1,1x", "1;1", "nan,1", "1,inf", "1e400,1",
                   "1,", "1e200,1", "1,1e-200", "0x10,1")
        rows = [(f"--period {p}: ", "mesh", "--sites", 3, "--period", p) for p in periods]
        lattices = ("1,0,2,0", "0,0,0,1", "1,0,0,nan", "1,0,0,-inf", "1,0,0", "1,0,0,1,1",
                    "1,0,0,1 ", "1,0,1,1e-9")
        rows += [(f"--lattice {v}: ", "mesh", "--sites", 3, "--lattice", v) for v in lattices]
        self.refuse_all(2, rows)

    def test_more_than_the_limit_is_exit_code_4(self):
        self.refuse_all(
            4,
            [
                ("too large", "mesh", "--sites", "268435457"),
                ("too large", "mesh", "--sites", "9" * 30),
                ("cells", "mesh", "--sites", 1000, "--repeat", "1000x1000"),
            ],
        )

    def test_polygons_for_a_format_of_triangles_name_the_remedy(self):
        rows = [(e, "mesh", "--sites", 3, "-o", "t." + e) for e in ("msh", "inp")]
        rows += [(e, "mesh", "--sites", 3, "--mesh", "delaunay", "--mesh", "voronoi", "-o", "t." + e)
                 for e in ("msh", "inp")]
        self.refuse_all(2, [(rf"t\.{e}: .* no polygons; take the mesh delaunay", *row)
                            for e, *row in rows])

    def test_a_tile_too_small_for_its_format_names_the_remedy(self):
        self.refuse(2, r"t\.inp: .* 20 characters .*; choose a unit of length", "mesh", "--sites", 30,
                    "--period", "1e-6,1e-6", "--mesh", "delaunay", "-o", "t.inp")

    def test_unknown_choices_are_refused(self):
        mesh = ("mesh", "--sites", 3)
        self.refuse_all(
            2,
            [
                ("--mesh hexes", *mesh, "--mesh", "hexes"),
                ("twice", *mesh, "--mesh", "voronoi", "--mesh", "voronoi"),
                ("--solver magic", *mesh, "--solver", "magic"),
                ("--start here", *mesh, "--start", "here"),
                ("--outline round", *mesh, "--outline", "round"),
            ],
        )


class BadFile(CliTest):
    def test_a_bad_site_file_is_refused_with_its_line(self):
        bad = {
            "NaN": "0 0\n0.5 nan\n", "Inf": "0 0\ninf 1\n", "decimal comma": "0 0\n1,5 2\n",
            "one column": "0 0\n0.5\n", "three columns": "0 0\n1 2 3\n", "words": "0 0\nx y\n",
            "huge": "0 0\n1e400 0\n", "far": "0 0\n1e30 0\n", "hex": "0 0\n0x10 0\n",
        }
        for name, text in bad.items():
            with self.subTest(name):
                self.write("sites.txt", text)
                self.refuse(2, r"^sites\.txt:2: .*; ", "mesh", "--input", "sites.txt", "-o", "t.obj")

    def test_a_file_without_sites_is_refused(self):
        self.path("folder").mkdir()
        self.write("empty", "")
        self.write("comments", "# nothing\n\n")
        self.write("binary", bytes(range(256)))
        for name in ("folder", "empty", "comments", "binary", "missing"):
            with self.subTest(name):
                self.refuse(2, f"^{name}:(1:)? ", "mesh", "--input", name, "-o", "t.obj")

    def test_an_empty_standard_input_is_refused(self):
        self.refuse(2, "standard input", "mesh", "--input", "-", input=b"")

    def test_duplicates_name_both_lines(self):
        exact = self.write("exact", "# two\n0.1 0.2\n0.5 0.5\n\n0.1 0.2\n")
        self.refuse(2, r"^exact:5: .*\b2\b.*; remove", "mesh", "--input", exact, "-o", "t.obj")
        modulo = self.write("modulo", "0.25 0.5\n0.5 0.5\n-1.75 3.5\n")
        self.refuse(2, r"^modulo:3: .*\b1\b.*; remove", "mesh", "--input", modulo, "-o", "t.obj")


class BadOutput(CliTest):
    def test_an_unknown_extension_names_the_known_ones(self):
        for name in ("t.xyz", "t", "obj", ".obj", "-"):
            with self.subTest(name):
                self.refuse(2, r"extension.*\.obj.*\.glb.*\.txt", "mesh", "--sites", 3, "-o", name)

    def test_an_existing_output_is_refused_before_any_computing(self):
        for name in ("t.obj", "t.mtl", "t.seam.json", "run.json", "s.txt"):
            with self.subTest(name):
                self.write(name, "precious")
                self.refuse(3, f"{name}.*exists.*--force", "mesh", "--sites", 3000000, "-o",
                            "t.obj", "--report", "run.json", "-o", "s.txt", timeout=10)
                self.path(name).unlink()

    def test_one_path_cannot_serve_twice(self):
        self.write("s.txt", THREE)
        mesh = ("mesh", "--input", "s.txt", "--force")
        self.refuse(2, "another output", *mesh, "-o", "t.obj", "-o", "./t.obj")
        self.refuse(2, "another output", *mesh, "-o", "t.obj", "--report", "t.seam.json")
        self.refuse(2, "an input", *mesh, "-o", "s.txt")
        os.symlink(self.path("s.txt"), self.path("link.txt"))
        self.refuse(2, "an input", *mesh, "-o", "link.txt")

    def test_an_unwritable_place_is_refused(self):
        self.path("t.obj").mkdir()
        for name in ("t.obj", "/dev/null/t.obj", "/proc/t.obj", "/proc/none/t.obj"):
            with self.subTest(name):
                self.refuse(3, name, "mesh", "--sites", 3, "-o", name, "--force")

    def test_missing_folders_are_made_when_the_files_appear(self):
        self.succeed("mesh", "--sites", 8, "-o", "out/deep/t.obj", "-o", "cases/a/t.foam",
                     "--report", "runs/r.json")
        self.succeed("check", "out/deep/t.obj", "cases/a/t.foam")
        self.assertTrue(self.path("runs/r.json").is_file())
        self.succeed("mesh", "--sites", 8, "-o", "t.foam/notes/t.ply", "-o", "t.foam")
        self.succeed("check", "t.foam", "t.foam/notes/t.ply")

    def test_a_failing_run_makes_no_folder(self):
        for name in ("new/t.ply", "new/deep/t.foam"):
            with self.subTest(name):
                self.refuse(3, name, "mesh", "--sites", 300, "-o", name,
                            preexec_fn=limit(resource.RLIMIT_FSIZE, 4096))
                self.assertEqual(list(self.folder.iterdir()), [])
        for names in (("x.ply", "x.ply/t.ply"), ("x.ply/t.ply", "x.ply")):
            outputs = [word for name in names for word in ("-o", f"new/{name}")]
            self.refuse(2, "lies in another file of the run, or holds one", "mesh", "--sites", 8,
                        *outputs)
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_a_folder_that_cannot_be_made_is_named_before_any_computing(self):
        name = "n" * 256
        self.refuse(3, f"folder {name}: File name too long", "mesh", "--sites", 3000000, "-o",
                    f"{name}/t.obj", timeout=10)

    @unittest.skipIf(os.geteuid() == 0, "root may write everywhere")
    def test_a_folder_without_permission_is_refused(self):
        self.path("closed").mkdir(mode=0o500)
        self.refuse(3, "closed/t.obj", "mesh", "--sites", 3, "-o", "closed/t.obj")

    def test_a_size_limit_leaves_nothing_new_and_keeps_existing_files(self):
        self.write("t.ply", "precious")
        for name in ("t.obj", "t.ply", "t.glb", "t.om", "t.svg"):
            with self.subTest(name):
                self.refuse(3, name, "mesh", "--sites", 300, "--force", "-o", name, "--quiet",
                            preexec_fn=limit(resource.RLIMIT_FSIZE, 4096))

    def test_a_full_disk_leaves_nothing(self):
        # Only the child sees the disk of 16 KiB; files left on it are listed on standard output.
        own_disk = ["unshare", "-rm", "sh", "-c",
                    'mount -t tmpfs -o size=16k pcvt disk && { "$0" "$@"; code=$?; ls -A disk; '
                    "exit $code; }"]
        self.path("disk").mkdir()
        probe = subprocess.run([*own_disk, "true"], cwd=self.folder, capture_output=True, check=False)
        if probe.returncode != 0:
            self.skipTest("no disk can be mounted here")
        done = subprocess.run([*own_disk, self.binary(), "mesh", "--sites", "1000", "-o", "disk/t.obj",
                               "--max-iterations", "3"],
                              cwd=self.folder, capture_output=True, check=False)
        self.assertEqual((done.returncode, done.stdout), (3, b""), done.stderr)
        self.assertRegex(done.stderr.decode(), r"^pcvt: .*disk/t\.obj.*No space left[^\n]*\n$")

    def run_without_output(self, redirection, *arguments):
        shell = ["sh", "-c", f'exec "$0" "$@" {redirection}', self.binary(), "mesh", "--sites", "3"]
        done = subprocess.run([*shell, *arguments], cwd=self.folder, stderr=subprocess.PIPE,
                              check=False)
        self.assertEqual(done.returncode, 3)
        return done.stderr.decode()

    def test_a_full_or_closed_standard_output_is_reported_with_the_files_written(self):
        for redirection in (">/dev/full", ">&-"):
            with self.subTest(redirection):
                line = self.run_without_output(redirection, "-o", "t.ply", "--force")
                self.assertRegex(line, r"^pcvt: standard output: .*; the files are written\n$")
                self.succeed("check", "t.ply")
                self.path("t.ply").unlink()
                line = self.run_without_output(redirection)
                self.assertRegex(line, r"^pcvt: standard output: [^;]*\n$")
                self.assertEqual(self.contents(), {})

    def test_too_little_memory_is_exit_code_4(self):
        little = limit(resource.RLIMIT_AS, 200 << 20)
        if self.run_pcvt("--version", preexec_fn=little).returncode != 0:
            self.skipTest("this build does not start in so little memory")
        self.refuse(4, "memory", "mesh", "--sites", 20000000, "-o", "t.obj", preexec_fn=little)


if __name__ == "__main__":
    main()
