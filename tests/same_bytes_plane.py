"""The jobs in the plane of tests/same_bytes; same_bytes_steps.py explains the steps."""

from pathlib import Path

from same_bytes_steps import File, damage_steps

MOON = Path(__file__).resolve().parent.parent / "samples/gallery/moon.png"


def scattered(n):
    """A site file of n scattered points of the unit square."""
    return "".join(f"{i * 0.6180339887 % 1:.9f} {i * i * 0.4142135623 % 1:.9f}\n"
                   for i in range(n))


CELLS = "--mesh voronoi --mesh delaunay --mesh grains"
OBLIQUE = "--lattice 1,0,0.37,0.81"
RIDGE = "'1 + 99 * exp(-((v - 0.5) / 0.1)^2)'"


def graphics_job(extension):
    """All meshes, both outlines, read back."""
    return [f"mesh --sites 30 --seed 7 {OBLIQUE} {CELLS} -o t{extension} --report r.json",
            f"mesh --sites 30 --outline box --mesh voronoi --mesh grains -o b{extension}",
            f"mesh --sites 3 -o few{extension}",
            f"check t-voronoi{extension} t-delaunay{extension} t-grains{extension}",
            f"check b-voronoi{extension} b-grains{extension} few{extension}",
            f"check t-voronoi{extension} t-delaunay{extension} --cvt 1e-4"]


def solver_job(extension):
    """Triangles with both orders of nodes, both outlines, read back."""
    return [f"mesh --sites 30 --seed 7 {OBLIQUE} --mesh delaunay --mesh grains -o t{extension}",
            f"mesh --sites 30 --seed 7 --mesh grains --order 2 -o second{extension}",
            f"mesh --sites 30 --seed 7 --mesh grains --outline box -o b{extension}",
            f"check t-delaunay{extension} t-grains{extension} second{extension} b{extension}",
            f"check t-delaunay{extension} --cvt"]


FORMATS = {
    **{f"format-{name}": graphics_job(f".{name}") for name in ["obj", "ply", "glb", "gltf", "om"]},
    **{f"format-{name}": solver_job(f".{name}") for name in ["msh", "inp"]},
    "format-vtu": graphics_job(".vtu") + ["mesh --sites 8 --mesh grains --order 2 -o second.vtu",
                                          "check second.vtu",
                                          "2: mesh --sites 8 --order 2 -o t.vtu"],
    "format-svg": [step if step.startswith("mesh") else f"2: {step}"
                   for step in graphics_job(".svg")],
    "format-vti": ["mesh --sites 100 --period 2,1 -o t.vti --report r.json", "check t.vti",
                   "mesh --sites 12 --voxels 20,30 --repeat 2x1 -o u.vti", "2: check t.vti --cvt",
                   "2: mesh --sites 100 --lattice 1,0,0.37,0.81 -o t2.vti"],
    "format-nc": ["mesh --sites 100 --period 2,1 -o t.nc --report r.json", "check t.nc",
                  "2: check t.nc --cvt",
                  "mesh --sites 150 --density '1 + u * (1 - u)' -o graded.nc",
                  "check graded.nc", "2: mesh --sites 100 --lattice 1,0,0.37,0.81 -o t2.nc"],
    "format-foam": [f"mesh --sites 30 --seed 7 {OBLIQUE} {CELLS} -o t.foam",
                    "check t-voronoi.foam t-delaunay.foam t-grains.foam",
                    "check t-voronoi.foam --cvt 1e-4", "2: mesh --sites 8 --outline box -o b.foam"],
    "format-txt": ["mesh --sites 30 --origin 3,4 -o t.txt", "mesh --input t.txt -o again.txt",
                   "mesh --input t.txt --max-iterations 0 -o same.txt", "2: check t.txt"],
    "report": [f"mesh --sites 30 {CELLS} -o t.obj -o t.svg -o t.txt --report r.json --quiet",
               "mesh --sites 8 --density 1+u --report density.json --quiet",
               "mesh --input t.txt --solver lloyd --report input.json"],
}

MESHES = {
    "grains-lengths": ["mesh --sites 12 --mesh grains --size 0.04 -o size.obj",
                       "mesh --sites 12 --mesh grains --per-edge 3 -o edge.obj --report r.json",
                       "2: mesh --sites 12 --mesh grains --per-edge 3 --size 0.1 -o both.obj"],
    "grains-order": [
        "mesh --sites 12 --mesh grains --per-edge 2 --order 2 -o t.msh -o t.vtu -o t.inp",
        "check t.msh t.vtu t.inp", "2: mesh --sites 12 --mesh grains --order 2 -o t.obj"],
    "outline-box": [f"mesh --sites 40 {OBLIQUE} --outline box --mesh grains -o grains.ply",
                    f"mesh --sites 40 {OBLIQUE} --outline box -o t.ply",
                    "mesh --sites 1 --outline box -o one.ply",
                    "2: mesh --sites 8 --outline box --mesh delaunay -o d.ply"],
    "origin": ["mesh --sites 30 --origin 0.3,-7.2 -o t.obj -o t.svg -o t.txt",
               "mesh --sites 30 --origin 0.3,-7.2 --outline box -o b.obj", "check t.obj b.obj"],
    "repeat": [f"mesh --sites 5 --repeat 2x3 {CELLS} -o t.glb -o t.svg -o t.obj -o t.om",
               "mesh --sites 2 --repeat 3x1 --outline box -o b.ply",
               "mesh --sites 30 --repeat 2x2 -o t.nc", "2: mesh --sites 5 --repeat 2x2 -o f.nc"],
    "short-edges": ["mesh --sites 60 --max-iterations 3 --short-edges 0.2 -o t.foam -o t.obj",
                    "check t.foam t.obj", "mesh --sites 60 --max-iterations 3 -o plain.obj"],
    "density-formula": [
        f"mesh --sites 200 --density {RIDGE} -o t.obj -o t.svg --report r.json",
        f"check t.obj --cvt --density {RIDGE}",
        "mesh --sites 60 --density 'u < 0.3 ? 1 : 20' --start coarse -o jump.obj --report j.json",
        f"mesh --sites 60 {OBLIQUE} --density '2 + sin(6.28 * u)' --mesh grains -o wave.msh"],
    "density-image": [
        File("moon.png", MOON.read_bytes()),
        "mesh --sites 100 --density moon.png --density-range 0.05,1 -o t.obj --report r.json",
        "mesh --sites 40 --density moon.png --period 2,1 --max-iterations 30 -o t.svg"],
}

RUNS = {
    "start-coarse": ["mesh --sites 300 --start coarse -o t.ply --report r.json"],
    "start-lattice": ["mesh --sites 56 --start lattice -o t.ply --report r.json",
                      f"mesh --sites 31 {OBLIQUE} --start lattice -o o.ply"],
    "start-best": ["mesh --sites 14 --start best --budget 20000 -o t.ply --report r.json",
                   f"mesh --sites 56 {OBLIQUE} --start best --budget 20000 -o o.ply",
                   "2: mesh --sites 14 --budget 100"],
    "solver-lloyd": ["mesh --sites 150 --solver lloyd -o t.om --report r.json"],
    "solver-newton": ["mesh --sites 150 --solver newton -o t.om --report r.json",
                      "mesh --sites 50 --solver newton --density '1 + u * v' -o d.om"],
    "stops": ["5: mesh --sites 30 --max-iterations 2 --strict -o t.obj --report limit.json",
              "5: mesh --sites 8 --tolerance 1e-17 --strict --report stalled.json",
              "mesh --sites 30 --max-iterations 0 -o raw.obj --report raw.json",
              "mesh --sites 30 --tolerance 1e-10 -o fine.obj"],
    "threads": [f"mesh --sites 1500 --threads {k} -o t{k}.glb -o t{k}.nc --report r{k}.json"
                for k in (1, 2)] + ["mesh --sites 1500 -o t.glb --report r.json"],
    "lattice-thin": ["mesh --sites 60 --period 20,1 -o t.obj -o t.vtu -o t.svg --report r.json",
                     "mesh --sites 3 --period 20,1 -o few.obj", "check t.obj few.obj"],
    "lattice-unreduced": ["mesh --sites 50 --lattice 1,0,7,1 -o t.obj -o t.foam -o t.svg",
                          "mesh --sites 7 --lattice 1,0,7,1 --outline box -o b.obj --report r.json",
                          "check t.obj t.foam b.obj"],
    "sites-few": [f"mesh --sites {n} {CELLS} -o n{n}.obj -o n{n}.glb --report n{n}.json"
                  for n in (1, 2, 3, 5, 8)],
    "sites-hundreds": [f"mesh --sites {n} {CELLS} -o n{n}.ply --report n{n}.json"
                       for n in (150, 400)],
    "sites-2000": ["mesh --sites 2000 -o t.obj -o t.foam -o t.om -o t.vtu --report r.json",
                   "check t.obj t.foam t.om t.vtu"],
    "input-text": [File("notes.txt", "# title\n\n" + scattered(20).replace("\n", " # note\n", 9)),
                   File("crlf.txt", scattered(20).replace("\n", "\r\n")),
                   "mesh --input notes.txt -o notes.obj", "mesh --input crlf.txt -o crlf.obj",
                   File("words.txt", "0.1 0.2\n0.3 word\n"), "2: mesh --input words.txt -o t.obj",
                   File("empty.txt"), "2: mesh --input empty.txt", "2: mesh --input none.txt"],
    "input-duplicates": [File("same.txt", "0.1 0.2\n0.5 0.5\n0.1 0.2\n"),
                         "2: mesh --input same.txt",
                         File("wrapped.txt", "0.1 0.2\n0.5 0.5\n3.1 -1.8\n"),
                         "2: mesh --input wrapped.txt",
                         File("near.txt", "0.1 0.2\n0.5 0.5\n0.1 0.20000000001\n"),
                         "?: mesh --input near.txt"],
    "input-seam": [File("seam.txt", "0 0\n0.5 0\n0 0.5\n0.25 1\n1 0.75\n0.6 0.4\n"),
                   f"mesh --input seam.txt --max-iterations 0 {CELLS} -o raw.obj -o raw.txt",
                   f"mesh --input seam.txt {OBLIQUE} -o t.obj --report r.json",
                   File("grid.txt", "".join(f"{k % 8 / 8} {k // 8 / 8}\n" for k in range(64))),
                   f"mesh --input grid.txt --max-iterations 0 {CELLS} -o grid.obj -o grid.glb",
                   "check raw-voronoi.obj grid-voronoi.obj grid-delaunay.glb"],
    "input-stdin": [File("sites.txt", scattered(40)), "mesh --input - -o t.obj < sites.txt",
                    "2: mesh --input - -o empty.obj"],
    "pattern": ["pattern --sites 56 -o t.svg -o t.obj --report r.json", "pattern --sites 10",
                f"pattern --sites 30 {OBLIQUE} --mesh delaunay -o d.obj", "2: pattern --sites 0",
                "pattern --sites 12 --mesh grains --outline box --origin 0.1,0.2 -o g.inp"],
}

SHAPES = "circle a 0.5 0.5 0.2\nellipse b 0.02 0.1 0.12 0.08 30\npolygon c 0.8 0.7 0.95 0.7 0.9 0.9\n"
CONSTRAINTS = {
    "cells-areas": ["mesh --sites 40 --areas lognormal:0.4 --max-iterations 5 --mesh grains -o t.msh --cells t.csv "
                    "--report r.json", "check t.msh", File("areas.txt", "1\n2\n3\n4\n"),
                    "mesh --sites 4 --areas areas.txt -o few.obj", "check few.obj --areas areas.txt",
                    "mesh --sites 30 --aspect 2,30 -o long.vtu --report a.json", "check long.vtu",
                    "2: mesh --sites 5 --areas areas.txt", "2: mesh --sites 5 --areas normal:1",
                    "2: mesh --sites 5 --aspect 0"],
    "cells-materials": ["2: mesh --sites 30 --mesh grains --phases soft:0.7,hard:0.3 --job elastic -o job.inp",
                        "mesh --sites 30 --mesh grains --phases soft:0.7,hard:0.3 --job elastic --material soft:70,0.33 "
                        "--material hard:200,120,80 -o job.inp --report r.json",
                        "mesh --sites 9 --material same --phases a:0.5,b:0.5 --voxels 20,20,3 -o layers.vti",
                        "mesh --sites 30 --orientations random --phases a:0.5,b:0.5 -o t.vti -o t.svg "
                        "--colour phase --cells t.csv",
                        "check job.inp t.vti", "2: mesh --sites 5 --phases a:0.5", "2: mesh --sites 5 --phases a"],
    "cells-symmetry": ["mesh --sites 24 --symmetry p4m -o t.obj -o t.svg --cells t.csv --report r.json",
                       "mesh --sites 12 --symmetry p6m -o h.vtu", "check t.obj h.vtu",
                       "2: mesh --sites 5 --symmetry p5", f"2: mesh --sites 5 --symmetry p4 {OBLIQUE}"],
    "cells-walls": ["mesh --sites 30 --walls y --period 2,1 -o t.obj -o t.foam -o t.vtu --report r.json",
                    "mesh --sites 20 --walls xy --wall-cells half --mesh delaunay -o h.msh",
                    "check t.obj t.foam t.vtu h.msh",
                    "2: mesh --sites 5 --walls z", "2: mesh --sites 5 --walls x -o t.nc"],
    "cells-inclusions": [File("shapes.txt", SHAPES),
                         "mesh --sites 150 --inclusions shapes.txt -o t.obj -o t.vtu --report r.json",
                         "check t.obj t.vtu --inclusions shapes.txt",
                         "mesh --sites 150 --inclusions shapes.txt --hole a -o h.foam -o h.obj --report h.json",
                         "mesh --sites 200 --fibres 0.2,3 --seed 4 -o f.vtu -o f.svg --report f.json",
                         "check h.foam h.obj f.vtu",
                         File("bad.txt", "circle a 0.5 0.5 0.8\nsquare b 1\n"),
                         "2: mesh --sites 9 --inclusions bad.txt",
                         "2: mesh --sites 9 --hole a", "2: mesh --sites 9 --fibres 2,2"],
    "pictures": [f"mesh --sites 30 --seed 7 {OBLIQUE} {CELLS} -o t.html -o t.png -o t.dxf -o t.csv",
                 "mesh --sites 30 --pixels 64 -o p.png", "mesh --sites 30 --cut 100 -o c.svg -o c.dxf",
                 "mesh --sites 30 --colour size --background '#ffffff' -o s.svg",
                 "2: mesh --sites 9 --colour red -o t.svg"],
}

STUDIES = {
    "study-table1": ["study table1 --sites 3,30 --runs 3 -o t.csv"],
    **{f"study-{name}": [f"study {name} --sites 10,30 --runs 2 -o t.csv -o t.svg"]
       for name in ("fig8", "fig9", "fig10", "fig11")},
    "study-fig7": ["study fig7 --sites 10,100 --runs 2 -o t.csv -o t.svg",
                   "study fig7 --shard 1/2 --sites 10 --runs 2 -o part.csv"],
    "study-shards": [f"study fig11 --sites 8,9,12 --runs 30 --seed 7 --shard {k}/3 -o p{k}.csv"
                     for k in (1, 2, 3)] + [
        File("merged/"), "study fig11 --merge p3.csv p1.csv p2.csv -o merged/",
        "study fig11 --sites 8,9,12 --runs 30 --seed 7 -o whole.csv --threads 1",
        "2: study fig11 --merge p1.csv p3.csv", "2: study table1 --merge p1.csv",
        "2: study fig11 --sites 8 --shard 4/3 -o p4.csv"],
}


TRIANGLES = "--mesh delaunay"
DAMAGES = {
    **{f"damaged-{name}": damage_steps(f".{name}") for name in ("obj", "ply", "om", "vtu", "foam")},
    **{f"damaged-{name}": damage_steps(f".{name}", TRIANGLES) for name in ("msh", "inp")},
    "damaged-nc": damage_steps(".nc", "--seed 3"),
    "damaged-gltf": damage_steps(".gltf") + damage_steps(".glb"),
    "check-lattice": ["mesh --sites 30 --mesh voronoi --mesh delaunay -o t.ply",
                      "2: check t-voronoi.ply --period 2,1", "check t-delaunay.ply --period 1,1",
                      "mesh --sites 30 --max-iterations 1 -o raw.obj", "2: check raw.obj --cvt",
                      File("plain.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n"),
                      "2: check plain.obj", "check plain.obj --period 1,1",
                      "2: check plain.obj --period 2,1", "2: check none.obj"],
}

ERRORS = {
    "help": ["--help", "mesh --help", "pattern --help", "study --help", "check --help",
             "--version"],
    "errors-commands": ["2: nothing", "2: mesh", "2: mesh --bogus", "2: check",
                        "2: study nothing", "2: mesh --sites 3 --input a.txt",
                        "2: mesh --sites 3 --budget 9",
                        "2: mesh --sites 3 --density-range 1,2", "2: check a.svg", "2: study"],
    "errors-values": [f"2: mesh --sites {n}" for n in ("0", "-1", "x", "1e3")] + [
        "4: mesh --sites 268435457"] + [
        f"2: mesh --sites 8 {option}" for option in (
            "--sites 9", "--seed x", "--lattice 1,0", "--lattice 1,0,2,0", "--lattice",
            "--period 0,1", "--period 1,nan", "--period 1,1 --lattice 1,0,0,1", "--origin 1",
            "--mesh cube", "--order 3", "--outline round", "--repeat 0x1", "--repeat 2",
            "--size -1", "--per-edge 0", "--threads 0", "--short-edges 9", "--tolerance -1",
            "--max-iterations -1", "--start nowhere", "--solver magic")],
    "errors-density": [File("text.png", "no picture")] + [
        f"2: mesh --sites 8 --density {density}" for density in (
            "'u +'", "w", "0", "-1", "u-0.5", "1/0", "text.png", "none.png", "''",
            "1 --density-range 1,2", "text.png --density-range 2,1")],
    "errors-outputs": ["mesh --sites 8 -o t.obj", "3: mesh --sites 8 -o t.obj",
                       "mesh --sites 9 -o t.obj --force", "2: mesh --sites 8 -o t.xyz",
                       "2: mesh --sites 8 -o t", "2: mesh --sites 8 -o a.ply -o a.ply",
                       "3: mesh --sites 8 -o /dev/null/t.obj", File("file"),
                       "3: mesh --sites 8 -o file/t.obj",
                       "2: mesh --sites 8 -o t.msh", File("full.foam/"), File("full.foam/note"),
                       "3: mesh --sites 8 -o full.foam",
                       "?: mesh --sites 8 -o full.foam --force",
                       "3: mesh --sites 8 -o u.ply --report /dev/null/r.json",
                       "3: study table1 --sites 3 --runs 1 -o /dev/null/t.csv"],
}

PLANE = {**FORMATS, **MESHES, **RUNS, **CONSTRAINTS, **STUDIES, **DAMAGES, **ERRORS}
