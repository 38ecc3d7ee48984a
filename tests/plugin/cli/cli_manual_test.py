"""pcvt help: the pages of the manual and the completion of the command line."""

import os
import pty
import re
import select
import shutil
import subprocess
import unittest

from support.cli import CliTest, main

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
                (["mesh", "--element", ""], ["CPE", "CPS"]),
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
