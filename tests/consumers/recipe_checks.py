"""The rows of `recipes`: for each heading above a code block, the check of its result."""

import csv
import json
import math
import pathlib
import re
import subprocess
import sys
from collections.abc import Callable
from dataclasses import dataclass

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1]))
from support.vti import read_vti  # noqa: E402


@dataclass
class Row:
    """Either a check, called with the folder and the text that the shell printed, or a reason."""
    check: Callable = None
    programs: tuple = ()
    modules: tuple = ()  # of Python
    as_root: bool = False
    wrapper: str = ""  # a script beside this file that runs the shell
    reason: str = ""  # why the block is not run


def require(holds, complaint):
    if not holds:
        raise AssertionError(complaint)


def require_near(value, expected, tolerance, name):
    require(abs(value - expected) <= tolerance * abs(expected),
            f"{name} is {value}, not {expected}")


def require_files(folder, *names):
    for name in names:
        require((folder / name).stat().st_size > 0, f"{name} is empty")


def number(text, pattern):
    return float(re.search(pattern, text, re.M)[1])


def check_first_mesh(folder, text):
    require_files(folder, "tile.obj", "tile.svg")
    for word in ("stop ", "of the hexagonal bound", "hexagons ", "pairs"):
        require(word in text, f"the summary does not have '{word}'")
    require(re.search(r"^tile\.obj: .*periodic tile", text, re.M), "check does not accept tile.obj")


def check_jobs(folder, text):
    require_files(folder, "grains.svg", "grains.csv", "job.inp", "grains.vti", "pairs.msh", "pairs.vtu",
                  "case.foam", "mesh.nc", "graded.svg", "seamless.glb", "seamless.png", "best.svg",
                  "rosette.svg", "foam.vtu", "pattern.svg", "results/fig9.svg")
    require("did not" not in text, "a run did not converge")


def check_tiles(folder, text):
    require(len(re.findall(r"^(?:grains|tile)\.\w+: a periodic tile", text, re.M)) == 3, "check does not accept a tile")
    require("areas of 60 cells" in text, "check does not compare the areas")


def check_options(folder, text):
    require_files(folder, "options.json")
    require("'number': 4, 'plane': True, 'space': False" in text, "--start best is for the plane only")


def check_rosette(folder, text):
    require_files(folder, "rosette.svg")
    require("rosette.vtu: a periodic tile" in text, "check does not accept rosette.vtu")
    with open(folder / "rosette.csv", encoding="ascii") as lines:
        orbits = [int(row["orbit"]) for row in csv.DictReader(line for line in lines if not line.startswith("#"))]
    require(len(orbits) == 242 and max(orbits.count(orbit) for orbit in set(orbits)) == 8, "an orbit has other sites")


def check_measured_sizes(folder, _):
    with open(folder / "grains.csv", encoding="ascii") as lines:
        rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
    for row, diameter in zip(rows, (0.50, 0.62, 0.41, 0.45, 0.70), strict=True):
        require_near(float(row["diameter"]), diameter, 1e-9, "a diameter")
    require(float(rows[0]["phi2"]) == -70, "the orientation of grain 0")


def check_table_of_grains(folder, _):
    with open(folder / "ebsd-cells.csv", encoding="ascii") as lines:
        rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
    for row, diameter in zip(rows, (0.50, 0.62, 0.41), strict=True):
        require_near(float(row["diameter"]), diameter, 1e-9, "a diameter")
    require_near(float(rows[0]["phi2"]), math.degrees(-1.22), 1e-9, "the orientation of grain 0")
    require_files(folder, "ebsd.vti")


def check_sizes(folder, _):
    require_files(folder, "grains.svg", "grains.csv")
    roundness = json.loads((folder / "grains.json").read_text())["areas"]["circularity_mean"]
    require_near(roundness, 0.90, 0.005, "the mean circularity")


def check_laguerre(folder, _):
    require_files(folder, "laguerre.svg")
    tables = []
    for name in ("laguerre.csv", "again.csv"):
        with open(folder / name, encoding="ascii") as lines:
            tables.append(list(csv.DictReader(line for line in lines if not line.startswith("#"))))
    for row, again, radius in zip(*tables, (0.20, 0.28, 0.25, 0.15), strict=True):
        require_near(float(row["weight"]), radius**2, 1e-15, "a weight")
        require_near(float(again["area"]), float(row["area"]), 1e-13, "an area")


def check_voxels(folder, text):
    require(re.search(r"^grains\.vti: ", text, re.M), "check does not accept grains.vti")
    counts, _, _, materials = read_vti((folder / "grains.vti").read_text())
    require(counts == [256, 256, 1], "the image has other counts of voxels")
    entries = re.findall(r"^      - phase: (\w+)$", (folder / "grains.material.yaml").read_text(), re.M)
    require(sorted(set(materials)) == list(range(len(entries))) == list(range(200)), "a grain has no voxel")
    hard = sum(entries[m] == "martensite" for m in materials) / len(materials)
    require(abs(hard - 0.2) < 0.01, f"martensite takes {hard} of the voxels, not 0.2")
    load = (folder / "load.yaml").read_text()
    # Each component of the mean deformation or of the mean stress is given, never both.
    rates, stresses = (re.findall(r"[\w.-]+", re.search(rf"^ +{key}: (.*)$", load, re.M)[1]) for key in ("dot_F", "P"))
    require(len(rates) == len(stresses) == 9, "the load has no 3 x 3 components")
    require(all((r == "x") != (p == "x") for r, p in zip(rates, stresses)), "a component of the load is given twice, or not")


def check_graded(folder, text):
    require(text.count("converged") == 2, "a run did not converge")
    require_files(folder, "ridge.svg", "moon.svg")


def check_walls(folder, text):
    require(text.count("converged") == 2, "a run did not converge")
    for name in ("channel.svg", "box.svg"):
        require("between walls" in (folder / name).read_text(), f"{name} shows no walls")


def check_film(folder, text):
    require("converged: off by at most" in text, "the widths of the grains are not reached")
    with open(folder / "film.csv", encoding="ascii") as lines:
        rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
    require(len(rows) == 12 and all(row["sides"] == "4" and row["y"] == "0.5" for row in rows), "the grains are not columns")
    # S of the points of all elements; E / (1 - nu^2) of soft and hard grains under e_xx = 1e-3.
    stresses = [list(map(float, row.split()[2:])) for row in (folder / "job.dat").read_text().splitlines() if len(row.split()) == 8]
    soft = 100 / 0.91
    mean = sum(s[0] for s in stresses) / len(stresses)
    require(soft < mean < 2 * soft, f"the mean S_xx is {mean}")
    across = abs(sum(s[1] for s in stresses) / len(stresses))
    require(across < 0.05 * mean, f"the mean S_yy between free surfaces is {across}")
    require("von Mises stress" in (folder / "stress.svg").read_text(), "no scale")


def check_grains(folder, _):
    require_files(folder, "tile.msh", "tile.inp", "tile.vtu")


def check_calculix(folder, text):
    poisson = 0.3
    stress = (1 - poisson) * 1e-3 / (1 + poisson) / (1 - 2 * poisson)
    require_near(stress, 1.346e-3, 1e-3, "the stress that the text states")
    require_near(number(text, r"^mean S_xx (\S+)"), stress, 1e-4, "S_xx")
    # Two materials, 1 and 10: between the bounds of Reuss and Voigt for equal shares.
    rows = [line.split() for line in (folder / "cells.dat").read_text().splitlines()]
    stresses = [float(row[2]) for row in rows if len(row) == 8]
    mean = sum(stresses) / len(stresses)
    require(20 / 11 * stress < mean < 5.5 * stress, f"S_xx of two materials is {mean}")


def check_rve(folder, text):
    require_files(folder, "rve.inp", "rve.dat")
    require_crystals(text)


def check_crystals(folder, text):
    require_files(folder, "crystals.inp", "crystals.dat")
    require_crystals(text)


def require_crystals(text):
    """The stiffness of a polycrystal of iron."""
    rows = [line.split() for line in text.splitlines() if re.match(r"(xx|yy|zz|yz|xz|xy) ", line)]
    require([row[0] for row in rows] == ["xx", "yy", "zz", "yz", "xz", "xy"], f"the rows are {rows}")
    stiffness = [[float(word) for word in row[1:]] for row in rows]
    require(all(math.isclose(stiffness[i][j], stiffness[j][i], rel_tol=1e-4, abs_tol=10) for i in range(6) for j in range(6)),
            "the stiffness is not symmetric")
    # Bounds of iron over all orientations: C11, C12, C44 are 231400, 134700, 116400.
    for name, bulk, shear in (("Voigt", (231400 + 2 * 134700) / 3, 89180), ("Reuss", (231400 + 2 * 134700) / 3, 74473)):
        found = re.search(rf"by {name}: K (\S+), G (\S+)$", text, re.M)
        require_near(float(found[1]), bulk, 1e-3, f"the bulk modulus by {name}")
        require(74473 * 0.98 < float(found[2]) < 89180 * 1.02, f"the shear modulus by {name} is {found[2]}, not near {shear}")


def check_tension(folder, text):
    require("Von Mises stress" in (folder / "tension.svg").read_text(), "no picture")
    stress = [float(word) for word in re.search(r"^ +1 (.*)$", text, re.M)[1].split()]
    require(len(stress) == 6 and 120 < stress[0] < 300, f"S_xx is {stress[0]}")
    require(all(abs(s) < 1e-6 * stress[0] for s in stress[1:]), f"the other stresses are {stress[1:]}")
    lateral = float(re.search(r"CONTROL_2.*\n\n +\d+ +\S+ +(\S+)", (folder / "tension.dat").read_text())[1])
    require(-5e-4 < lateral < -1e-4, f"e_yy is {lateral}")


def check_grain_case(folder, text):
    require("Mesh OK." in text, "checkMesh finds a fault")
    require(re.search(r"^grains\.foam: a periodic tile of tetrahedra: \d+ in 20 cells", text, re.M), "check does not accept the case")


def check_stl(folder, text):
    for name, n in (("cells", 30), ("box", 1)):
        require(re.search(rf"^{name}\.stl: closed surfaces of triangles: \d+ triangles in {n} surfaces?, ", text, re.M),
                f"check does not find the surfaces of {name}.stl")


def check_stresses(folder, text):
    require_files(folder, "stress.svg", "phases.frd")
    require("von Mises stress" in (folder / "stress.svg").read_text(), "no scale")
    # Between the bounds of Reuss and Voigt, with the same Poisson ratio in both phases.
    plane = 0.7 / (1.3 * 0.4)
    stiffness = number(text, r"^xx +(\S+)") / plane
    require(1 / (0.7 / 210000 + 0.3 / 2100000) < stiffness < 0.7 * 210000 + 0.3 * 2100000,
            f"the homogenised modulus is {stiffness}")


def check_conductivities(folder, _):
    # Between the bounds of Reuss and Voigt.
    mean = float((folder / "mean.txt").read_text().split()[-1])
    require(1 / 0.73 < mean < 3.7, f"the mean conductivity is {mean}")


def check_fibres(folder, _):
    require_files(folder, "shapes.svg", "shapes.obj", "channel.msh", "channel.svg")
    require({"phase_fibre", "phase_carbon", "phase_steel"} <= set(re.findall(
        r"^usemtl (\S+)$", (folder / "shapes.obj").read_text(), re.M)), "a tag has no material")
    require_near(float((folder / "mean.txt").read_text().split()[-1]), 3.080, 1e-3, "the mean conductivity")


def check_composite(folder, _):
    require_files(folder, "composite.inp", "composite.svg")


def check_unidirectional(folder, text):
    require_files(folder, "ud.inp", "ud.dat")
    along = float(re.search(r"E_z (\S+)$", text, re.M)[1])
    # The mean by volume, and above it at most Hill's term.
    require(30.1 < along < 30.4, f"E_z is {along}")


def check_coated(folder, text):
    require("2 inclusions of coated.txt" in text, "the check names no inclusions")
    share = [0.09 * math.pi, 0.0325 * math.pi]
    mean = 70 * share[0] + 10 * share[1] + 3.5 * (1 - sum(share))
    along = float(re.search(r"E_z (\S+)$", text, re.M)[1])
    require(mean < along < 1.01 * mean, f"E_z is {along}, and the mean {mean}")


def check_material_file(folder, _):
    require("*MATERIAL,NAME=hard\n*ELASTIC,TYPE=ORTHO\n2.314e+11," in (folder / "metals.inp").read_text(),
            "the constants are not those of the file")


def check_cylinders(_, text):
    require_near(float(text.split()[-1]), 51.53, 0.03, "the drag over mu U")


def count_boundary(folder):
    """Returns the numbers of points of tile.vtu, and of those that are an image of another one."""
    text = (folder / "tile.vtu").read_text()
    partners = re.search(r'Name="PeriodicPointIds"[^>]*>(.*?)</DataArray>', text, re.S)[1].split()
    return len(partners), sum(int(partner) != k for k, partner in enumerate(partners))


def check_gmsh(folder, text):
    moves = re.findall(r"^curve \d+ is curve \d+ moved by \((\S+), (\S+)\): (\d+) nodes$", text,
                       re.M)
    _, n_images = count_boundary(folder)
    # A corner of the seam lies on two curves.
    n_nodes = sum(int(n) for _, _, n in moves)
    require(n_images <= n_nodes <= n_images + 2 * len(moves), f"{n_nodes} nodes, not {n_images}")
    require(all({abs(float(x)), abs(float(y))} <= {0, 1} for x, y, _ in moves), f"moves {moves}")


def check_getdp(folder, text):
    require_near(float(text.split()[-1]), 1e-5, 0.2, "the squared error")
    require_files(folder, "u.pos")


def check_two_materials(folder, text):
    # GetDP prints no name; the bounds are those of Reuss and Voigt for equal shares.
    means = [float((folder / "mean.txt").read_text().split()[-1])]
    means += map(float, re.findall(r"^mean (\S+)$", text, re.M))
    require(len(means) == 3 and 20 / 11 < min(means) and max(means) < 5.5, f"means {means}")
    require_near(min(means), max(means), 1e-6, "a mean")


def check_vtk(folder, text):
    n_points, n_images = count_boundary(folder)
    images = re.findall(r"^point (\d+) is point \d+ moved by \((\S+), (\S+)\) periods$", text, re.M)
    require(len(images) == n_images, f"{len(images)} images, not {n_images}")
    require(all(int(k) < n_points and (float(i), float(j)) != (0, 0) for k, i, j in images),
            "a point is out of range, or does not move")


def speeds(path):
    values = re.search(r"nonuniform List<vector>\s*\d+\s*\(\n(.*?)\n\)", path.read_text(), re.S)[1]
    return [math.hypot(*map(float, line.strip("()").split())) for line in values.splitlines()]


def check_openfoam(folder, text):
    require("Mesh OK." in text, "checkMesh finds faults")
    case = folder / "case.foam"
    fall = sum(speeds(case / "0.25/U")) / sum(speeds(case / "0/U"))
    # The rate is right within 2 %.
    require_near(math.log(fall), -1, 0.02, "the logarithm of the fall of the speed")
    require_files(folder, "flow.svg")


def check_space(folder, text):
    require(text.count("a periodic tile of polyhedra: 1000 cells") == 2, "check does not accept the polyhedra")
    require("Mesh OK." in text, "checkMesh finds faults")
    case = folder / "space.foam"
    fall = sum(speeds(case / "0.25/U")) / sum(speeds(case / "0/U"))
    # With ten cells to the wave the rate is right within 5 %.
    require_near(math.log(fall), -1, 0.05, "the logarithm of the fall of the speed")


def check_grain_tetrahedra(folder, text):
    accepted = re.findall(r"^grains\.\w+: a periodic tile of tetrahedra: \d+ in 200 cells", text, re.M)
    require(len(accepted) == 2, "check does not accept the tetrahedra")


def check_space_box(folder, text):
    boxes = re.findall(r"^(\S+): a periodic tile .* by 3 translations.* a box at \(0, 0, 0\)", text, re.M)
    require(boxes == ["box.vtu", "box.foam"], "check does not accept the boxes")
    origin = json.loads((folder / "rve.json").read_text())["box"]["origin"]
    require(all(0 < x < 1 for x in origin), "no origin is chosen")
    require(re.search(r"^rve\.msh: .* in 50 cells .* a box at ", text, re.M), "check does not accept the grains")


def check_texture(folder, text):
    report = json.loads((folder / "copper.json").read_text())
    require(report["orientations"]["listed"] == 2, "the orientations are not drawn from the list")
    require(sum(report["misorientations"]["counts"]) == 600, "not all neighbours are compared")


def check_measured_grains(folder, text):
    report = json.loads((folder / "measured.json").read_text())
    misfit = report["centroids"]["largest_misfit"]
    require(0 <= misfit < 1, "the misfit of the centroids is not in the report")
    require("power cells of 4 sites" in text, "check does not accept the measured grains")


def check_elongated(folder, text):
    require_files(folder, "rolled.vti")
    require("a periodic tile of polyhedra: 500 cells" in text, "check does not accept the elongated cells")


def check_colours_in_space(folder, text):
    require_files(folder, "crystals.svg", "crystals.obj")
    require("newmtl ipf_" in (folder / "crystals.mtl").read_text(), "the crystals have no colours")


def check_surfaces(folder, text):
    require_files(folder, "cells.svg")
    accepted = re.findall(r"^(?:cells|boundary)\.\w+: (?:surfaces of |the boundary of )?a periodic tile of polyhedra", text, re.M)
    require(len(accepted) == 5, "check does not accept the surfaces")


def check_space_grains(folder, text):
    with open(folder / "grains.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    volumes = [float(row["volume"]) for row in rows if row["phase"] == "ferrite"]
    require(len(rows) == 500 and abs(sum(volumes) - 0.3) < 1e-3, "the phases have other shares")
    require("grains.vtu: a periodic tile of polyhedra: 500 cells" in text, "check does not accept the cells")


def check_space_sizes(folder, text):
    with open(folder / "sizes.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    diameters = [float(row["diameter"]) for row in rows]
    mean = sum(diameters) / len(rows)
    spread = math.sqrt(sum((d - mean) ** 2 for d in diameters) / len(rows)) / mean
    require(abs(spread - 0.35) < 0.04, f"the diameters have std / mean {spread}")
    require("sizes.vtu: a periodic tile of polyhedra: 1000 cells" in text, "check does not accept the cells")


def check_space_voxels(folder, text):
    require(re.search(r"^grains\.vti: ", text, re.M), "check does not accept grains.vti")
    require_files(folder, "grains.material.yaml")


def check_balls(folder, text):
    require_files(folder, "cells.csv")
    require("balls.vtu: a periodic tile of polyhedra: 4 cells" in text and ", power cells of 4 sites" in text,
            "check does not accept the power cells")


def check_faces(_, text):
    on_side, of_cell = number(text, r"^(\d+) faces on one side"), number(text, r"(\d+) faces of cell 0$")
    require(on_side > 10 and of_cell >= 4, f"{on_side} faces on one side, {of_cell} of cell 0")


def check_graphics(folder, text):
    require_files(folder, "tile.html", "tile.glb", "tile.ply", "repeated.svg", "tile.png", "one.glb",
                  "viewer.ply", "cut.dxf", "cut.svg")
    require("Mesh is two-manifold" in text and "Genus is 0" in text, "MeshLab finds faults")


def check_mathematics(folder, text):
    require_files(folder, "pattern.svg", "best.svg")
    report = json.loads((folder / "run.json").read_text())
    require(report["residual"] <= 1e-10, f"the residual is {report['residual']}")
    require("hexagons   56 of 56 cells" in text, "the pattern has other cells than hexagons")


def check_own_points(folder, text):
    require_files(folder, "tile.obj", "voronoi.obj")
    require("from-elsewhere.obj: " in text, "check does not accept from-elsewhere.obj")
    require(not re.search(r"^[^v]*\blattice\b", (folder / "from-elsewhere.obj").read_text(), re.M),
            "from-elsewhere.obj has period vectors")


def check_mpas(folder, _):
    require_files(folder, "mesh.nc")
    parts = (folder / "mesh.graph.info.part.4").read_text().split()
    require(len(parts) == 400 and set(parts) == set("0123"), "METIS does not make four parts")


def check_table1(folder, _):
    with open(folder / "results/table1.csv", encoding="ascii") as lines:
        rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
    require(len(rows) == 7 and all(abs(float(row["PCVT_diff"])) <= 2.8e-5 for row in rows),
            "the energies differ from the paper's")


def require_merged(folder, merged):
    """The merged files must have the bytes of the study in one part."""
    if not (folder / "whole").exists():
        subprocess.run(["build/release/pcvt", "study", "fig11", "--runs", "1000", "--quiet", "-o",
                        "whole/"], cwd=folder, check=True)
    subprocess.run(["diff", "-r", "whole", merged], cwd=folder, check=True)


def require_ensemble(folder):
    """ensemble.csv must have the seeds from 1 to 100, with different tiles."""
    with open(folder / "ensemble.csv", encoding="ascii") as lines:
        rows = list(csv.DictReader(lines))
    require([int(row["seed"]) for row in rows] == list(range(1, 101)), "seeds")
    require(all(row["stop"] == "converged" for row in rows), "a run did not converge")
    above = [float(row["energy"]) / float(row["energy_bound"]) for row in rows]
    require(1 < min(above) and max(above) < 1.05, "energies")
    require(len({row["energy"] for row in rows}) > 90, "the tiles are alike")
    require_files(folder, *(f"tile-{seed}.ply" for seed in range(1, 101)))


def check_parallel(folder, _):
    require_merged(folder, "fig11")
    require_ensemble(folder)
    (folder / "ensemble.csv").rename(folder / "parallel.csv")
    for path in [*folder.glob("part*.csv"), *folder.glob("tile-*")]:
        path.unlink()


def check_slurm(folder, _):
    require_merged(folder, "merged")
    require_ensemble(folder)
    if (folder / "parallel.csv").exists():
        subprocess.run(["cmp", "parallel.csv", "ensemble.csv"], cwd=folder, check=True)


def check_c_program(folder, text):
    require_files(folder, "tile.ply")
    require(number(text, r"^(\d+) pairs of edges on the seam") > 10, "pairs")


def check_python(folder, text):
    require_files(folder, "tour.png", "tile.glb", "tile.png")
    require(re.search(r"^energy 0\.000\d+, \d+ points, 300 cells$", text, re.M), "what it prints")


def check_files_in_c(folder, printed):
    require("tile.obj: a periodic tile: " in printed, printed)
    require(re.search(r"^4 sites: [\d.]+ percent$", printed, re.MULTILINE), printed)
    require_files(folder, "fig11/fig11.csv", "fig11/fig11-runs.csv", "fig11/fig11.svg", "fig11/fig11.html")


def check_files_in_python(folder, printed):
    require(re.search(r"^tile.obj: a periodic tile: 152 vertices, 60 faces, .*, centroidal Voronoi within ", printed,
                      re.MULTILINE), printed)
    require_files(folder, "fig11/fig11.csv", "fig11/fig11-runs.csv", "fig11/fig11.svg", "fig11/fig11.html")


def check_polyhedra(folder, _):
    require_files(folder, "tile.foam/constant/polyMesh/faces")


ROWS = {
    ("pcvt", ""): Row(reason="tests/plugin/browser/run imports the npm package"),
    ("pcvt", "Install"): Row(reason="samples/demo, samples/browser and tests/run are run by themselves"),
    ("pcvt", "A first mesh in a minute"): Row(check_first_mesh),
    ("pcvt", "Citation"): Row(reason="an entry of a bibliography"),
    # The guide. A row without a check is typed before each recipe of its page.
    ("Guide", "One command for each job"): Row(check_jobs),
    ("Install", "In one command"): Row(reason="samples/demo, samples/browser and tests/run are run by themselves"),
    ("Install", "From the sources"): Row(reason="tests/install/run installs pcvt and builds against it"),
    ("Install", "Packages"): Row(reason="tests/install/packages makes the packages and uses them"),
    ("First mesh", "Make a tile"): Row(check_first_mesh),
    ("Options", "Options for programs"): Row(check_options),
    ("Checking files", "Check a file"): Row(check_tiles),
    ("Densities", ""): Row(),
    ("Densities", "Formulas and pictures"): Row(check_graded),
    ("Grain sizes", ""): Row(),
    ("Grain sizes", "A law of grain sizes"): Row(check_sizes),
    ("Grain sizes", "Laguerre cells of points and radii"): Row(check_laguerre),
    ("Phases and orientations", ""): Row(),
    ("Phases and orientations", "Materials"): Row(check_material_file),
    ("Phases and orientations", "Textures"): Row(check_texture),
    ("Phases and orientations", "Stresses in a polycrystal"): Row(check_stresses, programs=("ccx",)),
    ("Phases and orientations", "Conductivities of phases by name"): Row(check_conductivities, programs=("gmsh", "getdp")),
    ("Walls", ""): Row(),
    ("Walls", "A channel and a box"): Row(check_walls),
    ("Walls", "A thin film"): Row(check_film, programs=("ccx",)),
    ("Inclusions and fixed sites", ""): Row(),
    ("Inclusions and fixed sites", "Fibres and other shapes"): Row(check_fibres, programs=("gmsh", "getdp")),
    ("Inclusions and fixed sites", "A fibre composite"): Row(check_composite),
    ("Inclusions and fixed sites", "Coated fibres"): Row(check_coated, programs=("ccx",)),
    ("Inclusions and fixed sites", "A unidirectional composite"): Row(check_unidirectional, programs=("ccx",)),
    ("Inclusions and fixed sites", "Flow past cylinders"): Row(check_cylinders, programs=("simpleFoam",)),
    ("Symmetry", ""): Row(),
    ("Symmetry", "A rosette"): Row(check_rosette),
    ("Space", ""): Row(),
    ("Space", "Polyhedra for OpenFOAM and VTK"): Row(check_space, programs=("icoFoam",)),
    ("Space", "Surfaces and pictures"): Row(check_surfaces),
    ("Space", "Tetrahedra inside of cells"): Row(check_grain_tetrahedra),
    ("Space", "A box with flat sides"): Row(check_space_box),
    ("Space", "Space in Python"): Row(check_faces),
    ("Materials in space", ""): Row(),
    ("Materials in space", "Phases, orientations and a table of the cells"): Row(check_space_grains),
    ("Materials in space", "Grain sizes"): Row(check_space_sizes),
    ("Materials in space", "Measured grains"): Row(check_measured_grains),
    ("Materials in space", "Elongated cells"): Row(check_elongated),
    ("Materials in space", "Laguerre cells of balls"): Row(check_balls),
    ("Materials in space", "Colours"): Row(check_colours_in_space),
    ("Materials in space", "Voxels for DAMASK"): Row(check_space_voxels),
    ("Materials in space", "Stiffness of a polycrystal"): Row(check_crystals, programs=("ccx",)),
    ("Volume elements", ""): Row(),
    ("Volume elements", "From grain sizes to the stiffness"): Row(check_rve, programs=("ccx",)),
    ("Volume elements", "Uniaxial stress"): Row(check_tension, programs=("ccx",)),
    ("Volume elements", "Grains in OpenFOAM"): Row(check_grain_case, programs=("checkMesh",)),
    ("Files for graphics", ""): Row(),
    ("Files for graphics", "STL"): Row(check_stl),
    ("Your own data", ""): Row(),
    ("Your own data", "Your own points"): Row(check_own_points),
    ("Your own data", "Grains of measured sizes"): Row(check_measured_sizes),
    ("Your own data", "Inclusions"): Row(reason="the form of a file"),
    ("Tables", ""): Row(),
    ("Tables", "A table of grains"): Row(check_table_of_grains),
    ("C and C++", "A program in C"): Row(check_c_program, programs=("cc",)),
    ("C and C++", "Files and studies"): Row(check_files_in_c, programs=("cc",)),
    ("Python", ""): Row(),
    ("Python", "A tile and its seam"): Row(check_python, modules=("matplotlib",)),
    ("Python", "Files and studies"): Row(check_files_in_python),
    ("Python", "Polyhedra"): Row(check_polyhedra),
    ("JavaScript", "The package"): Row(reason="tests/plugin/browser/run packs the package and imports it"),
    ("Samples", ""): Row(),
    ("Samples", "Materials"): Row(check_grains),
    ("Samples", "CalculiX and Abaqus"): Row(check_calculix, programs=("ccx",)),
    ("Samples", "Voxels for DAMASK"): Row(check_voxels),
    ("Samples", "Gmsh"): Row(check_gmsh, modules=("gmsh",)),
    ("Samples", "GetDP"): Row(check_getdp, programs=("gmsh", "getdp")),
    ("Samples", "Two materials in GetDP, FreeFEM and dolfinx"): Row(
        check_two_materials, programs=("gmsh", "getdp", "FreeFem++-nw"), modules=("dolfinx",)),
    ("Samples", "VTK"): Row(check_vtk, modules=("vtkmodules",)),
    ("Samples", "Fluid dynamics: OpenFOAM"): Row(check_openfoam, programs=("icoFoam",)),
    ("Samples", "Graphics"): Row(check_graphics, programs=("meshlabserver", "xvfb-run", "xauth")),
    ("Samples", "Mathematics"): Row(check_mathematics),
    ("Samples", "Ocean and atmosphere: MPAS"): Row(check_mpas, programs=("gpmetis",)),
    ("Samples", "Studies"): Row(check_table1),
    ("Samples", "GNU parallel"): Row(check_parallel, programs=("parallel",)),
    ("Samples", "Slurm"): Row(check_slurm, programs=("munged", "slurmctld", "slurmd", "sbatch"),
                              as_root=True, wrapper="slurm_node"),
    ("mesher", "From sites to a tile"): Row(reason="a diagram"),
    ("Speed", ""): Row(reason="a benchmark"),
    ("Tests", "Run all tests"): Row(reason="this runs inside of tests/run"),
    ("Tests", "Run one test"): Row(reason="it builds, as tests/run did before"),
    ("Tests", "The wheel in an empty root"): Row(reason="by hand: it makes a root; ctest runs install_wheel"),
    ("Tests", "Edit one file often"): Row(reason="a second build of some minutes, by hand"),
    ("Tests", "Compile each file alone"): Row(reason="an hour of compiling, by hand"),
    ("Tests", "Memory"): Row(reason="a campaign; ctest runs a sample"),
    ("Tests", "Fuzz the readers"): Row(reason="a campaign; ctest replays its inputs"),
}
