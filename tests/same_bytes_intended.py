"""What differs on purpose between two builds; the docstring of tests/same_bytes has the format."""

import json
import re
from pathlib import Path

QUOTED = r'("(?:[^"\\]|\\.)*")'
TEXT = re.compile(rf"text (\S+) {QUOTED} => {QUOTED}")
KEY = re.compile(r"key (\S+) ([23])")
JOB = re.compile(r"job (\S+) (\S+) (.*\d.*)")
MESHES = {".obj", ".ply", ".glb", ".gltf", ".om", ".stl", ".msh", ".inp", ".vtu", ".foam", ".nc", ".vti"}


class BadLine(Exception):
    """A line of the list that has no known form."""


class Text:
    """A sentence that was replaced, removed (new is empty) or added (old is empty), in some jobs."""

    def __init__(self, jobs, old, new):
        self.jobs = None if jobs == "*" else jobs.split(",")
        self.old, self.new = json.loads(old).encode(), json.loads(new).encode()
        if not self.old and not self.new:
            raise BadLine("both texts are empty")

    def applies_to(self, job):
        return self.jobs is None or job in self.jobs

    def apply(self, contents):
        """Both contents without the difference."""
        old, new = contents
        if not self.old:
            return old, new.replace(self.new, b"")
        return old.replace(self.old, self.new), new


def report_dimension(content):
    """2 or 3 for a report of a run, else None."""
    try:
        report = json.loads(content)
        return len(report["lattice"][0]) if "version" in report else None
    except (ValueError, KeyError, TypeError, IndexError):
        return None


class Key:
    """A key that reports of one dimension have gained; reports have one key a line."""

    def __init__(self, key, dimension):
        self.line = re.compile(rb'\n  "%s": [^\n]*' % re.escape(key.encode()))
        self.dimension = int(dimension)

    def applies_to(self, _):
        return True

    def apply(self, contents):
        old, new = contents
        if self.line.search(old) or not self.line.search(new):
            return contents
        if report_dimension(new) != self.dimension:
            return contents
        rest = self.line.sub(b"", new)
        return old, re.sub(rb",(?=\n}\n?$)", b"", rest)


class Intended:
    """The lines of the list, and which of them were needed."""

    def __init__(self, path):
        self.path, self.contents, self.files = path, {}, {}
        self.unused = {}
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            if not line.strip() or line.startswith("#"):
                continue
            try:
                self.add(number, line.strip())
            except (BadLine, ValueError) as fault:
                raise BadLine(f"{path}:{number}: {fault}") from None

    def add(self, number, line):
        if found := TEXT.fullmatch(line):
            self.contents[number] = Text(*found.groups())
        elif found := KEY.fullmatch(line):
            self.contents[number] = Key(*found.groups())
        elif found := JOB.fullmatch(line):
            self.files[found[1], found[2]] = number, found[3]
        else:
            raise BadLine("the line is none of: text JOBS \"OLD\" => \"NEW\", key KEY 2|3, "
                          "job JOB FILE POINT, with the number of the point")
        self.unused[number] = line

    def unknown_jobs(self, jobs):
        """The names of jobs in the list that do not exist."""
        named = {job for job, _ in self.files}
        for text in self.contents.values():
            named |= set(getattr(text, "jobs", None) or ())
        return sorted(named - set(jobs))

    def equalised(self, job, contents):
        """The old and the new content of a file or stream without the listed texts and keys."""
        for number, row in self.contents.items():
            if not row.applies_to(job):
                continue
            rest = row.apply(contents)
            if rest != contents:
                self.unused.pop(number, None)
            contents = rest
        return contents

    def point(self, job, file):
        """The numbered point that asked for another file, or None; notes that the line was needed."""
        number, point = self.files.get((job, file), (None, None))
        self.unused.pop(number, None)
        return point


def mesh_of(file):
    """The path that pcvt check reads to prove a file, or None for what is no mesh."""
    path = Path(file)
    case = next((part for part in [path, *path.parents] if part.suffix == ".foam"), path)
    return str(case) if case.suffix in MESHES else None
