"""Random runs of `pcvt mesh` and `pcvt pattern` over all options, good and bad, with the files that they read.

random_job(draw, dimension) is one Job; the same draws give the same job. Two jobs of three are sound: a theme chooses
options and values that go together. All the others mix in values, files and options that do not.
"""

import dataclasses

from support.random_inputs import (area_text, density_option, fixed_text, inclusion_text, orientation_text,
                                   plane_lattice_option, site_text, space_lattice_option)

PLANE_FORMATS = ("obj", "ply", "glb", "gltf", "om", "msh", "inp", "vtu", "svg", "png", "dxf", "html", "foam", "nc", "vti",
                 "csv", "txt")
SPACE_FORMATS = ("vtu", "foam", "msh", "inp", "obj", "ply", "glb", "om", "stl", "svg", "png", "vti", "txt")
STEMS = ("t", "t", "t", "my tile", " two  blanks ", "Gitter-ä", "格子", "a;b", "it's", 'say "x"', "50%", "a#1", "(copy)",
         "v1.2", "new/folder/t", "T")
COLOURS = ("sides", "size", "cells")
GROUPS = {"": ("p1", "p2", "pm", "pg", "cm", "pmm", "pmg", "pgg", "cmm", "p4", "p4m", "p4g"),
          "1,0,0.5,0.8660254037844386": ("p3", "p3m1", "p31m", "p6", "p6m")}
# Options that no theme chooses.
FOREIGN = (("--density", "1 + u"), ("--areas", "gamma:0.3"), ("--aspect", "2,30"), ("--walls", "y"), ("--wall-cells", "half"),
           ("--symmetry", "p4"), ("--fibres", "0.2,3"), ("--hole", "fibre"), ("--phases", "a:0.5,b:0.5"),
           ("--orientations", "random"), ("--stability",), ("--retry", "2"), ("--budget", "50"), ("--start", "lattice"),
           ("--start", "best"), ("--solver", "newton"), ("--solver", "lloyd"), ("--order", "2"), ("--size", "0.2"),
           ("--per-edge", "2"), ("--surface", "boundary"), ("--job", "elastic"), ("--element", "CPS"), ("--element", "C3D6"), ("--voxels", "8,8"),
           ("--pixels", "40"), ("--cut", "30"), ("--thickness", "0.1"), ("--background", "#ffffff"), ("--float32",),
           ("--glb-nodes", "one"), ("--density-range", "1,2"), ("--origin", "auto"), ("--repeat", "2x1"), ("--strict",),
           ("--sites", "3"), ("--period", "1,1"), ("--lattice", "1,0,0,1"), ("--mesh", "delaunay"), ("--outline", "box"),
           ("--period", "auto"), ("--material", "a:210000,0.3"), ("--material", "no.yaml"), ("--duplicates", "drop"), ("--coriolis", "1e-4"),
           ("--no-such-option",), ("stray",), ("--colour", "orbit"), ("--short-edges", "0.1"), ("--cells", "cells.csv"))


@dataclasses.dataclass
class Job:
    """The words of one run and the files that it reads."""

    command: str
    words: list
    inputs: dict

    def arguments(self):
        return [self.command, *map(str, self.words)]


class JobDraw:
    """Collects the options of one job."""

    def __init__(self, draw, dimension):
        self.draw = draw
        self.dimension = dimension
        self.is_sound = draw.random() < 0.67
        self.words = []
        self.inputs = {}
        self.n_sites = round(10 ** draw.uniform(0, 2.2 if dimension == 2 else 1.7))
        self.meshes = ["voronoi"]
        self.formats = PLANE_FORMATS if dimension == 2 else SPACE_FORMATS
        # The choices that the theme rules out.
        self.is_rectangle = self.has_lattice = self.has_phases = self.is_round = False
        self.origins = "xy"
        units = (19, -19, 37, -37, 55, -55, 61) if dimension == 2 else (12, -12, 36, -36, 41)
        self.unit = 10.0 ** draw.choice((0,) * 40 + (3, -3, 8, -8, *units))

    def often(self, probability):
        return self.draw.random() < probability

    def pick(self, good, bad=()):
        """One of the good values; of a job that is not sound perhaps one of the bad ones."""
        if bad and not self.is_sound and self.often(0.25):
            return self.draw.choice(bad)
        return self.draw.choice(good)

    def add(self, *words):
        self.words += words

    def input(self, name, text):
        self.inputs[name] = text
        return name

    def leave_out(self, *formats):
        """Formats that this job would be refused for; the others stay."""
        if self.is_sound:
            self.formats = tuple(f for f in self.formats if f not in formats)


def plane_lattice(job):
    if job.has_lattice:
        return
    kind = job.pick(("box", "box", "long") if job.is_rectangle else ("box", "long", "oblique", "sheared", "left"), ("bad",))
    if kind in ("oblique", "sheared", "left"):
        job.leave_out("nc", "vti")
    job.add(*plane_lattice_option(job.draw, kind, job.unit))


def space_lattice(job):
    kind = job.pick(("cube", "box", "thin", "oblique", "sheared"), ("bad",))
    job.is_round = kind in ("cube", "box")
    if kind in ("oblique", "sheared"):
        job.leave_out("vti")
    job.add(*space_lattice_option(job.draw, kind, job.unit))


def drawn_sites(job):
    job.add("--sites", job.pick((job.n_sites,), ("0", "-3", "1.5", "many", "", "1e3", "99999999999")), "--seed",
            job.draw.randrange(10**6))


def any_sites(job):
    """A number of sites or a file of them."""
    if not job.often(0.4):
        drawn_sites(job)
        return
    name = job.pick(("s.txt", "my sites.txt"), ("missing.txt",))
    text, job.n_sites = site_text(job.draw, job.dimension, job.unit, not job.is_sound)
    if name != "missing.txt":
        job.input(name, text)
    job.add("--input", name, *(("--duplicates", job.pick(("drop", "refuse"), ("keep",))) if job.often(0.3) else ()))


def solver(job, choices=("lbfgs", "lloyd", "newton")):
    draw = job.draw
    job.add("--max-iterations", draw.choice((0, 0, 1, 3, 10, 40)), "--tolerance", draw.choice(("1e-2", "1e-3", "1e-5", "1e-9")))
    if job.often(0.15):
        job.add("--solver", draw.choice(choices))
    if job.often(0.1):
        job.add("--strict")


# The themes of the plane: each adds options that go together.


def plain_theme(job):
    if job.often(0.3):
        drawn_sites(job)
        job.add("--start", job.draw.choice(("random", "coarse", "lattice")))
    else:
        any_sites(job)
    solver(job)
    if job.often(0.1):
        job.add("--stability")


def density_theme(job):
    any_sites(job)
    solver(job)
    job.add(*density_option(job.draw, job.inputs, not job.is_sound))


def area_theme(job):
    any_sites(job)
    law = job.pick(("equal", "lognormal:0.4", "gamma:0.5", "areas.txt", "areas.txt",
                    "0.7*lognormal:0.3@1+0.3*equal@2"), ("lognormal:9", "gamma:-1", "normal", "0.7*equal@1+0.2*equal@2"))
    if law == "areas.txt":
        job.input(law, area_text(job.draw, job.n_sites, not job.is_sound))
    job.add("--areas", law, "--max-iterations", job.draw.choice((0, 1, 5)))
    job.leave_out("nc")


def weight_theme(job):
    """The power cells of given sites; equal weights leave every site its cell."""
    text, job.n_sites = site_text(job.draw, job.dimension, job.unit, not job.is_sound)
    job.add("--input", job.input("s.txt", text), "--max-iterations", job.pick((0,), (0, 5)))
    weights = "0.25\n" * job.n_sites if job.is_sound else area_text(job.draw, job.n_sites, True)
    job.add("--weights", job.input("weights.txt", weights))
    job.leave_out("nc")


def centroid_theme(job):
    """Measured grains: centroids and sizes, which rarely belong to cells."""
    text, job.n_sites = site_text(job.draw, job.dimension, job.unit, not job.is_sound)
    job.add("--centroids", job.input("grains.txt", text), "--max-iterations", job.draw.choice((0, 1, 5, 20)))
    job.add("--areas" if job.dimension == 2 else "--volumes",
            job.input("sizes.txt", area_text(job.draw, job.n_sites, not job.is_sound)))
    job.leave_out("nc", "msh", "om")


def aspect_theme(job):
    any_sites(job)
    if job.often(0.3):
        job.add("--areas", "lognormal:0.3", "--max-iterations", job.draw.choice((0, 1, 5)))
    else:
        solver(job, ("lbfgs", "lloyd"))
    job.add("--aspect", job.pick(("2", "3,30", "0.2,77", "40,45"), ("0,1", "1e9")))
    job.leave_out("nc")


def wall_theme(job):
    any_sites(job)
    walls = job.pick(("x", "y", "xy"), ("z",))
    job.add("--walls", walls)
    half = job.often(0.5)
    if half:
        job.add("--wall-cells", "half", "--max-iterations", job.draw.choice((1, 10)))
    else:
        solver(job)
    job.is_rectangle = True
    job.origins = {"x": "y", "y": "x"}.get(walls, "")
    job.leave_out("nc", "vti")
    if job.is_sound and not half:
        job.meshes = ["voronoi", "grains"]


def symmetry_theme(job):
    lattice = job.draw.choice(tuple(GROUPS))
    job.n_sites *= 12
    drawn_sites(job)
    solver(job)
    job.add("--symmetry", job.draw.choice(GROUPS[lattice]))
    if lattice:
        job.add("--lattice", lattice)
        job.leave_out("nc", "vti")
    job.has_lattice = job.is_sound


def inclusion_theme(job):
    draw = job.draw
    job.n_sites += draw.choice((0, 100, 250))
    drawn_sites(job)
    solver(job, ("lbfgs", "lloyd"))
    tags = ["fibre"]
    if job.often(0.5):
        job.add("--fibres", job.pick(("0.2,3", "0.4,5,0.01", "0.1,1"), ("0.9,9", "x", "0.3,0")))
    else:
        text, tags = inclusion_text(draw, job.unit, not job.is_sound)
        job.add("--inclusions", job.input("my shapes.txt", text))
    if job.often(0.5):
        job.add("--hole", job.pick(tags, ("nothing",)))
        job.leave_out("nc", "vti")
    job.has_phases = True


def fixed_theme(job):
    drawn_sites(job)
    solver(job, ("lbfgs", "lloyd"))
    job.add("--fixed", job.input("fixed.txt", fixed_text(job.draw, job.unit, not job.is_sound)))


def best_theme(job):
    job.add("--sites", min(job.n_sites, 12), "--start", "best", "--budget", job.draw.choice((1, 40, 200)))


PLANE_THEMES = (plain_theme,) * 3 + (density_theme, area_theme, area_theme, weight_theme, aspect_theme, wall_theme, wall_theme,
                                     symmetry_theme, inclusion_theme, inclusion_theme, fixed_theme, best_theme, centroid_theme)


def plane_meshes(job):
    """The meshes and their outline, and what belongs to grains."""
    draw = job.draw
    kinds = ("voronoi", "delaunay", "grains") if len(job.meshes) == 1 else job.meshes
    if job.often(0.65):
        job.meshes = draw.sample(kinds, min(len(kinds), draw.choice((1, 1, 1, 2, 3))))
        for kind in job.meshes:
            job.add("--mesh", kind)
    else:
        job.meshes = ["voronoi"]
    if "voronoi" in job.meshes:
        job.leave_out("msh", "inp")
    is_box = job.often(0.35) and not (job.is_sound and "delaunay" in job.meshes)
    if is_box:
        job.add("--outline", "box")
        job.leave_out(*(("foam",) if "voronoi" in job.meshes else ()))
    if "grains" in job.meshes:
        job.add(*job.pick(((), (), ("--per-edge", 2), ("--size", 0.1 * job.unit), ("--order", 2, "-o", "nodes.vtu")), (("--size", "0"),)))
    if job.often(0.2) and job.meshes != ["delaunay"]:
        job.add("--short-edges", job.pick((0.05, 0.2, 0.5), (0.7,)))
        job.leave_out("nc")
    if job.often(0.25) and job.origins == "xy":
        job.add("--repeat", job.pick(("2x1", "1x3", "2x2"), ("0x1", "10001x1", "20000x20000", "2")))
    if is_box and job.often(0.2) and job.origins == "xy":
        job.add("--origin", "auto")
    elif job.often(0.3) and (job.origins or not job.is_sound):
        far = job.unit * job.pick((0.3, -2.5, 9, 20, 1e3, 1e5), (1e6, 1e9, 1e13, 1e17))
        place = {"x": f"{far:.9g},0", "y": f"0,{far:.9g}"}
        job.add("--origin=" + place[draw.choice(job.origins or "xy")])


def plane_materials(job):
    if not (job.is_sound and job.has_phases) and job.often(0.2):
        job.add("--phases", job.pick(("a:0.5,b:0.5", "alpha:0.3,beta:0.7", "only:1"), ("a:0.5", "a b:1", "ä:1", "a:2,b:-1")))
    if job.often(0.15):
        word = job.draw.choice(("random", "angles.txt"))
        if word != "random":
            job.input(word, orientation_text(job.draw, job.n_sites, not job.is_sound))
        job.add("--orientations", word, *(("-o", "angles.csv") if job.is_sound else ()))


def file_choices(job, formats):
    """Options of the formats that the job writes."""
    options = {
        "--colour": (("obj", "ply", "glb", "svg"), COLOURS, ("none", "density", "phase", "orbit", "tag")),
        "--background": (("svg",), ("none", "#aabbcc"), ("red",)), "--glb-nodes": (("glb", "gltf"), ("one",), ("cells",)),
        "--pixels": (("png",), (1, 64, 333), ("-1",)), "--voxels": (("vti",), ("4,4", "16,8"), ("1,1",)),
        "--cut": (("dxf",), (50,), ("0",)), "--element": (("inp",), ("CPE", "CPS", *(() if "--order" in job.words else ("C3D6", "C3D15"))), ("C3D4",)),
        "--job": (("inp",), ("elastic",), ("plastic",)), "--thickness": (("foam",), (0.1 * job.unit,), ("1e-30",)),
        "--retry": (("nc",), (1, 5), ("-1",)), "--coriolis": (("nc",), ("1e-4", "0,2e-11"), ("x", "1,2,3"))}
    for option, (needed, good, bad) in options.items():
        if set(needed).intersection(formats) and job.often(0.25):
            job.add(option, job.pick(good, bad))
    if "ply" in formats and job.often(0.4):
        job.add("--float32")


def outputs(job):
    """Adds the outputs; tables and reports are outputs, too. Returns their extensions."""
    draw = job.draw
    stem = draw.choice(STEMS)
    chosen = draw.sample(job.formats, min(len(job.formats), draw.choice((1, 1, 2, 2, 3, 4))))
    for extension in chosen:
        job.add("-o", f"{stem}.{extension.upper() if job.often(0.03) else extension}")
    if not job.is_sound and job.often(0.1):
        job.add("-o", draw.choice(("t.xyz", "t", "new\nline.obj", "s.txt", "t.step", "/nowhere/t.obj", f"{stem}.{chosen[0]}")))
    if job.often(0.2):
        job.add("--report", job.pick((f"{stem}.json", "r.json"), ("r.txt",)))
    if job.often(0.1) and job.dimension == 2:
        job.add("--cells", job.pick(("cells.csv", f"{stem} cells.csv"), ("cells.txt",)))
    return set(chosen)


def plane_options(job):
    draw = job.draw
    draw.choice(PLANE_THEMES)(job)
    plane_lattice(job)
    plane_meshes(job)
    plane_materials(job)
    file_choices(job, outputs(job))


def space_volumes(job):
    """Cells of prescribed volumes, which have a solver of their own, and files that state weights."""
    draw = job.draw
    law = draw.choice(("equal", "lognormal:0.2", "lognormal:0.5", "gamma:0.4", "0.7*gamma:0.3@1+0.3*equal@2", None))
    if law is None:
        law = job.input("volumes.txt", area_text(draw, job.n_sites, not job.is_sound))
    job.add("--sites", job.n_sites, "--seed", draw.randrange(1000))
    job.add("--volumes", law, "--max-iterations", draw.choice((0, 1, 5)))
    job.leave_out("msh", "inp", "om")


def space_cells(job):
    any_sites(job)
    solver(job, ("lbfgs", "lloyd"))
    if job.often(0.2) and "--input" not in job.words:
        job.add("--start", job.pick(("random", "coarse", "lattice"), ("best",)))
    if job.often(0.15):
        # Tetrahedra inside of flat cells take minutes.
        is_small = job.n_sites <= 8 and job.is_round and "--input" not in job.words
        mesh = job.pick(("delaunay", "grains") if is_small else ("delaunay",), ("voronoi",))
        job.add("--mesh", mesh)
        if mesh == "grains" and job.often(0.5):
            job.add(*job.pick((("--order", "2", "-o", "nodes.vtu"), ("--job", "elastic", "--material", "same", "-o", "job.inp"))))
        job.leave_out("obj", "ply", "glb", "om", "svg", "png", *(("foam", "stl") if mesh == "delaunay" else ()))
    elif job.often(0.15):
        job.add("--short-edges", job.pick((0.02, 0.1), (0.3,)))
        job.leave_out("msh", "inp", "obj", "ply", "glb", "om")
    if job.often(0.1):
        job.add("--stability")


def space_options(job):
    draw = job.draw
    space_lattice(job)
    draw.choice((space_volumes, space_cells, space_cells, centroid_theme))(job)
    if job.often(0.15) and not {"--short-edges", "--centroids"}.intersection(job.words):
        job.add("--aspect", job.pick(("3", "0.2,1,1,0", "10,0.3,-1,2"), ("2,0,0,0", "1e9", "2,30")))
        job.leave_out("foam", "obj", "ply", "glb", "om")
    if job.often(0.15):
        job.add("--repeat", job.pick(("2x1x1", "1x2x2"), ("2x1", "0x1x1", "9999x9999x9999")))
    if job.often(0.2):
        job.add("--origin", job.pick(("0.3,-2,1", "1e3,0,-7"), ("0,0", "auto", "1e12,0,0")))
    elif job.often(0.1):
        job.add("--outline", "box", *draw.choice(((), ("--origin", "auto"))))
        job.leave_out("msh")
    if job.often(0.3):
        job.add("--phases", job.pick(("a:0.5,b:0.5", "a:0.2,b:0.3,c:0.5"), ("a:1.5", "a")), "--cells", "cells.csv")
        if job.often(0.5):
            word = draw.choice(("random", "angles.txt"))
            if word != "random":
                job.input(word, orientation_text(draw, 3 * job.n_sites, not job.is_sound))
            job.add("--orientations", word)
    chosen = outputs(job)
    if chosen.intersection(("obj", "ply", "glb", "svg", "png")) and job.often(0.3):
        job.add("--colour", job.pick(("faces", "size", "cells"), ("phase", "orientation", "sides", "red")))
    if chosen.intersection(("obj", "ply", "glb", "stl")) and job.often(0.5):
        job.add("--surface", job.pick(("cells", "boundary"), ("both",)))
    if "vti" in chosen and job.often(0.5):
        job.add("--voxels", job.pick(("4,6,8", "16,9,5"), ("4,4", "1,8,8")))


def pattern_options(job):
    (plane_lattice if job.dimension == 2 else space_lattice)(job)
    job.add("--sites", job.n_sites)
    job.leave_out("msh", "inp")
    outputs(job)


def random_job(draw, dimension):
    """Returns a Job."""
    job = JobDraw(draw, dimension)
    command = "pattern" if job.often(0.06) else "mesh"
    if command == "pattern":
        pattern_options(job)
    elif dimension == 2:
        plane_options(job)
    else:
        space_options(job)
    if not job.is_sound and job.often(0.4):
        job.add(*draw.choice(FOREIGN))
    if job.often(0.5):
        job.add("--quiet")
    job.add("--threads", draw.choice((1, 1, 2, 3)))
    return Job(command, job.words, job.inputs)
