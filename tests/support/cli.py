"""Shared by the tests of the command: a temporary folder, runs, and the form of an error."""

import os
import pathlib
import resource
import shutil
import subprocess
import sys
import tempfile
import unittest

BINARY = ""
TIMEOUT = 300


def limit(kind, amount):
    """A preexec_fn that lowers one resource limit of the child."""

    def lower():
        resource.setrlimit(kind, (amount, amount))

    return lower


def outputs(*extensions, name="t"):
    """The options that write a file of each extension."""
    return [word for extension in extensions for word in ("-o", f"{name}.{extension}")]


class CliTest(unittest.TestCase):
    """Each test runs in an empty folder."""

    maxDiff = None

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="pcvt-cli-"))
        self.addCleanup(shutil.rmtree, self.folder)

    @staticmethod
    def binary():
        return BINARY

    def path(self, name):
        return self.folder / name

    def write(self, name, content):
        data = content if isinstance(content, bytes) else content.encode()
        self.path(name).write_bytes(data)
        return name

    def run_pcvt(self, *arguments, cwd=None, **options):
        options.setdefault("timeout", TIMEOUT)
        options.setdefault("stdin", None if "input" in options else subprocess.DEVNULL)
        if options["stdin"] is None:
            del options["stdin"]
        return subprocess.run(
            [BINARY, *map(str, arguments)],
            cwd=cwd or self.folder,
            capture_output=True,
            check=False,
            **options,
        )

    def succeed(self, *arguments, **options):
        """Runs, expects exit code 0 and empty standard error, returns standard output."""
        done = self.run_pcvt(*arguments, **options)
        self.assertEqual((done.returncode, done.stderr.decode()), (0, ""), arguments)
        return done.stdout.decode()

    def contents(self, folder=None):
        """Returns the bytes of every file below the folder."""
        folder = folder or self.folder
        return {
            str(p.relative_to(folder)): p.read_bytes() for p in folder.rglob("*") if p.is_file()
        }

    def refuse(self, code, pattern, *arguments, **options):
        """Runs, expects the exit code, one matching line of standard error, and an unchanged folder."""
        before = self.contents()
        done = self.run_pcvt(*arguments, **options)
        line = done.stderr.decode()
        self.assertEqual(done.returncode, code, (arguments, line))
        self.assertEqual(line.count("\n"), 1, (arguments, line))
        self.assertTrue(line.endswith("\n"), line)
        self.assertRegex(line, pattern)
        self.assertEqual(done.stdout, b"", arguments)
        self.assertEqual(self.contents(), before, arguments)


def main():
    """Removes the path of the command from the arguments and runs the tests."""
    global BINARY
    BINARY = os.path.abspath(sys.argv.pop(1))
    unittest.main(module="__main__")
