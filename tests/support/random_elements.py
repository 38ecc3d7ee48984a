"""Random volume elements: cells and tetrahedra in cells, whole or in a box, with an independent count of their files.

element_job(draw) is the options of one sound job; the same draws give the same job. count_job() runs it, lets
`pcvt check` prove each file, counts each file again (space_count.py, surface_count.py), compares the cells with their
definition (cell_distances.py) and their volumes with the prescribed ones, and returns the faults.
"""

import re
import subprocess

import numpy as np

from support import cell_distances, space_count, surface_count
from support.random_inputs import area_text, row, space_lattice_option

FORMATS = {"grains": ("msh", "inp", "vtu", "foam", "stl"), "voronoi": ("vtu", "foam", "stl", "obj", "ply", "glb", "om")}
SURFACES = {"obj", "ply", "glb"}
# Tetrahedra inside of a cell take some ms each; random cells have three times as many.
MOST_GRAINS = 6
MOST_CELLS = 30
# A box of period vectors that are much longer than the cells are wide cuts each cell into many pieces.
MOST_SHEARED = 3
MOST_SHEAR = 4
# A job may be refused for the single precision of a file, for a boundary that touches itself, for a side of a box in a
# face that the removal of short edges has bent, and for a face too narrow for tetrahedra of its size. Volumes at centroids
# that power cells cannot have leave sites 1e-5 h from each other, and faces as narrow.
REFUSALS = re.compile(r"single precision|touches itself|cells are so small beside|32-bit floats|nearly contain a face|"
                      "so narrow that a tetrahedron")
LONGEST_RUN = 300
# Edges under 0.001 h are removed without --short-edges where cells with tetrahedra are Voronoi cells.
SHORTEST = 1e-3
# Points inside of bent faces lie further from the plane between the sites than the corners of the face, which move by 1: heights are
# means with other weights than places in the face. In 5,500 jobs they moved by at most 1.2.
INSIDE_OF_BENT_FACES = 1.5


def listed_sites(draw, start, lattice):
    """The words of sites of a file, and its text: points of a grid, about those, or balls with small cells and large ones."""
    if start == "balls":
        n = draw.randrange(2, MOST_GRAINS)
        sites = [[draw.random() for _ in range(3)] for _ in range(n)]
        radii = [draw.uniform(0, 0.3) * (abs(np.linalg.det(lattice)) / n) ** (1 / 3) for _ in sites]
        text = "".join(row([*(np.array(site) @ lattice), radius]) + "\n" for site, radius in zip(sites, radii))
        return ["--input", "s.txt", "--weights", "s.txt:radius", "--max-iterations", 0], "x y z radius\n" + text, n
    m = draw.choice((1, 1, 2))
    sites = [[i / m, j / m, k / m] for i in range(m) for j in range(m) for k in range(m)]
    if draw.random() < 0.5:
        # Body-centred: truncated octahedra, whose corners have more cells than four.
        sites += [[x + 0.5 / m for x in site] for site in sites]
    if start != "grid":
        sites = [[x + draw.uniform(-0.2, 0.2) / m for x in site] for site in sites]
    text = "".join(row(np.array(site) @ lattice) + "\n" for site in sites)
    if start == "centroids":
        return ["--centroids", "s.txt", "--volumes", "volumes.txt", "--max-iterations", 20], text, len(sites)
    return ["--input", "s.txt", "--max-iterations", 0 if start == "grid" else draw.choice((0, 3))], text, len(sites)


def site_options(draw, kind, shape, words, inputs):
    """Sites, drawn or listed, of equal or prescribed volumes, or with weights, and their number."""
    most = MOST_SHEARED if shape == "sheared" else MOST_GRAINS if kind == "grains" else MOST_CELLS
    n = round(most ** draw.random())
    start = draw.choice(("drawn", "drawn", "drawn", "volumes", "volumes", "grid", "cluster", "balls", "centroids", "lattice"))
    if start == "volumes":
        law = draw.choice(("equal", "lognormal:0.2", "lognormal:0.4", "file"))
        if law == "file":
            inputs["volumes.txt"] = area_text(draw, n, False)
        return ["--sites", n, "--seed", draw.randrange(10**6), "--volumes", law if law != "file" else "volumes.txt",
                "--max-iterations", draw.choice((0, 1, 5))], n
    if start in ("grid", "cluster", "balls", "centroids"):
        options, inputs["s.txt"], n = listed_sites(draw, start, rows_of(words))
        if start == "centroids":
            inputs["volumes.txt"] = "".join(f"{draw.uniform(0.7, 1.4):.6g}\n" for _ in range(n))
        return options, n
    if start == "lattice":
        return ["--sites", n, "--start", "lattice", "--max-iterations", 0], n
    return ["--sites", n, "--seed", draw.randrange(10**6), "--max-iterations", draw.choice((0, 1, 10, 60)), "--tolerance",
            draw.choice(("1e-2", "1e-4"))], n


def rows_of(words):
    """The rows of the lattice of the first two words."""
    numbers = [float(x) for x in words[1].split(",")]
    return np.diag(numbers) if len(numbers) == 3 else np.reshape(numbers, (3, 3))


def sheared_rows(draw):
    """A basis of an oblique lattice far from reduced: a box of its vectors is long and thin."""
    rows = np.eye(3)
    rows[1:, 0] = draw.uniform(-0.5, 0.5), draw.uniform(-0.5, 0.5)
    rows[2, 1:] = draw.uniform(-0.5, 0.5), draw.uniform(0.4, 2)
    rows[1] += draw.randrange(-MOST_SHEAR, MOST_SHEAR + 1) * rows[0]
    rows[2] += draw.randrange(-MOST_SHEAR, MOST_SHEAR + 1) * rows[1]
    return rows


def lattice_options(draw, shape):
    if shape == "sheared":
        return "--lattice", ",".join(f"{x:.9g}" for x in sheared_rows(draw).flat)
    if shape != "thin":
        return space_lattice_option(draw, shape, 1.0)
    return "--period", ",".join(f"{10 ** draw.uniform(-0.6, 0.6):.9g}" for _ in range(3))


def chosen_formats(draw, kind, words):
    """The extensions that a job writes, all of which take its other words."""
    cells = ("vtu", "stl") if "--aspect" in words else ("vtu", "foam", "stl") if "--short-edges" in words else FORMATS["voronoi"]
    formats = FORMATS[kind] if kind == "grains" else cells
    if "--volumes" in words or "--weights" in words:
        formats = tuple(extension for extension in formats if extension != "om")
    chosen = draw.sample(formats, draw.choice((1, 1, 2)))
    # Order 2, phases and orientations want a file that holds them.
    return sorted({*chosen, draw.choice(("inp", "vtu"))}) if kind == "grains" else chosen


def element_job(draw):
    """Returns the words of a job, the files that it reads, and the extensions that it writes.

    The word --origin=vertex means a corner of a cell, which only a run can tell."""
    inputs = {}
    kind = draw.choice(("grains", "grains", "grains", "voronoi"))
    shape = draw.choice(("cube", "cube", "box", "box", "oblique", "oblique", "oblique", "thin", "sheared"))
    words = list(lattice_options(draw, shape))
    options, n = site_options(draw, kind, shape, words, inputs)
    words += [*options, "--mesh", kind]
    if draw.random() < 0.5:
        words += ["--outline", "box"]
    origin = draw.choice((None, None, "auto", "0.3,-0.2,0.1", "0.5,0.5,0.5", "-7,3,11", "vertex", "vertex"))
    if origin and (origin not in ("auto", "vertex") or "box" in words):
        words += [f"--origin={origin}"]
    is_power = "--volumes" in words or "--weights" in words
    if draw.random() < 0.2 and not is_power:
        words += ["--short-edges", draw.choice((0.01, 0.05, 0.1))]
    elif draw.random() < 0.1 and "--weights" not in words and "--centroids" not in words:
        words += ["--aspect", ",".join(f"{x:.4g}" for x in (draw.uniform(0.4, 3), *(draw.uniform(-1, 1) for _ in range(3))))]
    if draw.random() < 0.05 and n < 4:
        words += ["--repeat", draw.choice(("2x1x1", "1x2x1", "1x1x2"))]
    chosen = chosen_formats(draw, kind, words)
    if kind == "grains":
        size = draw.choice((0.69, 0.69, 0.5, None))
        if size:
            words += ["--size", f"{size * (abs(np.linalg.det(rows_of(words))) / n) ** (1 / 3):.6g}"]
        if draw.random() < 0.3:
            words += ["--order", 2]
        if draw.random() < 0.4:
            words += ["--phases", draw.choice(("a:0.5,b:0.5", "a:0.2,b:0.3,c:0.5"))]
        if draw.random() < 0.3:
            words += ["--orientations", "random"]
        if "inp" in chosen and draw.random() < 0.5:
            words += ["--job", "elastic", "--material", "same"] if "--phases" in words else ["--job", "elastic"]
    if {"stl", "obj", "ply", "glb"} & {*chosen} and not is_power and draw.random() < 0.3:
        words += ["--surface", "boundary"]
    words += [word for extension in (*chosen, "csv") for word in ("-o", f"t.{extension}")]
    return [*words, "--threads", draw.choice((1, 2))], inputs, chosen


def with_vertex(run_pcvt, folder, words, draw):
    """Replaces the word --origin=vertex by the corner of a cell of the same sites. Returns the words, or none if it is refused."""
    if "--origin=vertex" not in words:
        return words
    end = words.index("--mesh")
    aspect = words[words.index("--aspect"):][:2] if "--aspect" in words else []
    done = run_pcvt("mesh", *words[:end], *aspect, "-o", "v.vtu", "--quiet", cwd=folder, timeout=LONGEST_RUN)
    if done.returncode != 0:
        return [word for word in words if word != "--origin=vertex"]
    corner = draw.choice(space_count.read(folder / "v.vtu").points.tolist())
    return [f"--origin={','.join(map(repr, corner))}" if word == "--origin=vertex" else word for word in words]


def require_definition(path, mesh, words, targets):
    """Compares the cells of a file with those of the sites in the table, and their volumes with the prescribed ones."""
    if mesh.owners is None or min(mesh.owners) < 0:
        return
    repeats = [int(x) for x in words[words.index("--repeat") + 1].split("x")] if "--repeat" in words else (1, 1, 1)
    cells = cell_distances.Cells(path.with_name("t.csv"), mesh.lattice / np.reshape(repeats, (3, 1)))
    owners = cells.owners_of(mesh.sites) if hasattr(mesh, "sites") else mesh.owners
    aspect = [float(x) for x in words[words.index("--aspect") + 1].split(",")] if "--aspect" in words else None
    is_power = "--volumes" in words or "--weights" in words
    removed = words[words.index("--short-edges") + 1] if "--short-edges" in words else 0
    if "grains" in words and not is_power:
        removed = max(removed, SHORTEST)
    if path.suffix != ".glb":
        cell_distances.require_cells(cells, mesh.points, mesh.elements, owners, INSIDE_OF_BENT_FACES * removed * cells.h, aspect)
    tolerance = 1e-4 if path.suffix == ".glb" else removed if removed else 1e-9
    cell_distances.require_volumes(cells, owners, mesh.volumes, tolerance)
    if targets:
        cell_distances.require_targets(cells, targets)


def targets_of(words, inputs):
    """The prescribed volumes, up to a factor."""
    if "--volumes" not in words:
        return None
    if "volumes.txt" in words:
        head, *rest = lines = inputs["volumes.txt"].split()
        return [float(x) ** 3 for x in rest] if head == "diameter" else [float(x) for x in lines]
    return [1] * words[words.index("--sites") + 1] if "equal" in words else None


def count_file(path, words, inputs):
    if path.suffix == ".stl":
        space_count.counted(path)
    elif path.suffix != ".om":
        counts = surface_count if path.suffix[1:] in SURFACES else space_count
        mesh = counts.read(path)
        counts.count_of(mesh)
        require_definition(path, mesh, words, targets_of(words, inputs))


def count_job(run_pcvt, folder, draw):
    """Returns the words of a job and its faults; where it was refused for a file, the refusal."""
    words, inputs, chosen = element_job(draw)
    for name, text in inputs.items():
        (folder / name).write_text(text)
    try:
        words = with_vertex(run_pcvt, folder, words, draw)
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
            count_file(path, words, inputs)
        except space_count.Fault as fault:
            faults.append(f"{path.name}: {fault}")
    return words, faults, refusal
