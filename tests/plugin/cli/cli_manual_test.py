"""pcvt help: the pages of the manual and the completion of the command line."""

import json
import os
import pathlib
import pty
import re
import select
import shutil
import subprocess
import unittest

from support.cli import CliTest, main

ROOT = pathlib.Path(__file__).resolve().parents[3]
COMMANDS = ("mesh", "pattern", "study", "check", "help")


def options_of(help_text):
    """Returns the names of the options at the beginnings of the lines of a help."""
    heads = re.findall(r"^  (-\S+)", help_text, re.MULTILINE)
    return [name for head in heads for name in head.split(",")]


class Pages(CliTest):
    def page(self, *command):
        return self.succeed("help", "--man", *command)

    def shown(self, page):
        """Returns the page as text; a warning of the formatter fails."""
        done = subprocess.run(["groff", "-man", "-Tascii", "-ww", "-P-c", "-P-b", "-P-o", "-P-u"],
                              input=page.encode(), capture_output=True, check=True)
        self.assertEqual(done.stderr.decode(), "")
        return done.stdout.decode()

    def test_each_option_of_the_help_is_in_the_page(self):
        for command in [(), *((name,) for name in COMMANDS)]:
            with self.subTest(command):
                options = options_of(self.succeed(*command, "--help"))
                self.assertIn("--help", options)
                text = self.shown(self.page(*command))
                for option in options:
                    self.assertRegex(text, rf"(?m)^ +(-h, )?{option}( |,|$)")

    def test_examples_are_as_in_the_help(self):
        for command in COMMANDS[:4]:
            with self.subTest(command):
                text = self.shown(self.page(command))
                examples = re.findall(r"^  (pcvt .*)", self.succeed(command, "--help"), re.MULTILINE)
                self.assertGreater(len(examples), 2)
                for example in examples:
                    self.assertIn(example, text)

    def test_the_page_of_pcvt_lists_commands_formats_and_exit_codes(self):
        text = self.shown(self.page())
        for words in ("COMMANDS", "EXIT CODES", "FORMATS", "OpenFOAM, a case folder", "DENSITIES",
                      "CONDITION ? A : B", "pcvt-study(1)"):
            self.assertIn(words, text)

    @unittest.skipUnless(shutil.which("mandoc"), "mandoc is not installed")
    def test_mandoc_finds_no_fault(self):
        for command in [(), *((name,) for name in COMMANDS)]:
            done = subprocess.run(["mandoc", "-Tlint", "-Wwarning"], input=self.page(*command).encode(),
                                  capture_output=True, check=False)
            # Pages have no date, so that the same source gives the same page.
            faults = [line for line in done.stdout.decode().splitlines()
                      if "missing date" not in line]
            self.assertEqual(faults, [])

    def test_completion_takes_no_topic(self):
        self.refuse(2, "--completion takes neither a topic nor --man", "help", "mesh", "--completion", "bash")

    def test_an_unknown_page_is_refused(self):
        self.refuse(2, "did you mean mesh", "help", "--man", "mehs")
        self.refuse(2, "takes a command", "help", "--man", "cooking")


class Options(CliTest):
    """pcvt help --options json."""

    # A value for each option that is for the plane only.
    VALUES = {"--areas": "equal", "--aspect": 2, "--background": "none", "--budget": 9, "--cells": "a.csv",
              "--coriolis": 1, "--cut": 9, "--density": 1, "--density-range": "1,2", "--fibres": "0.2,3",
              "--fixed": "a.txt", "--hole": "a", "--inclusions": "a.txt", "--material": "same",
              "--orientations": "random", "--origin": "0,0", "--order": 2, "--per-edge": 2, "--phases": "a:1",
              "--pixels": 9, "--retry": 1, "--size": 0.1, "--thickness": 1, "--voxels": "9,9",
              "--weights": "w.txt"}

    def setUp(self):
        super().setUp()
        self.options = json.loads(self.succeed("help", "--options", "json"))
        self.help = self.succeed("mesh", "--help")

    def part(self, name):
        """The help of an option in one line."""
        part = re.search(rf"^  {name}( .*?)(?=^  -|\n\n)", self.help, re.MULTILINE | re.DOTALL)[1]
        return " ".join(part.split())

    def test_options_are_those_of_the_help(self):
        self.assertEqual(list(self.options), [name for name in options_of(self.help) if name not in ("-h", "--help")])
        for name, option in self.options.items():
            with self.subTest(name):
                self.assertTrue(self.part(name).startswith(option["form"]))
                self.assertRegex(self.part(name), re.escape(option["help"]))

    def test_fields_are_those_of_the_header(self):
        header = (ROOT / "plugin" / "pcvt.h").read_text()
        for name, option in self.options.items():
            for field in option["fields"]:
                self.assertRegex(header, rf"\b{field}(\[\d\])?;", name)

    def test_the_help_marks_the_dimensions_of_options_and_of_words(self):
        for name, option in self.options.items():
            with self.subTest(name):
                self.assertEqual(self.part(name).endswith("; plane only"), not option["space"])
                self.assertEqual(self.part(name).endswith("; space only"), not option["plane"])
                for word in option["words"] if option["space"] else ():
                    marked = re.search(rf"[;,] {word['word']}(, \w+)*: plane only", self.part(name))
                    self.assertEqual(marked is not None, not word["space"])
                    marked = re.search(rf"[;,] {word['word']}(, \w+)*: space only", self.part(name))
                    self.assertEqual(marked is not None, option["plane"] and not word["plane"])

    def not_in_space(self, name):
        """Values of an option, each a list of words, that runs in space lack."""
        option = self.options[name]
        words = [[word["word"]] for word in option["words"] if word["number"] is not None and not word["space"]]
        if option["space"] or words:
            return words
        return [[self.VALUES[name]] if option["form"] else []]

    def test_dimensions_are_those_of_runs(self):
        for name in self.options:
            for value in self.not_in_space(name):
                with self.subTest(name, value=value):
                    self.refuse(2, f"{name}.* not for three dimensions", "mesh", "--sites", 9, "--period", "1,1,1",
                                name, *value)

    def test_formats_are_those_that_take_an_option(self):
        self.assertEqual(self.options["--voxels"]["formats"], [".vti"])
        self.assertEqual(self.options["--surface"]["formats"], [".obj", ".ply", ".glb", ".stl"])
        self.assertIsNone(self.options["--walls"]["formats"])
        for name, value in (("--pixels", 9), ("--thickness", 1), ("--cut", 9)):
            expected = ", ".join(self.options[name]["formats"]).replace(", ", "( or |, )")
            self.refuse(2, f"no output takes .*; add one of {expected}", "mesh", "--sites", 9, name, value, "-o", "a.om")

    def test_words_have_the_numbers_of_the_header(self):
        header = (ROOT / "plugin" / "pcvt.h").read_text()
        for name, prefix in (("--start", "START_"), ("--solver", "SOLVER_"), ("--walls", "WALLS_"), ("--mesh", ""),
                             ("--outline", ""), ("--colour", "COLOUR_"), ("--surface", "SURFACE_"),
                             ("--symmetry", "SYMMETRY_"), ("--duplicates", "DUPLICATES_"), ("--element", "")):
            for word in self.options[name]["words"]:
                self.assertRegex(header, rf"\bPCVT_{prefix}{word['word'].upper()} = {word['number']}\b")
        self.assertEqual([word["word"] for word in self.options["--areas"]["words"]], ["equal", "lognormal:S", "gamma:S"])

    def test_mistakes(self):
        self.refuse(2, "--options xml: unknown; take json", "help", "--options", "xml")
        self.refuse(2, "--options takes neither a topic nor --man", "help", "mesh", "--options", "json")


class Bash(CliTest):
    def complete(self, *words):
        """Returns the answers for the last of the words."""
        self.write("bash", self.succeed("help", "--completion", "bash"))
        listed = " ".join(f"'{word}'" for word in ("pcvt", *words))
        done = subprocess.run(
            ["bash", "--norc", "-c", f"source ./bash; COMP_WORDS=({listed}); "
             f"COMP_CWORD={len(words)}; _pcvt; printf '%s\\n' \"${{COMPREPLY[@]}}\""],
            cwd=self.folder, capture_output=True, check=True)
        self.assertEqual(done.stderr.decode(), "")
        return done.stdout.decode().split("\n")[:-1]

    def test_commands_options_and_values(self):
        for words, answers in (
                (["me"], ["mesh"]),
                (["mesh", "--to"], ["--tolerance"]),
                (["mesh", "--mesh", ""], ["voronoi", "delaunay", "grains"]),
                (["mesh", "--mesh", "=", "gr"], ["grains"]),
                (["mesh", "--element", ""], ["CPE", "CPS", "C3D6", "C3D15"]),
                (["check", "--period", ""], [""]),
                (["mesh", "--mesh", "="], ["voronoi", "delaunay", "grains"]),
                (["mesh", "--outline", "b"], ["box"]),
                (["mesh", "--order", ""], ["1", "2"]),
                (["mesh", "--origin", ""], ["auto"]),
                (["mesh", "--sites", ""], [""]),
                (["--quiet", "pattern", "--thr"], ["--threads"]),
                (["pattern", "--tol"], [""]),
                (["study", "fig1"], ["fig10", "fig11"]),
                (["help", "f"], ["formats"]),
                (["--ver"], ["--version"])):
            with self.subTest(words):
                self.assertEqual(self.complete(*words), answers)

    def test_files(self):
        self.write("my sites.txt", "")
        self.write("tile.obj", "")
        for words in (["mesh", "--input", "my"], ["mesh", "-o", "my"], ["check", "my"],
                      ["mesh", "--density", "my"], ["study", "--merge", "my"]):
            with self.subTest(words):
                self.assertEqual(self.complete(*words), ["my sites.txt"])
        self.assertEqual(self.complete("check", "tile.obj", "ti"), ["tile.obj"])

    def test_each_option_of_the_help_is_offered(self):
        for command in COMMANDS:
            offered = self.complete(command, "-")
            self.assertEqual(sorted(offered), sorted(options_of(self.succeed(command, "--help"))))


@unittest.skipUnless(shutil.which("zsh"), "zsh is not installed")
class Zsh(CliTest):
    PREPARE = (b'PS1="> "; fpath=($PWD $fpath); autoload -U compinit; compinit -u -d ./dump; pcvt() { }; '
               b'echo RE""ADY\n')

    def shown(self, master, last):
        """Returns the output of a terminal, without its control sequences, up to the text `last`, or until there is
        no more for 30 seconds."""
        output, text = b"", ""
        while last not in text and select.select([master], [], [], 30)[0]:
            output += os.read(master, 4096)
            text = re.sub(r"\x1b\[[0-9;?]*[a-zA-Z]|\x00|\x07", "", output.decode(errors="ignore"))
        return text

    def screen(self, line, last):
        """Types a line and a tabulator into an interactive zsh and returns its answer."""
        self.write("_pcvt", self.succeed("help", "--completion", "zsh"))
        master, slave = pty.openpty()
        with subprocess.Popen(["zsh", "-f", "-i"], cwd=self.folder, stdin=slave, stdout=slave, stderr=slave,
                              env={**os.environ, "TERM": "vt100"}, start_new_session=True) as shell:
            os.close(slave)
            os.write(master, self.PREPARE)
            # The prompt may come with the line before it.
            if "> " not in self.shown(master, "READY\r").split("READY\r")[-1]:
                self.shown(master, "> ")
            os.write(master, line.encode() + b"\t")
            text = self.shown(master, last)
            shell.kill()
        os.close(master)
        self.assertNotRegex(text, r"_pcvt:\d+|command not found|parse error")
        return text

    def test_commands_options_values_and_files(self):
        self.write("tile.obj", "")
        for line, words in (("pcvt me", ["pcvt mesh "]),
                            ("pcvt mesh --tole", ["pcvt mesh --tolerance "]),
                            ("pcvt mesh --mesh ", ["delaunay", "grains", "voronoi"]),
                            ("pcvt mesh --outline b", ["pcvt mesh --outline box "]),
                            ("pcvt check ti", ["pcvt check tile.obj "]),
                            ("pcvt study fig1", ["fig10", "fig11"])):
            with self.subTest(line):
                screen = self.screen(line, words[-1])
                for word in words:
                    self.assertIn(word, screen)


if __name__ == "__main__":
    main()
