"""Shared by the tests of the scripts in samples/: runs, and the line with which they refuse files."""

import contextlib
import io
import os
import pathlib
import re
import runpy
import sys
from unittest import mock

from support.cli import CliTest

SAMPLES = pathlib.Path(__file__).resolve().parents[2] / "samples"
# More seconds than a test takes.
LONG = 10_000
DAMAGES = ("nan", "inf", "1e999", "-1", "99999999", "²", "x", "", "(", ")", "{", ";", "7 7", "*NODE", "\0", "\u00e9")


def printed(name, *arguments):
    """Runs a sample; returns its exit code, its standard output and its standard error."""
    output, errors = io.StringIO(), io.StringIO()
    code = 0
    with mock.patch.object(sys, "argv", [name, *map(str, arguments)]), contextlib.redirect_stderr(errors), \
            contextlib.redirect_stdout(output), mock.patch.object(sys, "path", [str(SAMPLES), *sys.path]):
        try:
            runpy.run_path(str(SAMPLES / name), run_name="__main__")
        except SystemExit as end:
            code = end.code
    return code or 0, output.getvalue(), errors.getvalue()


def sample(name, *arguments):
    """Runs a sample; returns its exit code and its standard error."""
    code, _, errors = printed(name, *arguments)
    return code, errors


class SampleTest(CliTest):
    def expect_line(self, name, arguments, pattern, remedy=""):
        code, output, line = printed(name, *arguments)
        self.assertEqual((code, output, line.count("\n")), (2, "", 1), line)
        self.assertRegex(line, f"^{re.escape(str(self.folder))}/{pattern}.*; {remedy}.*\n$")

    def damage(self, source, name, arguments, files):
        """Damages each file 25 times; the sample must succeed, or refuse it in one line."""
        for path in files:
            text = path.read_text()
            for _ in range(25):
                words = re.split(r"([\s,()]+)", text)
                k = source.randrange(len(words))
                damaged = "".join([*words[:k], source.choice(DAMAGES), *words[k + 1:]])
                path.write_text(damaged if source.random() < 0.7 else damaged[:source.randrange(len(damaged))])
                code, line = sample(name, *arguments)
                self.assertIn((code, line.count("\n")), ((0, 0), (2, 1)), (path, line))
            path.write_text(text)

    def set_age(self, name, seconds):
        """Makes a file this much older than the job."""
        time = self.path("job.inp").stat().st_mtime - seconds
        os.utime(self.path(name), (time, time))
