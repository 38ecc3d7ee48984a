"""The steps of the jobs of tests/same_bytes, and the builds that they run.

A job is a list of steps: a File, a Damage, a Host, a Python, or a text with the arguments of one run
of pcvt, which follow the exit code that is expected of the old build ("2: mesh --sites 0"; 0 where
none is given, ?: any) and end with "< FILE" where that file is the standard input.
"""

import os
import re
import shlex
import shutil
import subprocess
from pathlib import Path

TESTS = Path(__file__).resolve().parent
PYTHON = "/usr/bin/python3"
LONGEST_NAME = 100  # characters of a command that a complaint shows


class Build:
    """The command, the C library and the Python package of a build folder; of a file, the command."""

    def __init__(self, path):
        path = path.resolve()
        self.command = path if path.is_file() else path / "pcvt"
        self.library = None if path.is_file() else path / "libpcvt.so"
        self.checkout = None
        cache = path / "CMakeCache.txt"
        if cache.is_file():
            found = re.search(r"^CMAKE_HOME_DIRECTORY:\w+=(.*)$", cache.read_text(), re.MULTILINE)
            self.checkout = Path(found[1])
        self.host = None  # the program of Host

    def missing(self):
        """What cannot be used of the build, or None."""
        if not os.access(self.command, os.X_OK):
            return f"{self.command} cannot be run"
        if not self.library:
            return None
        if not self.library.exists():
            return f"{self.library} is missing; build the target plugin"
        return None if self.checkout else f"{self.library.parent} has no CMakeCache.txt"


def compile_host(build, program):
    """Compiles the host of the C interface with the header of a build, as strictly as C99 allows."""
    flags = ["-std=c99", "-O1", "-Wall", "-Wextra", "-Wpedantic", "-Wshadow", "-Werror"]
    subprocess.run(["cc", *flags, "-I", build.checkout / "plugin", "-I", TESTS.parent,
                    TESTS / "same_bytes_host.c", build.library, "-lm", "-o", program], check=True)


class Run:
    """A step that runs a process."""

    def __init__(self, expected=0):
        self.expected = expected  # the exit code of the old build, or None for any

    def process(self, build, folder):
        """The words, the standard input and the additional environment of the process."""
        raise NotImplementedError

    def run(self, build, folder):
        words, given, environment = self.process(build, folder)
        return subprocess.run(list(map(str, words)), cwd=folder, input=given, capture_output=True,
                              env={**os.environ, **environment}, check=False)


class Command(Run):
    """One run of pcvt; made of a step that is a text."""

    def __init__(self, step):
        expected, self.name = re.fullmatch(r"(?:(\d+|\?): )?(.*)", step).groups()
        super().__init__(None if expected == "?" else int(expected or 0))
        self.title = f"pcvt {self.name}"

    def process(self, build, folder):
        words, given = shlex.split(self.name), b""
        if words[-2:-1] == ["<"]:
            words, given = words[:-2], (folder / words[-1]).read_bytes()
        return [build.command, *words], given, {}


class Host(Run):
    """One run of same_bytes_host.c, compiled with the old header, with the library of the build."""

    def __init__(self, words):
        super().__init__()
        self.words = shlex.split(words)
        self.title = f"host {words}"

    def process(self, build, folder):
        return [build.host, *self.words], b"", {"LD_LIBRARY_PATH": str(build.library.parent)}


class Python(Run):
    """One script in Python with the package and the library of the build; see same_bytes_shown.py."""

    def __init__(self, script):
        super().__init__()
        self.script = "from same_bytes_shown import *\n" + script
        self.title = f"python {' '.join(script.split())}"

    def process(self, build, folder):
        paths = [build.checkout / "plugin/python", TESTS]
        return [PYTHON, "-B", "-c", self.script], b"", {
            "PCVT_LIBRARY": str(build.library), "PYTHONPATH": ":".join(map(str, paths))}


class File:
    """A step that writes a file into the job's folder, or makes a folder if the name ends in /."""

    def __init__(self, name, content=""):
        self.name, self.content = name, content

    def make(self, folder, _):
        if self.name.endswith("/"):
            (folder / self.name).mkdir()
        else:
            content = self.content.encode() if isinstance(self.content, str) else self.content
            (folder / self.name).write_bytes(content)


def damaged(content, kind, place):
    """`content` with one fault at a place given in bytes."""
    if kind == "cut":
        return content[:place]
    end = content.find(b"\n", place) + 1 or len(content)
    begin = content.rfind(b"\n", 0, place) + 1
    if kind == "drop line":
        return content[:begin] + content[end:]
    if kind == "double line":
        return content[:end] + content[begin:end] + content[end:]
    if kind == "break word":
        return content[:place] + b"?" + content[place + 1:]
    digit = re.compile(rb"\d").search(content, place)
    if not digit:
        return content + b"7"
    return content[:digit.start()] + b"%d" % ((int(digit[0]) + 1) % 10) + content[digit.end():]


class Damage:
    """A step that copies a tile 30 times, each with one fault: bad00.EXT, bad01.EXT, ...

    Both builds get copies of the tile of the old build, so that they check the same bytes.
    """

    COPIES = 30
    KINDS = ["digit", "cut", "drop line", "double line", "break word", "digit"]

    def __init__(self, name):
        self.name = name

    def make(self, folder, old_folder):
        source = old_folder / self.name
        if not source.exists():
            return
        for k in range(self.COPIES):
            copy = folder / f"bad{k:02}{source.suffix}"
            (shutil.copytree if source.is_dir() else shutil.copyfile)(source, copy)
            files = [copy] if copy.is_file() else sorted(copy.glob("constant/polyMesh/*"))
            if not files:
                return
            file = files[k % len(files)]
            content = file.read_bytes()
            place = len(content) * (k + 1) // (self.COPIES + 1)
            file.write_bytes(damaged(content, self.KINDS[k % len(self.KINDS)], place))


def damage_steps(extension, options="", cvt="--cvt 1e-3"):
    """Checks of one good tile and of its damaged copies."""
    bad = " ".join(f"bad{k:02}{extension}" for k in range(Damage.COPIES))
    return [f"mesh --sites 8 {options} -o t{extension} --quiet", f"check t{extension}",
            Damage(f"t{extension}"), f"2: check {bad}", f"2: check {bad} {cvt}"]


def run_steps(build, folder, old_folder, steps):
    """All that a job writes, {file or stream: bytes}, the titles of its runs, and complaints."""
    folder.mkdir(parents=True)
    streams, titles, complaints = {}, [], []
    for step in steps:
        step = Command(step) if isinstance(step, str) else step
        if not isinstance(step, Run):
            step.make(folder, old_folder)
            continue
        done = step.run(build, folder)
        titles.append(step.title[:LONGEST_NAME])
        name = f"step {len(titles)}"
        code = f"{name}: exit code {done.returncode}"
        streams |= {f"{name} exit code": code.encode(), f"{name} error": done.stderr,
                    f"{name} output": done.stdout}
        with open(f"{folder}.log", "ab") as log:
            log.write(f"{name}: {step.title}\n".encode() + done.stdout + done.stderr)
            log.write(f"{code}\n\n".encode())
        if step.expected not in (None, done.returncode):
            complaints.append(f"{code} is not the expected one: {titles[-1]}")
    files = {str(path.relative_to(folder)): path.read_bytes() if path.is_file() else b"(folder)"
             for path in sorted(folder.rglob("*"))}
    return {**files, **streams}, titles, complaints
