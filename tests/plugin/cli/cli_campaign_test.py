"""Random runs over all options, in the plane and in space: exit 1 is for proofs that fail, and there are none.

Each run of `pcvt mesh` or `pcvt pattern` ends with a documented exit code and at most one line on standard error,
leaves no hidden file behind, and writes all of its files or none, but for files whose single precision does not hold
the tile. `pcvt check` accepts the files.

By hand, in this folder:
    PYTHONPATH=../.. python3 cli_campaign_test.py PCVT --jobs 3000 --seed 1 --dimension 2
    PYTHONPATH=../.. python3 cli_campaign_test.py PCVT --only 17 --seed 1 --dimension 2      prints one run
"""

import argparse
import pathlib
import random
import re
import shlex
import subprocess
import sys
import time
import unittest

from support import random_jobs
from support.cli import CliTest, main

# The runs of the test, and the seconds after which it begins no further one.
N_JOBS = 120
SECONDS = 12
LONGEST_RUN = 300
DONE, NOT_CONVERGED = 0, 5
EXIT_CODES = {DONE, 2, 3, 4, NOT_CONVERGED}
READABLE = ("obj", "ply", "glb", "gltf", "om", "stl", "msh", "inp", "vtu", "foam", "nc", "vti")
LEFT_OUT = re.compile(r"single precision|float32")
# Said before a run, and no fault of it.
NOTE = re.compile(r"^pcvt: takes about .*\n", re.MULTILINE)


class Campaign:
    """Runs jobs in a folder of their own."""

    def __init__(self, test, seed, dimension):
        self.test = test
        self.seed = seed
        self.dimension = dimension
        self.outcomes = {}

    def job(self, number):
        return random_jobs.random_job(random.Random(f"{self.seed} {self.dimension} {number}"), self.dimension)

    def run(self, number):
        """Returns the faults of one run."""
        job = self.job(number)
        folder = self.test.path(f"{self.dimension}-{number}")
        folder.mkdir()
        for name, content in job.inputs.items():
            (folder / name).write_bytes(content if isinstance(content, bytes) else content.encode("latin-1"))
        try:
            done = self.test.run_pcvt(*job.arguments(), cwd=folder, timeout=LONGEST_RUN)
        except (subprocess.TimeoutExpired, ValueError) as fault:
            return [str(fault)[:200]]
        error = NOTE.sub("", done.stderr.decode(errors="replace"))
        self.outcomes[done.returncode] = self.outcomes.get(done.returncode, 0) + 1
        faults = faults_of_end(done.returncode, error) + self.faults_of_files(folder, job, done.returncode, error)
        if not faults:
            subprocess.run(["rm", "-r", folder], check=True)
        return [f"{fault}: {error}" for fault in faults]

    def faults_of_files(self, folder, job, code, error):
        left = sorted(str(p.relative_to(folder)) for p in folder.rglob("*"))
        written = [name for name in left if name not in job.inputs]
        faults = [f"left behind: {name}" for name in left if ".pcvt-" in name]
        is_partial = code == 2 and LEFT_OUT.search(error)
        if code not in (DONE, NOT_CONVERGED) and written and not is_partial:
            faults.append(f"files of a run that ended with {code}: {written}")
        # A case is a folder, in which a file has its name.
        tiles = [name for name in written if pathlib.Path(name).suffix[1:].lower() in READABLE
                 and (not name.lower().endswith(".foam") or (folder / name).is_dir())]
        if tiles:
            checked = self.test.run_pcvt("check", "--", *tiles, cwd=folder, timeout=LONGEST_RUN)
            if checked.returncode != 0:
                faults.append(f"check ended with {checked.returncode}: {checked.stderr.decode()[:300]}")
        return faults


def faults_of_end(code, error):
    faults = []
    if code not in EXIT_CODES:
        faults.append(f"exit code {code}")
    lines = 0 if code == DONE else 1
    if error.count("\n") != lines:
        faults.append(f"{error.count(chr(10))} lines of message")
    if re.search(r"Traceback|terminate called|fault of pcvt", error):
        faults.append("not a message for users")
    return faults


def shown(campaign, number, faults):
    words = shlex.join(campaign.job(number).arguments())
    return f"--dimension {campaign.dimension} --seed {campaign.seed} --only {number}\n  pcvt {words}\n  " + "\n  ".join(faults)


class RandomRuns(CliTest):
    def expect_no_fault(self, dimension):
        campaign = Campaign(self, "1", dimension)
        end = time.monotonic() + SECONDS
        for number in range(N_JOBS):
            if time.monotonic() > end:
                break
            with self.subTest(dimension=dimension, number=number):
                faults = campaign.run(number)
                self.assertFalse(faults, shown(campaign, number, faults))

    def test_runs_in_the_plane_end_as_documented(self):
        self.expect_no_fault(2)

    def test_runs_in_space_end_as_documented(self):
        self.expect_no_fault(3)

    def test_every_option_is_drawn(self):
        options = {word for command in ("mesh", "pattern")
                   for word in re.findall(r"(?m)^ +(--[a-z0-9-]+|-o)\b", self.succeed(command, "--help"))}
        drawn = {str(word).partition("=")[0] for dimension in (2, 3) for number in range(3000)
                 for word in Campaign(self, "1", dimension).job(number).words}
        self.assertFalse(options - drawn - {"--help", "--force"})


class ByHand(CliTest):
    """One campaign of the size that the command line names."""

    options = None

    def test_campaign(self):
        numbers = [self.options.only] if self.options.only is not None else range(self.options.jobs)
        campaign = Campaign(self, self.options.seed, self.options.dimension)
        n_faults = 0
        for number in numbers:
            faults = campaign.run(number)
            if faults or self.options.only is not None:
                print(shown(campaign, number, faults), flush=True)
            n_faults += bool(faults)
        print(f"{len(numbers)} runs, exit codes {dict(sorted(campaign.outcomes.items()))}, {n_faults} with faults")
        self.assertEqual(n_faults, 0)


def by_hand():
    """Takes the options of a campaign by hand from the arguments; without them, the test runs."""
    parser = argparse.ArgumentParser()
    parser.add_argument("pcvt")
    parser.add_argument("--jobs", type=int)
    parser.add_argument("--only", type=int)
    parser.add_argument("--seed", default="1")
    parser.add_argument("--dimension", type=int, choices=(2, 3), default=2)
    options = parser.parse_args()
    if options.jobs is None and options.only is None:
        return False
    ByHand.options = options
    sys.argv[1:] = [options.pcvt]
    return True


def load_tests(loader, _tests, _pattern):
    return loader.loadTestsFromTestCase(ByHand if ByHand.options else RandomRuns)


if __name__ == "__main__":
    by_hand()
    main()
