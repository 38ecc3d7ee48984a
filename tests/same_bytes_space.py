"""The jobs in space of tests/same_bytes; same_bytes_steps.py explains the steps."""

from same_bytes_steps import File, damage_steps

CUBE = "--period 1,1,1"
OBLIQUE = "--lattice 1,0,0,0.37,0.81,0,0.2,0.4,0.9"
LATTICES = {
    "cube": CUBE,
    "box": "--period 1,2,0.5",
    "fcc": "--lattice 0,1,1,1,0,1,1,1,0",
    "bcc": "--lattice -1,1,1,1,-1,1,1,1,-1",
    "hexagonal": "--lattice 1,0,0,0.5,0.8660254037844386,0,0,0,1.6",
    "oblique": OBLIQUE,
    "left-handed": "--lattice 1,0,0,0,0,1.1,0.3,0.8,0",
    "thin": "--period 1,0.05,0.3",
    "huge": "--period 1e6,2e6,1e6",
    "unreduced": "--lattice 1,0,0,7,1,0,-3,5,1",
}


def scattered(n):
    """A site file of n scattered points of the unit cube."""
    return "".join(f"{i * 0.6180339887 % 1:.9f} {i * i * 0.4142135623 % 1:.9f} "
                   f"{i * i * i * 0.7320508076 % 1:.9f}\n" for i in range(n))


def cells_job(extension):
    """Cells on two lattices, few cells, and the questions of pcvt check about them."""
    return [f"mesh --sites 20 --seed 7 {OBLIQUE} -o t{extension} --report r.json",
            f"mesh --sites 9 {CUBE} -o c{extension}",
            f"mesh --sites 1 {CUBE} -o one{extension}", f"mesh --sites 2 {OBLIQUE} -o two{extension}",
            f"check t{extension} c{extension} one{extension} two{extension}",
            f"check t{extension} --cvt 1e-4", f"2: check t{extension} --cvt 1e-12",
            f"2: check t{extension} --period 1,1", f"2: check t{extension} --cvt 1e-3 --density 1"]


def surface_job(extension):
    """The same, and the boundary."""
    return cells_job(extension) + [
        f"mesh --sites 20 --seed 7 {OBLIQUE} --surface boundary -o b{extension} --report b.json",
        f"mesh --sites 12 {CUBE} --surface boundary -o d{extension}",
        f"check b{extension} d{extension}", f"2: check b{extension} --cvt"]


def picture_job(extension):
    return [f"mesh --sites 20 --seed 7 {OBLIQUE} -o t{extension} --report r.json",
            f"mesh --sites 3 {CUBE} -o few{extension}",
            f"mesh --sites 30 --period 1,2,0.5 --seed 2 -o box{extension}",
            f"pattern --sites 16 {CUBE} -o p{extension}", f"2: check t{extension}"]


FORMATS = {
    **{f"space-{name}": cells_job(f".{name}") for name in ("vtu", "foam")},
    **{f"space-{name}": surface_job(f".{name}") for name in ("obj", "ply")},
    "space-glb": [step.replace("check t.glb --cvt 1e-4", "2: check t.glb --cvt 1e-4")
                  for step in surface_job(".glb")],
    "space-msh": [f"mesh --sites 20 --seed 7 {OBLIQUE} -o t.msh --report r.json",
                  f"mesh --sites 9 {CUBE} -o c.msh", f"mesh --sites 20 {CUBE} --mesh delaunay -o d.msh",
                  "check t.msh c.msh d.msh", "2: check t.msh --cvt 1e-3",
                  f"mesh --sites 1 {CUBE} -o one.msh", f"mesh --sites 2 {OBLIQUE} -o two.msh"],
    "space-om": [f"mesh --sites 20 --seed 7 {OBLIQUE} -o t.om --report r.json",
                 f"mesh --sites 12 {CUBE} -o c.om", "check t.om c.om", "2: check t.om --cvt",
                 f"mesh --sites 1 {CUBE} -o one.om", f"mesh --sites 2 {OBLIQUE} -o two.om"],
    **{f"space-{name}": picture_job(f".{name}") for name in ("svg", "png")},
    "space-txt": [f"mesh --sites 20 {OBLIQUE} -o t.txt", f"mesh --input t.txt {OBLIQUE} -o again.txt",
                  f"mesh --input t.txt {OBLIQUE} --max-iterations 0 -o same.txt -o same.vtu",
                  "check same.vtu --cvt 1e-5", "2: check t.txt"],
    "space-tetrahedra": [
        f"mesh --sites 20 --seed 7 {OBLIQUE} --mesh delaunay -o t.vtu -o t.msh --report r.json",
        f"mesh --sites 12 {CUBE} --mesh delaunay -o c.vtu", "check t.vtu t.msh c.vtu",
        "2: check t.vtu --cvt 1e-3", f"mesh --sites 1 {CUBE} --mesh delaunay -o one.vtu",
        f"2: mesh --sites 38 {CUBE} --start lattice -o flat.vtu -o flat.msh"],
    "space-all-formats": [
        f"mesh --sites 24 --seed 3 {CUBE} --report r.json "
        + " ".join(f"-o t.{name}" for name in "vtu foam msh obj ply glb om svg png txt".split()),
        "check t.vtu t.foam t.msh t.obj t.ply t.glb t.om", "check t.foam/", "2: check t.foam/t.foam"],
    "space-report": [f"mesh --sites 30 {OBLIQUE} -o t.vtu -o t.txt --report r.json --quiet",
                     f"mesh --sites 12 {CUBE} --report none.json --solver lloyd --quiet",
                     f"mesh --input t.txt {OBLIQUE} --report input.json --stability",
                     f"pattern --sites 8 {OBLIQUE} --report pattern.json",
                     f"2: mesh --sites 8 {CUBE} --report r.txt"],
}

DAMAGES = {
    **{f"space-damaged-{name}": damage_steps(f".{name}", CUBE) for name in ("vtu", "foam", "obj", "ply")},
    **{f"space-damaged-{name}": damage_steps(f".{name}", CUBE) for name in ("msh", "glb", "om")},
    "space-damaged-tetrahedra": damage_steps(".vtu", f"{OBLIQUE} --mesh delaunay"),
    "space-damaged-boundary": damage_steps(".ply", f"{OBLIQUE} --surface boundary"),
    "space-damaged-short-edges": damage_steps(".vtu", f"{OBLIQUE} --short-edges 0.05 --max-iterations 2"),
}


def lattice_job(lattice):
    """Few and more sites, read back."""
    return [f"mesh --sites 14 --seed 5 {lattice} -o t.vtu -o t.foam -o t.obj -o t.txt --report r.json",
            f"mesh --sites 14 --seed 5 {lattice} -o t.msh -o t.glb -o t.om -o t.svg",
            f"mesh --sites 3 {lattice} -o few.vtu -o few.ply --report few.json",
            f"mesh --sites 6 {lattice} --start lattice -o l.vtu --report l.json",
            "check t.vtu t.foam t.obj few.vtu few.ply", "check t.msh t.glb t.om l.vtu"]


RUNS = {
    **{f"space-lattice-{name}": lattice_job(lattice) for name, lattice in LATTICES.items()},
    "space-start-random": [f"mesh --sites 40 {CUBE} --start random --seed {k} -o t{k}.vtu --report r{k}.json"
                           for k in (0, 1, 18446744073709551615)],
    "space-start-coarse": [f"mesh --sites 150 {OBLIQUE} --start coarse -o t.vtu --report r.json",
                           f"mesh --sites 1000 {CUBE} --max-iterations 2 --tolerance 1e-3 -o t.txt "
                           "--report d.json"],
    "space-start-lattice": [f"mesh --sites 16 {CUBE} --start lattice -o t.vtu --report r.json",
                            f"mesh --sites 31 {OBLIQUE} --start lattice -o o.vtu --report o.json",
                            "check t.vtu o.vtu --cvt"],
    "space-solver-lloyd": [f"mesh --sites 30 {CUBE} --solver lloyd --tolerance 1e-4 -o t.vtu --report r.json"],
    "space-stops": [f"5: mesh --sites 30 {CUBE} --max-iterations 2 --strict -o t.vtu --report limit.json",
                    f"5: mesh --sites 8 {CUBE} --tolerance 1e-17 --strict --report stalled.json",
                    f"mesh --sites 30 {CUBE} --max-iterations 0 -o raw.obj -o raw.txt --report raw.json",
                    f"mesh --sites 30 {CUBE} --tolerance 1e-10 -o fine.vtu", "check fine.vtu --cvt 1e-9",
                    f"mesh --sites 30 {CUBE} --tolerance 0.1 -o loose.vtu --report loose.json"],
    "space-short-edges": [
        f"mesh --sites 60 {CUBE} --max-iterations 0 --short-edges 0.02 -o t.vtu -o t.foam --report r.json",
        f"mesh --sites 40 {OBLIQUE} --short-edges 0.1 -o s.vtu -o s.svg -o s.txt --report s.json",
        "check t.vtu t.foam s.vtu", f"mesh --sites 20 {CUBE} --short-edges 1e-6 -o none.vtu"]
        + [f"2: mesh --sites 8 {CUBE} --short-edges 0.01 -o t.{name}" for name in "obj ply glb om msh".split()]
        + [f"2: mesh --sites 8 {CUBE} --short-edges {length}" for length in ("0.11", "-1", "0", "x")],
    "space-threads": [f"mesh --sites 600 {CUBE} --max-iterations 8 --threads {k} -o t{k}.vtu --report r{k}.json"
                      for k in (1, 2, 3)],
    "space-sites-few": [f"mesh --sites {n} {OBLIQUE} --seed {n} -o n{n}.vtu -o n{n}.obj --report n{n}.json"
                        for n in range(1, 9)]
        + ["check " + " ".join(f"n{n}.vtu n{n}.obj" for n in range(1, 9))],
    "space-sites-hundreds": [f"mesh --sites 300 {CUBE} --tolerance 1e-4 -o t.vtu -o t.foam -o t.msh --report r.json",
                             "check t.vtu t.foam --cvt 1e-3", "check t.msh"],
    "space-stability": [f"mesh --sites 20 {CUBE} --stability --report r.json",
                        f"mesh --sites 16 {CUBE} --start lattice --stability --report l.json",
                        File("cubes.txt", "".join(f"{k // 4 / 2} {k // 2 % 2 / 2} {k % 2 / 2}\n" for k in range(8))),
                        f"mesh --input cubes.txt {CUBE} --stability --report saddle.json",
                        f"mesh --sites 20 {CUBE} --stability --max-iterations 3",
                        f"2: mesh --sites 2001 {CUBE} --stability"],
    "space-input-text": [File("notes.txt", "# title\n\n" + scattered(12).replace("\n", " # note\n", 9)),
                         File("crlf.txt", scattered(12).replace("\n", "\r\n")),
                         f"mesh --input notes.txt {CUBE} -o notes.vtu", f"mesh --input crlf.txt {CUBE} -o crlf.vtu",
                         File("words.txt", "0.1 0.2 0.3\n0.3 word 0.1\n"), f"2: mesh --input words.txt {CUBE}",
                         File("flat.txt", "0.1 0.2\n"), f"2: mesh --input flat.txt {CUBE}",
                         File("four.txt", "0.1 0.2 0.3 0.4\n"), f"2: mesh --input four.txt {CUBE}",
                         File("nan.txt", "0.1 0.2 nan\n"), f"2: mesh --input nan.txt {CUBE}",
                         File("empty.txt"), f"2: mesh --input empty.txt {CUBE}", f"2: mesh --input none.txt {CUBE}",
                         "2: mesh --input notes.txt", f"2: mesh --input notes.txt {CUBE} --seed 1",
                         f"2: mesh --input notes.txt {CUBE} --start random",
                         f"2: mesh --input notes.txt {CUBE} --sites 3"],
    "space-input-duplicates": [File("same.txt", "0.1 0.2 0.3\n0.5 0.5 0.5\n0.1 0.2 0.3\n"),
                               f"2: mesh --input same.txt {CUBE}",
                               File("wrapped.txt", "0.1 0.2 0.3\n0.5 0.5 0.5\n3.1 -1.8 1.3\n"),
                               f"2: mesh --input wrapped.txt {CUBE}",
                               File("near.txt", "0.1 0.2 0.3\n0.5 0.5 0.5\n0.1 0.2 0.30000000001\n"),
                               f"2: mesh --input near.txt {CUBE} --max-iterations 0 -o t.vtu",
                               f"mesh --input near.txt {CUBE} --duplicates drop --max-iterations 0 -o t.vtu --report r.json"],
    "space-input-seam": [File("seam.txt", "0 0 0\n0.5 0 0\n0 0.5 0\n0 0 0.5\n0.25 0.25 0\n1 0.25 0.75\n"),
                         f"mesh --input seam.txt {CUBE} --max-iterations 0 -o raw.vtu -o raw.foam -o raw.txt",
                         f"mesh --input seam.txt {OBLIQUE} -o t.vtu -o t.obj --report r.json",
                         File("grid.txt", "".join(f"{k % 3 / 3} {k // 3 % 3 / 3} {k // 9 / 3}\n" for k in range(27))),
                         f"mesh --input grid.txt {CUBE} --max-iterations 0 -o grid.vtu -o grid.obj -o grid.ply",
                         f"mesh --input grid.txt {CUBE} --max-iterations 0 -o grid.msh",
                         "check raw.vtu raw.foam t.vtu t.obj grid.vtu grid.obj grid.ply"],
    "space-input-stdin": [File("sites.txt", scattered(20)), f"mesh --input - {CUBE} -o t.vtu < sites.txt",
                          f"2: mesh --input - {CUBE} -o empty.vtu"],
    "space-combined": [f"mesh --sites 25 --seed 11 {OBLIQUE} --solver lloyd --max-iterations 5 --short-edges 0.05 "
                       "--threads 2 -o t.vtu -o t.foam -o t.png -o t.txt --report r.json --stability",
                       f"5: mesh --input t.txt {OBLIQUE} --max-iterations 1 --tolerance 1e-9 --strict "
                       "--surface boundary -o b.obj -o b.ply -o b.glb -o b.om -o b.svg --report b.json",
                       "check t.vtu t.foam b.obj b.ply b.glb b.om",
                       f"pattern --sites 16 {CUBE} --surface boundary -o p.obj -o p.vtu --report p.json --force"],
}

STUDIES = {
    "space-pattern": [f"pattern --sites 16 {CUBE} -o t.vtu -o t.foam -o t.svg --report r.json",
                      f"pattern --sites 10 {OBLIQUE}", "pattern --sites 5 --lattice 0,1,1,1,0,1,1,1,0 -o f.obj",
                      f"pattern --sites 5 {OBLIQUE} --mesh delaunay -o d.vtu", f"2: pattern --sites 0 {CUBE}",
                      f"2: pattern --sites 8 {CUBE} --seed 3", f"2: pattern --sites 8 {CUBE} --repeat 2x1",
                      "check t.vtu t.foam f.obj --cvt"],
    "space-study": ["study gersho3d --sites 1,2,4,5 --runs 3 -o t.csv -o t.svg", "study gersho3d --sites 3 --runs 1",
                    "study gersho3d --sites 3 --runs 1 -o page.html", "2: study gersho3d --sites 0 --runs 1"],
    "space-study-shards": [f"study gersho3d --sites 2,3,4 --runs 4 --seed 7 --shard {k}/2 -o p{k}.csv" for k in (1, 2)]
        + [File("merged/"), "study gersho3d --merge p2.csv p1.csv -o merged/",
           "study gersho3d --sites 2,3,4 --runs 4 --seed 7 -o whole.csv --threads 1",
           "2: study gersho3d --merge p1.csv", "2: study fig11 --merge p1.csv p2.csv"],
}

# Each option of the plane with a value that the plane accepts.
PLANE_OPTIONS = (
    "--density 1", "--density-range 0.1,1", "--symmetry p4",
    "--areas lognormal:0.3", "--areas equal", "--walls x", "--wall-cells half",
    "--budget 5", "--float32",
    "--inclusions s.txt", "--fibres 0.2,3", "--hole fibre", "--fixed f.txt", "--retry 3", "--per-edge 2",
    "--order 2", "--glb-nodes one", "--pixels 64", "--cut 100", "--background none", "--element CPS",
    "--thickness 0.1")
ERRORS = {
    "space-errors-options": [f"2: mesh --sites 8 {CUBE} {option}" for option in PLANE_OPTIONS],
    "space-errors-choices": [f"2: mesh --sites 8 {CUBE} {option}" for option in (
        "--start best", "--start nowhere", "--solver newton", "--solver magic",
        "--mesh cube -o t.vtu", "--mesh voronoi --mesh delaunay -o t.vtu", "--mesh delaunay -o t.vtu -o t.foam",
        "--mesh delaunay -o t.obj", "--mesh voronoi -o t.msh", "--surface cells", "--surface cells -o t.vtu",
        "--surface boundry -o t.obj")] + ["2: mesh --sites 8 -o t.obj --surface cells"],
    "space-errors-values": [f"2: mesh --sites {n} {CUBE}" for n in ("0", "-1", "x", "1e3", "''")] + [
        f"4: mesh --sites {10**9} {CUBE}", f"4: mesh --sites 67108865 {CUBE}", f"2: mesh {CUBE}"] + [
        f"4: mesh --sites 8 {CUBE} --threads 2000"] + [
        f"2: mesh --sites 8 {CUBE} {option}" for option in (
            "--sites 9", "--seed x", "--threads 0", "--tolerance 0", "--tolerance x",
            "--max-iterations -1", OBLIQUE, "--bogus", "--input a.txt")] + [
        f"2: mesh --sites 8 {option}" for option in (
            "--period 1,1,0", "--period 1,x,1", "--period 1,1,nan", "--period 1,1,1,1", "--period 1,-1,1",
            "--lattice 1,0,0,0,1,0,1,1,0", "--lattice 1,0,0,0,1,0,0,0,inf", "--lattice 1,0,0,0,1,0",
            "--lattice 1,0,0,0,1,0,0,0,x", "--period 1e200,1e200,1e200", "--period 1,1e-12,1")],
    "space-errors-formats": [f"2: mesh --sites 8 {CUBE} -o t.{name}" for name in
                             "nc gltf html dxf xyz".split()] + [f"2: mesh --sites 8 {CUBE} -o t"],
    "space-errors-outputs": [
        f"mesh --sites 8 {CUBE} -o t.vtu -o t.foam", f"3: mesh --sites 8 {CUBE} -o t.vtu -o t.foam",
        f"mesh --sites 9 {CUBE} -o t.vtu -o t.foam --force", f"2: mesh --sites 8 {CUBE} -o a.ply -o ./a.ply",
        f"3: mesh --sites 8 {CUBE} -o /dev/null/t.vtu", File("file"), f"3: mesh --sites 8 {CUBE} -o file/t.obj",
        f"mesh --sites 8 {CUBE} -o new/folder/t.vtu", File("full.foam/"), File("full.foam/note"),
        f"3: mesh --sites 8 {CUBE} -o full.foam", f"mesh --sites 8 {CUBE} -o full.foam --force",
        f"3: mesh --sites 8 {CUBE} -o u.ply --report /dev/null/r.json",
        f"2: mesh --sites 38 {CUBE} --start lattice -o both.vtu -o both.msh"],
    "space-errors-check": [
        f"mesh --sites 8 {OBLIQUE} --tolerance 1e-3 -o t.vtu -o t.obj -o t.foam", "mesh --sites 8 -o plane.vtu",
        "2: check t.vtu --lattice 1,0,0,1", "2: check t.vtu --period 1,1,1", "2: check plane.vtu --period 1,1,1",
        File("a.txt", "1\n"), "2: check t.vtu --areas a.txt", "2: check t.vtu --inclusions a.txt",
        "2: check none.vtu t.vtu",
        "2: check t.vtu plane.vtu --cvt", File("plain.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n"),
        "2: check plain.obj", File("text.vtu", "no mesh\n"), "2: check text.vtu", File("empty.foam/"),
        "2: check empty.foam", "2: check t.png"],
    "help-topics": ["help", "help density", "help formats", "2: help space", "2: help nothing", "2: check --version"],
}

SPACE = {**FORMATS, **DAMAGES, **RUNS, **STUDIES, **ERRORS}
