#!/usr/bin/env python3
"""Prints the table of ratios from the rounds of tests/bench/run, as Markdown.

    tests/bench/table.py ROUND.json ...   each the JSON of one run of all cases
    tests/bench/table.py --self-test      checks the arithmetic on planted rounds

The value of a case is the median over its rounds: of its CPU time, or of its wall time where the
case selects that (Google Benchmark then ends its name in /real_time or /manual_time).
"""

import json
import statistics
import subprocess
import sys
from dataclasses import dataclass

SIZES = [10_000, 100_000, 1_000_000]
LATTICES = {"unit": "", "oblique": ", oblique (1, 0), (0.37, 0.81)", "thin": ", 20 x 1", "cube": ", in space"}
PLANE = ("unit", "oblique", "thin")
SECONDS = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0}


@dataclass(frozen=True)
class Measure:
    """A case's time in seconds, or one of its counters."""
    what: str
    counter: str = "seconds"


@dataclass(frozen=True)
class Row:
    """A measure, or a ratio of two measures, with its bound in words."""
    text: str
    over: Measure
    under: Measure = None
    bound: str = ""
    sizes: tuple = tuple(SIZES)
    lattices: tuple = ("unit",)


PLAIN = Measure("cgal_plain")
BUILD = Measure("build")
RUN = Measure("iteration", "run_seconds")
PLAIN_3 = Measure("cgal_plain_3")
SPACE_BUILD = Measure("space_build")


def in_space(text, over, under=PLAIN_3, bound=""):
    """A row of three dimensions."""
    return Row(text, over, under, bound, sizes=(10_000, 100_000), lattices=("cube",))


def prescribed_volumes(text, case, bounds):
    """Rows of one case with a bound for each size."""
    return [Row(text, Measure(case), PLAIN_3, bound, sizes=(n,), lattices=("cube",))
            for n, bound in bounds.items()]


ROWS = [
    Row("evaluation with certificate, converging regime / one CGAL plain build of n sites",
        Measure("evaluation"), PLAIN, "1/25", lattices=PLANE),
    Row("whole L-BFGS iteration, mean from random to RMS residual 1e-4 / CGAL plain build",
        Measure("iteration"), PLAIN, "1/14", lattices=PLANE),
    Row("initial periodic Delaunay / CGAL plain build",
        BUILD, PLAIN, "0.6", lattices=PLANE),
    Row("CGAL Periodic_2 / our initial build",
        Measure("cgal_periodic"), BUILD, "≥ 20"),
    Row("random start to RMS residual 1e-4, plain L-BFGS, in CGAL plain builds",
        RUN, PLAIN, "26", sizes=(100_000,)),
    Row("the same with the usual solver, in CGAL plain builds",
        Measure("usual_run"), PLAIN, "12", sizes=(100_000,)),
    Row("weights for areas lognormal:0.42 of random sites / our initial build",
        Measure("area_newton"), BUILD, "25", sizes=(100_000,)),
    Row("same start, same optimiser, mirror diagram rebuilt each time / ours, end to end",
        Measure("mirror_run"), RUN, "≥ 30", sizes=(10_000,)),
    Row("resident bytes a site (no mesh output)",
        Measure("memory", "bytes_per_site"), bound="260", sizes=(1_000_000,)),
    Row("tile of the cells and its proof, in CGAL plain builds", Measure("tile"), PLAIN),
    Row("OBJ and GLB of it, written, read back and proved, in CGAL plain builds",
        Measure("files"), PLAIN),
    Row("flips a site after the build, whole run",
        Measure("iteration", "flips_per_site"), bound="2.2"),
    Row("rebuilds, whole run",
        Measure("iteration", "rebuilds"), bound="0"),
    Row("2 threads / 1 thread, evaluation",
        Measure("evaluation_2_threads"), Measure("evaluation"), "1/1.6",
        sizes=(100_000, 1_000_000)),
    Row("5,000 runs to residual 1e-8 on one core, seconds",
        Measure("small_runs"), bound="60", sizes=(150,)),
    Row("a run of 100 iterations by the C interface / by a call of the mesher",
        Measure("abi", "ratio"), bound="1.02", sizes=(100_000,)),
    Row("all nine copies by CGAL (the paper's comparison) / our initial build",
        Measure("cgal_nine_copies"), BUILD),
    Row("our mirror diagram / our initial build", Measure("mirrors"), BUILD),
    Row("voro++, one layer of prisms / our initial build", Measure("voro"), BUILD),
    Row("all nine copies by CGAL / CGAL plain build", Measure("cgal_nine_copies"), PLAIN),
    Row("CGAL Periodic_2 / CGAL plain build", Measure("cgal_periodic"), PLAIN),
    Row("our mirror diagram / CGAL plain build", Measure("mirrors"), PLAIN),
    Row("voro++ / CGAL plain build", Measure("voro"), PLAIN),
    in_space("evaluation with certificate, converging regime / CGAL plain build",
             Measure("space_evaluation"), bound="1/12"),
    in_space("whole L-BFGS iteration, mean from random to RMS residual 1e-4 / CGAL plain build",
             Measure("space_iteration"), bound="1/8"),
    in_space("initial periodic Delaunay / CGAL plain build", SPACE_BUILD, bound="1.6"),
    in_space("CGAL Periodic_3 / our initial build", Measure("cgal_periodic_3"), SPACE_BUILD, "≥ 2.5"),
    in_space("our mirrors / our initial build", Measure("space_mirrors"), SPACE_BUILD),
    in_space("rebuilds, whole run", Measure("space_iteration", "rebuilds"), None),
    *prescribed_volumes("weights for volumes of a lognormal law, S = 0.35, to 1e-10 / CGAL plain build",
                        "volume_newton", {1000: "8", 10_000: "8", 100_000: "12"}),
    *prescribed_volumes("the same with five centroidal steps / CGAL plain build",
                        "space_grains", {1000: "30", 10_000: "30", 100_000: "30"}),
    Row("seconds for 256 x 256 x 256 voxels", Measure("space_voxels"), None, "0.4", (1000,), ("cube",)),
    Row("seconds for 256 x 256 x 256 voxels", Measure("space_voxels"), None, "", (10_000,), ("cube",)),
]

# Cases whose times the second table lists, in this order.
TIMED = ["cgal_plain", "build", "evaluation", "iteration",
         "cgal_nine_copies", "cgal_periodic", "mirrors", "voro",
         "cgal_plain_3", "space_build", "space_evaluation", "space_iteration", "space_mirrors",
         "cgal_periodic_3", "volume_newton", "space_grains"]


class Rounds:
    """All values of all cases: {(what, lattice, n): {counter: [one per round]}}."""

    def __init__(self, documents):
        self.contexts = [document["context"] for document in documents]
        self.values = {}
        for document in documents:
            for case in document["benchmarks"]:
                self._add(case)

    def _add(self, case):
        if case.get("error_occurred"):
            sys.exit(f"table.py: {case['name']}: {case.get('error_message', 'failed')}")
        what, lattice, n, *clock = case["name"].split("/")
        time = "real_time" if {"real_time", "manual_time"} & set(clock) else "cpu_time"
        found = self.values.setdefault((what, lattice, int(n)), {})
        for name, value in case.items():
            if isinstance(value, (int, float)):
                found.setdefault(name, []).append(value)
        found.setdefault("seconds", []).append(case[time] * SECONDS[case["time_unit"]])

    def all_of(self, measure, lattice, n):
        return self.values.get((measure.what, lattice, n), {}).get(measure.counter, [])

    def value_of(self, row, lattice, n):
        """The row's number, or None where a case is missing."""
        over = self.all_of(row.over, lattice, n)
        under = self.all_of(row.under, lattice, n) if row.under else [1]
        return statistics.median(over) / statistics.median(under) if over and under else None


def is_missed(bound, value):
    if bound.startswith("≥ "):
        return value < float(bound[2:])
    top, _, bottom = bound.partition("/")
    return value > float(top) / float(bottom or 1)


def digits(value):
    """Three digits, without an exponent."""
    return f"{value:.0f}" if value >= 100 else f"{value:.3g}"


def cell(row, n, value):
    if value is None:
        return "-"
    text = "1/" + digits(1 / value) if row.bound.startswith("1/") and value else digits(value)
    if n not in SIZES:
        text += f" (n = {n})"
    return text + (" **missed**" if row.bound and is_missed(row.bound, value) else "")


def line(cells):
    return "| " + " | ".join(cells) + " |"


def head(*titles):
    return [line([*titles, "n = 1e4", "1e5", "1e6"]), "|---" * (len(titles) + 3) + "|"]


def ratio_lines(rounds):
    for row in ROWS:
        for lattice in row.lattices:
            # A size outside of SIZES is shown in the first column.
            sizes = [n for n in row.sizes if n not in SIZES] or SIZES
            cells = [cell(row, n, rounds.value_of(row, lattice, n) if n in row.sizes else None)
                     for n in sizes] + ["-"] * (len(SIZES) - len(sizes))
            yield line([row.text + LATTICES[lattice], row.bound, *cells])


def time_cell(seconds, n):
    if not seconds:
        return "-"
    median = statistics.median(seconds)
    spread = (max(seconds) - min(seconds)) / median
    return f"{digits(median / n * 1e9)} ({100 * spread:.0f} %)"


def time_lines(rounds):
    for what in TIMED:
        for lattice in LATTICES:
            cells = [time_cell(rounds.all_of(Measure(what), lattice, n), n) for n in SIZES]
            if cells != ["-"] * len(SIZES):
                yield line([f"`{what}`{LATTICES[lattice]}", *cells])


def machine():
    """Model and number of the processors of this machine."""
    text = subprocess.run(["lscpu"], capture_output=True, text=True, check=True,
                          env={"LC_ALL": "C", "PATH": "/usr/bin:/bin"}).stdout
    fields = dict(map(str.strip, row.split(":", 1)) for row in text.splitlines() if ":" in row)
    return f"{fields['Model name']}, {fields['CPU(s)']} cores"


def table(documents, processor):
    rounds = Rounds(documents)
    first = rounds.contexts[0]
    load = max(context["load_avg"][0] for context in rounds.contexts)
    return "\n".join([
        f"{first['date'][:10]}; {processor}; {first['compiler']}, {first['flags']}; "
        f"median of {len(documents)} rounds; highest load before a round {load:.1f}",
        "", *head("unit square unless named", "at most"), *ratio_lines(rounds),
        "", "Nanoseconds a site, median (range over the rounds). Excluded for peers and for us: fresh "
        "pages of the heap, and destruction:", "", *head("case"), *time_lines(rounds)])


def planted_round(time, rebuilds):
    def case(name, milliseconds, **more):
        return {"name": name, "cpu_time": milliseconds, "real_time": 2 * milliseconds,
                "time_unit": "ms", **more}
    return {"context": {"date": "2000-01-02T00:00:00", "compiler": "C", "flags": "-O",
                        "load_avg": [0.5, 9, 9]},
            "benchmarks": [case("cgal_plain/unit/10000", 5 * time), case("build/unit/10000", time),
                           case("evaluation/unit/10000", time / 6),
                           case("iteration/unit/10000/manual_time", 1, rebuilds=rebuilds),
                           case("small_runs/unit/150", 61e3)]}


def self_test():
    text = table([planted_round(time, time - 1) for time in (1, 3, 100)], "P, 2 cores")
    expected = [
        "2000-01-02; P, 2 cores; C, -O; median of 3 rounds; highest load before a round 0.5",
        "converging regime / one CGAL plain build of n sites | 1/25 | 1/30 | - | - |",
        "CGAL plain build | 1/14 | 1/7.5 **missed** | - | - |",
        "| initial periodic Delaunay / CGAL plain build | 0.6 | 0.2 | - | - |",
        "| rebuilds, whole run | 0 | 2 **missed** | - | - |",
        "seconds | 60 | 61 (n = 150) **missed** | - | - |",
        "| CGAL Periodic_2 / our initial build | ≥ 20 | - | - | - |",
        "| `cgal_plain` | 1500 (3300 %) | - | - |",
    ]
    missing = [words for words in expected if words not in text]
    if missing or not is_missed("≥ 20", 19.9) or is_missed("1/1.6", 0.62):
        sys.exit(f"{text}\nmissing: {missing}")


def main(arguments):
    if arguments == ["--self-test"]:
        self_test()
    elif arguments and not arguments[0].startswith("-"):
        documents = []
        for path in arguments:
            with open(path, encoding="utf-8") as file:
                documents.append(json.load(file))
        print(table(documents, machine()))
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    main(sys.argv[1:])
