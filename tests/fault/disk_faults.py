"""Jobs of pcvt whose system calls fail, or that are killed, and the verdict on the files that they leave.

A fault may leave every output of a job old, or every one new. A kill may leave old files beside new ones until
the next run in the same folders, which must make all of them old or new, and remove every hidden file. Exit code 0
means all new; any other exit code means all old, unless the message announces the work of the next run.
"""

import argparse
import collections
import concurrent.futures
import errno
import json
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = ROOT / "build" / "release"
TIMEOUT = 60
ERRORS = (errno.EIO, errno.ENOSPC, errno.EACCES)
FORMATS = "obj ply glb gltf om svg png vtu dxf html csv txt msh inp vti"


def outputs(stem, extensions):
    return [word for extension in extensions.split() for word in ("-o", f"{stem}.{extension}")]


def mesh(seed, *rest):
    pixels = ["--pixels", "16", "--voxels", "8,8"] if "a.png" in rest else []
    return ["mesh", "--sites", "12", "--seed", str(seed), "--threads", "1", "--max-iterations", "5", "--quiet",
            *pixels, *rest]


EVERY = ["--mesh", "delaunay", *outputs("a", FORMATS), "-o", "new/b.obj", "--report", "r.json"]
FOAM = ["--mesh", "grains", "-o", "c.foam", "-o", "a.obj"]
STUDY = ["study", "fig11", "--sites", "6", "--threads", "1", "--quiet", "-o", "t/", "--force"]
CHECKED = "a.obj a.ply a.glb a.gltf a.om a.msh a.inp a.vtu a.vti"
# Jobs: the run that makes the old files (None: none), and the run in which calls fail. HOST is the C client.
HOST = "system_call_host"
JOBS = {
    "fresh": (None, mesh(1, *EVERY)),
    "replace": (mesh(2, *EVERY), mesh(1, *EVERY, "--force")),
    "foam": (None, mesh(1, *FOAM)),
    "foam-replace": (mesh(2, *FOAM), mesh(1, *FOAM, "--force")),
    "mpas": (None, ["mesh", "--sites", "30", "--retry", "40", "--threads", "1", "--quiet", "-o", "a.nc"]),
    "input": (mesh(3, "-o", "s.txt"), ["mesh", "--input", "s.txt", "--threads", "1", "--quiet", "-o", "b.ply"]),
    "pattern": (None, ["pattern", "--sites", "7", "--quiet", "-o", "a.obj", "-o", "b.svg"]),
    "study": ([*STUDY, "--runs", "1"], [*STUDY, "--runs", "2"]),
    "host": ([HOST, "2"], [HOST, "1"]),
    "check": (mesh(1, "--mesh", "delaunay", *outputs("a", FORMATS)), ["check", *CHECKED.split()]),
}
# Jobs that read a file may refuse it; a library that is given no memory or no file may report either.
CODES = collections.defaultdict(lambda: {0, 3, 4}, {"input": {0, 2, 3, 4}, "check": {0, 2, 4}})
ANNOUNCED = "the next run"
RECOVERED = "an earlier run ended while it wrote"
UNFINISHED = "a run ended before it had written all files of its set"


def is_hidden(path):
    return any(part.startswith(".") for part in path.parts)


def content_of(path):
    """The bytes of a file, without the figures that differ from run to run; None for a folder."""
    if not path.is_file():
        return None
    data = path.read_bytes()
    if path.name != "r.json":
        return data
    report = json.loads(data)
    return repr({key: value for key, value in report.items() if key not in ("seconds", "threads")})


def contents(folder, hidden=False):
    found = {path.relative_to(folder): path for path in folder.rglob("*")}
    return {str(name): content_of(path) for name, path in found.items() if hidden or not is_hidden(name)}


class Job:
    def __init__(self, name, programs, scratch):
        self.name, self.programs = name, programs
        prepare, self.command = JOBS[name]
        self.start = scratch / name / "old"
        self.start.mkdir(parents=True)
        if prepare is not None:
            self.run(prepare, self.start, check=True)
        self.old = contents(self.start, hidden=True)
        done = scratch / name / "new"
        shutil.copytree(self.start, done)
        calls = scratch / name / "calls"
        self.run(self.command, done, {"FAULT_LIST": str(calls)}, check=True)
        self.new = contents(done, hidden=True)
        self.calls = calls.read_text().split()
        left = [path for path in (*self.old, *self.new) if is_hidden(pathlib.Path(path))]
        assert not left, f"{name}: a run without faults leaves {left}"

    def run(self, command, folder, environment=None, **options):
        program = self.programs.host if command[0] == HOST else self.programs.pcvt
        arguments = command[1:] if command[0] == HOST else command
        shim = {"LD_PRELOAD": str(self.programs.shim), **environment} if environment else {}
        return subprocess.run([program, *arguments], cwd=folder, env={**os.environ, **shim}, timeout=TIMEOUT,
                              stdin=subprocess.DEVNULL, capture_output=True, **{"check": False, **options})

    def state(self, folder):
        found = contents(folder)
        return "new" if found == self.new else "old" if found == self.old else "mixed"

    def recover(self, folder, before):
        """The next run: it writes a file into each folder. Returns its complaint."""
        folders = [path for path in folder.rglob("*") if path.is_dir() and not is_hidden(path.relative_to(folder))]
        targets = [path / "zz.csv" for path in (folder, *folders)]
        if self.name == "study":
            study = ["study", "fig11", "--sites", "4", "--runs", "1", "--threads", "1"]
            runs = [self.run([*study, "-o", str(target)], folder) for target in targets]
        else:
            words = [word for target in targets for word in ("-o", str(target))]
            runs = [self.run(["mesh", "--sites", "3", "--threads", "1", *words], folder)]
        for target in targets:
            for path in target.parent.glob("zz*"):
                path.unlink()
        for path in sorted(folders, reverse=True):
            # Taking a set back removes the folder, and the next run makes it again.
            if str(path.relative_to(folder)) not in self.old and not any(path.iterdir()):
                path.rmdir()
        for done in runs:
            if done.returncode != 0:
                return f"the next run ends with {done.returncode}: {done.stderr.decode()}"
        words = b"".join(done.stdout + done.stderr for done in runs).decode()
        return "the next run does not report its recovery" if before == "mixed" and RECOVERED not in words else ""

    def check_complaint(self, folder):
        """A file of an unfinished set must be refused for that reason."""
        tiles = [name for name in self.new if name.endswith((".obj", ".ply"))]
        if not tiles:
            return ""
        done = self.run(["check", tiles[0]], folder)
        line = done.stderr.decode()
        return "" if done.returncode == 2 and UNFINISHED in line else f"check does not see the unfinished set: {line}"

    def complaint(self, done, folder, before):
        """A complaint about the end of a run that had a fault, or an empty text."""
        code, line = done.returncode, done.stderr.decode()
        killed = code == -signal.SIGKILL
        if not killed and code not in CODES[self.name]:
            return f"exit code {code}: {line}"
        # check has one line for each file.
        n_lines = min(line.count("\n"), 1) if self.name == "check" else line.count("\n")
        if not killed and n_lines != (code != 0):
            return f"exit code {code} with the message {line!r}"
        announced = ANNOUNCED in line
        if not killed and not announced and before != ("new" if code == 0 else "old") and self.old != self.new:
            return f"exit code {code}, but the files are {before}: {line}"
        complaint = self.check_complaint(folder) if before == "mixed" else ""
        complaint = self.recover(folder, before) or complaint
        after = self.state(folder)
        left = [name for name in contents(folder, hidden=True) if is_hidden(pathlib.Path(name))]
        if complaint or left or after == "mixed":
            return f"{complaint or 'the next run succeeds'}; files {before}, then {after}; left: {left}; {line}"
        if before != "mixed" and not announced and not killed and after != before:
            return f"the next run makes {before} files {after}"
        return ""

    def fault(self, k, mode):
        """Runs the job with a fault; returns its end and the complaint."""
        error = ERRORS[k % len(ERRORS)]
        environment = {"FAULT_CALL": str(k), "FAULT_MODE": mode, "FAULT_ERROR": str(error)}
        with tempfile.TemporaryDirectory(dir=self.start.parent) as scratch:
            folder = pathlib.Path(scratch) / "f"
            shutil.copytree(self.start, folder)
            try:
                done = self.run(self.command, folder, environment)
                before = self.state(folder)
                complaint = self.complaint(done, folder, before)
                end = f"exit {done.returncode}" if done.returncode >= 0 else "killed"
                end += f", files {before}" if self.old != self.new else ""
            except subprocess.TimeoutExpired:
                complaint, end = "does not end", "timeout"
        place = f"{self.name}: {mode} call {k} ({self.calls[k - 1]}), error {error}"
        return end, f"{place}: {complaint}" if complaint else ""


def scratch_folder():
    """In memory where the system has such a folder: the faults do not depend on the disk."""
    memory = pathlib.Path("/dev/shm")
    return tempfile.TemporaryDirectory(dir=memory if os.access(memory, os.W_OK) else None, prefix="pcvt-fault-")


def main(description, modes, sample):
    """Runs each mode at every call, or at a sample of them. The errors take turns."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--all", action="store_true", help="every call of every job")
    parser.add_argument("--job", action="append", choices=JOBS, help="only these jobs")
    parser.add_argument("--seed", type=int, default=0, help="of the sample")
    parser.add_argument("--pcvt", type=pathlib.Path, default=BUILD / "pcvt")
    parser.add_argument("--shim", type=pathlib.Path, default=BUILD / "tests/fault/libsystem_call_shim.so")
    parser.add_argument("--host", type=pathlib.Path, default=BUILD / "tests/fault/system_call_host")
    options = parser.parse_args()
    for name in ("pcvt", "shim", "host"):
        setattr(options, name, getattr(options, name).resolve())
    with scratch_folder() as scratch, concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        scratch = pathlib.Path(scratch)
        jobs = list(pool.map(lambda name: Job(name, options, scratch), options.job or JOBS))
        cases = [(job, k, mode) for job in jobs for k in range(1, len(job.calls) + 1) for mode in modes]
        if not options.all:
            cases = random.Random(options.seed).sample(cases, min(sample, len(cases)))
        results = list(pool.map(lambda case: case[0].fault(*case[1:]), cases))
    ends = collections.Counter(end for end, _ in results)
    complaints = [complaint for _, complaint in results if complaint]
    print("\n".join(complaints[:40]))
    print(f"{len(cases)} faults at {len({case[:2] for case in cases})} calls of {len(jobs)} jobs: "
          f"{dict(sorted(ends.items()))}; {len(complaints)} complaints")
    sys.exit(1 if complaints else 0)
