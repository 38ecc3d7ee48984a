"""Random volume elements in space: `pcvt check` accepts every file, and so does an independent count of its elements.

By hand, in this folder:
    PYTHONPATH=../.. /usr/bin/python3 cli_random_elements_test.py PCVT --jobs 2000 --seed 1
    PYTHONPATH=../.. /usr/bin/python3 cli_random_elements_test.py PCVT --only 17 --seed 1      runs one job
"""

import argparse
import random
import re
import resource
import shlex
import shutil
import sys
import time

from support.cli import CliTest, main

try:
    from support import space_count
    from support.random_elements import count_job
except ImportError as missing:
    print(f"skipped, {missing.name} is not installed", file=sys.stderr)
    sys.exit(77)

# The jobs of the test, and the seconds after which it begins no further one.
N_JOBS = 30
SECONDS = 3
# By hand, jobs that take more seconds of processor time are listed.
LONG_JOB = 20


class RandomElements(CliTest):
    options = argparse.Namespace(jobs=N_JOBS, seed="1", only=None)

    def test_files_are_proved_and_counted_again(self):
        numbers = [self.options.only] if self.options.only is not None else range(self.options.jobs)
        is_by_hand = self.options.jobs != N_JOBS or self.options.only is not None
        end = time.monotonic() + SECONDS
        n_faults = n_refused = n_run = 0
        for number in numbers:
            if not is_by_hand and time.monotonic() > end:
                break
            folder = self.path(str(number))
            folder.mkdir()
            before = spent()
            words, faults, refusal = count_job(self.run_pcvt, folder, random.Random(f"{self.options.seed} {number}"))
            shutil.rmtree(folder)
            n_run += 1
            is_long = is_by_hand and spent() - before > LONG_JOB
            n_refused += bool(refusal)
            n_faults += bool(faults)
            if faults or is_long or (refusal and is_by_hand):
                line = shlex.join(map(str, words))
                lines = [f"--seed {self.options.seed} --only {number}", f"pcvt mesh {line}", *faults, refusal.strip(), f"{spent() - before:.0f} s" if is_long else ""]
                print("\n  ".join(filter(None, lines)), flush=True)
            if is_by_hand and number % 100 == 99:
                print(f"{number + 1} jobs, {n_refused} with a file refused, {n_faults} with faults", flush=True)
        if is_by_hand:
            print(f"{n_run} jobs, {n_refused} with a file refused, {n_faults} with faults")
        self.assertEqual(n_faults, 0)

    def test_the_count_finds_damage(self):
        self.succeed("mesh", "--sites", 2, "--period", "1,1,1", "--mesh", "grains", "--outline", "box", "--order", 2, "--size", 0.5,
                     "--job", "elastic", "-o", "t.inp", "-o", "t.vtu", "-o", "t.stl", "-o", "t.msh", "-o", "t.foam", "--quiet")
        counts = {space_count.counted(self.path(f"t.{extension}")) for extension in ("inp", "vtu", "msh", "foam")}
        self.assertEqual(len(counts), 1)
        space_count.counted(self.path("t.stl"))
        inp = self.path("t.inp").read_text()
        ties = re.findall(r"^5\n.*,.*\n.*,.*\n", inp, re.M)
        damages = [(ties[0], "", "does not depend in all components"), (ties[0], ties[0] * 2, "depends twice"),
                   (ties[3], ties[3].replace(",-1,", ",-0.5,", 1), "does not tie one component"),
                   ("FIXED,1,3\n", re.search(r"\n(\d+),1,", ties[0])[1] + ",1,3\n", "is held in 1, which depends"),
                   (re.search(r"\n(\d+,[^,]*,)", inp.split("*NODE,NSET=NALL")[1])[1], "1,0.123,", "")]
        for piece, other, words in damages:
            self.assertIn(piece, inp)
            self.write("d.inp", inp.replace(piece, other, 1))
            with self.subTest(words), self.assertRaisesRegex(space_count.Fault, words):
                space_count.counted(self.path("d.inp"))
        data = self.path("t.stl").read_bytes()
        self.write("d.stl", data[:80] + (len(data) // 50 - 2).to_bytes(4, "little") + data[84:-50])
        with self.assertRaisesRegex(space_count.Fault, "do not close"):
            space_count.counted(self.path("d.stl"))
        grid = self.path("t.vtu").read_text()
        row = re.search(r'Name="connectivity"[^>]*>\n(.*)\n', grid)[1]
        first, second, *rest = row.split()
        self.write("d.vtu", grid.replace(f"\n{row}\n", "\n" + " ".join([second, first, *rest]) + "\n", 1))
        with self.assertRaisesRegex(space_count.Fault, "no positive volume"):
            space_count.counted(self.path("d.vtu"))


def spent():
    """The processor time of the runs that have ended."""
    return sum(resource.getrusage(resource.RUSAGE_CHILDREN)[:2])


def take_options():
    parser = argparse.ArgumentParser()
    parser.add_argument("pcvt")
    parser.add_argument("--jobs", type=int, default=N_JOBS)
    parser.add_argument("--only", type=int)
    parser.add_argument("--seed", default="1")
    RandomElements.options = parser.parse_args()
    sys.argv[1:] = [RandomElements.options.pcvt]


if __name__ == "__main__":
    take_options()
    main()
