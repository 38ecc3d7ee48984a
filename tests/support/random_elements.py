"""Random volume elements: cells and tetrahedra in cells, whole or in a box, with an independent count of their files.

element_job(draw) is the options of one sound job; the same draws give the same job. count_job() runs it, lets
`pcvt check` prove each file, counts each file again (space_count.py), and returns the faults.
"""

import re
import subprocess

import numpy as np

from support import space_count
from support.random_inputs import area_text, row, space_lattice_option

FORMATS = {"grains": ("msh", "inp", "vtu", "foam", "stl"), "voronoi": ("vtu", "foam", "stl", "obj", "ply", "glb", "om")}
COUNTED = {"msh", "inp", "vtu", "foam", "stl"}
# Tetrahedra inside of a cell take some ms each; random cells have three times as many.
MOST_GRAINS = 7
MOST_CELLS = 40
# A box of period vectors that are much longer than the cells are wide cuts each cell into many pieces.
MOST_SHEARED = 3
# A job may be refused for the single precision of a file, for a boundary that touches itself, for a side of a box in a
# face that the removal of short edges has bent, and for a face too narrow for tetrahedra of its size.
REFUSALS = re.compile(r"single precision|touches itself|cells are so small beside|32-bit floats|nearly contain a face|"
                      "so narrow that a tetrahedron")
LONGEST_RUN = 300


def site_options(draw, kind, lattice, inputs):
    """Sites, drawn or on a grid that a box cuts at its points, of equal or prescribed volumes."""
    most = MOST_SHEARED if lattice == "sheared" else MOST_GRAINS if kind == "grains" else MOST_CELLS
    n = round(most ** draw.random())
    start = draw.choice(("drawn", "drawn", "drawn", "volumes", "grid", "cluster"))
    if start == "volumes":
        law = draw.choice(("equal", "lognormal:0.2", "lognormal:0.4", "file"))
        if law == "file":
            inputs["volumes.txt"] = area_text(draw, n, False)
        return ["--sites", n, "--seed", draw.randrange(10**6), "--volumes", law if law != "file" else "volumes.txt",
                "--max-iterations", draw.choice((0, 1, 5))]
    if start in ("grid", "cluster"):
        m = draw.choice((1, 2))
        sites = [[i / m, j / m, k / m] for i in range(m) for j in range(m) for k in range(m)]
        if draw.random() < 0.5:
            # Body-centred: truncated octahedra, whose corners have more cells than four.
            sites += [[x + 0.5 / m for x in site] for site in sites]
        if start == "cluster":
            sites = [[x + draw.uniform(-0.2, 0.2) / m for x in site] for site in sites]
        inputs["s.txt"] = "\n".join(map(row, sites)) + "\n"
        return ["--input", "s.txt", "--max-iterations", 0 if start == "grid" else draw.choice((0, 3))]
    return ["--sites", n, "--seed", draw.randrange(10**6), "--max-iterations", draw.choice((0, 1, 10, 60)), "--tolerance",
            draw.choice(("1e-2", "1e-4"))]


def spacing(words):
    """The cube root of the volume of a cell: the largest length of edges is 0.7 times as long, the default a third of it."""
    numbers = [float(x) for x in words[1].split(",")]
    rows = np.diag(numbers) if len(numbers) == 3 else np.reshape(numbers, (3, 3))
    return (abs(np.linalg.det(rows)) / int(words[words.index("--sites") + 1])) ** (1 / 3)


def element_job(draw):
    """Returns the words of a job, the files that it reads, and the extensions that it writes."""
    inputs = {}
    kind = draw.choice(("grains", "grains", "grains", "voronoi"))
    lattice = draw.choice(("cube", "cube", "box", "oblique", "oblique", "sheared"))
    words = [*space_lattice_option(draw, lattice, 1.0), *site_options(draw, kind, lattice, inputs), "--mesh", kind]
    if "--input" in words:
        words[:2] = ["--period", draw.choice(("1,1,1", "1,1,1", "1,1.3,0.8"))]
    if draw.random() < 0.5:
        words += ["--outline", "box"]
    origin = draw.choice((None, None, "auto", "0.3,-0.2,0.1", "0.5,0.5,0.5", "-7,3,11"))
    if origin and (origin != "auto" or "box" in words):
        words += [f"--origin={origin}"]
    has_volumes = "--volumes" in words
    if draw.random() < 0.2 and not has_volumes:
        words += ["--short-edges", draw.choice((0.01, 0.05, 0.1))]
    formats = FORMATS[kind]
    if kind == "grains":
        size = draw.choice((0.69, 0.69, 0.5, None))
        if size and "--sites" in words:
            words += ["--size", f"{size * spacing(words):.6g}"]
        if draw.random() < 0.3:
            words += ["--order", 2]
        if draw.random() < 0.4:
            words += ["--phases", draw.choice(("a:0.5,b:0.5", "a:0.2,b:0.3,c:0.5"))]
        if draw.random() < 0.3:
            words += ["--orientations", "random"]
    elif "--short-edges" in words:
        formats = ("vtu", "foam", "stl")
    elif has_volumes:
        formats = ("vtu", "foam", "stl", "obj", "ply", "glb")
    chosen = draw.sample(formats, draw.choice((1, 1, 2)))
    # Order 2, phases and orientations want a file that holds them.
    if kind == "grains":
        chosen = sorted({*chosen, draw.choice(("inp", "vtu"))})
        if "inp" in chosen and draw.random() < 0.5:
            words += ["--job", "elastic", "--material", "same"] if "--phases" in words else ["--job", "elastic"]
    if "stl" in chosen and not has_volumes and draw.random() < 0.3:
        words += ["--surface", "boundary"]
    words += [word for extension in chosen for word in ("-o", f"t.{extension}")]
    return [*words, "--threads", draw.choice((1, 2))], inputs, chosen


def count_job(run_pcvt, folder, draw):
    """Returns the words of a job and its faults; where it was refused for a file, the refusal."""
    words, inputs, chosen = element_job(draw)
    for name, text in inputs.items():
        (folder / name).write_text(text)
    try:
        done = run_pcvt("mesh", *words, "--quiet", cwd=folder, timeout=LONGEST_RUN)
    except subprocess.TimeoutExpired:
        return words, [f"takes more than {LONGEST_RUN} s"], ""
    error = done.stderr.decode()
    refusal = error if done.returncode in (2, 4) and REFUSALS.search(error) else ""
    if done.returncode != 0 and not refusal:
        return words, [f"mesh ended with {done.returncode}: {error}"], ""
    faults = []
    for extension in chosen:
        path = folder / f"t.{extension}"
        if not path.exists():
            faults += [] if refusal else [f"{path.name} is missing"]
            continue
        checked = run_pcvt("check", path.name, cwd=folder, timeout=LONGEST_RUN)
        if checked.returncode != 0:
            faults.append(f"check ended with {checked.returncode}: {checked.stderr.decode()[:300]}")
        try:
            if extension in COUNTED:
                space_count.counted(path)
        except space_count.Fault as fault:
            faults.append(f"{path.name}: {fault}")
    return words, faults, refusal
