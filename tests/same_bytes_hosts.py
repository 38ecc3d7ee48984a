"""The jobs of tests/same_bytes that call the C library and the Python package of a build.

same_bytes_host.c and same_bytes_shown.py explain the words of the programs.
"""

from same_bytes_steps import Host, Python

OBLIQUE = "lattice=1,0,0.37,0.81"
SPACE = "dimension=3"
OBLIQUE3 = f"{SPACE} lattice3=1,0,0,0.37,0.81,0,0.2,0.4,0.9"
SITES = "0.1,0.2,0.6,0.5,0.3,0.8,0.9,0.7"
SITES3 = "0.1,0.2,0.3,5.5,-0.25,0.5,0.75,2.25,-1.5"
SHAPES = "'inclusions=circle a 0.5 0.5 0.2\nellipse b 0.02 0.1 0.12 0.08 30'"


def alone(options, fields, call="generate"):
    """One host that makes a call with each of the fields alone, after its options."""
    return Host(" ".join(f"reset {options} {field} {call}" for field in fields))


def writes(names, options=""):
    """Words of a host that write a file of each extension, NAME or NAME:CHOICES."""
    words = []
    for number, name in enumerate(names):
        extension, _, choices = name.partition(":")
        words.append(f"reset {options} {choices} write t{number}.{extension}")
    return " ".join(words)


PLANE_C = {
    "c-plane-views": [Host(f"n_sites=7 seed=3 {OBLIQUE} generate views"),
                      Host("n_sites=2 origin=0.3,-7.2 columns=2 rows=1 lattice=2,0,0,1 generate views"),
                      Host(f"sites={SITES} n_sites=4 max_iterations=0 generate views")],
    "c-plane-formats": [Host(f"n_sites=20 seed=7 {OBLIQUE} generate " + writes([
        "obj", "obj:write.kind=1", "ply:write.single_precision=1", "ply:write.outline=1", "glb:write.gltf_nodes=2",
        "gltf:write.kind=2", "om:write.kind=1", "msh:write.kind=2", "inp:write.kind=2 write.element=1 write.job=1",
        "vtu", "foam:write.thickness=0.5", "svg:write.background=#ffffff", "svg:write.cut_width=100", "dxf",
        "png:write.pixels=64", "html", "csv", "txt", "obj:write.colour=2 write.report=r.json"]))]
        + [Host("n_sites=100 lattice=2,0,0,1 generate write t.nc write.voxels=24,12 write t.vti"),
           "check t0.obj t1.obj t2.ply t3.ply t4.glb t5.gltf t6.om t7.msh t8.inp t9.vtu t10.foam t18.obj",
           "check t.nc t.vti"],
    "c-plane-cells": [
        Host("n_sites=12 area_law=lognormal:0.4 max_iterations=5 phases=soft:0.7,hard:0.3 random_orientations=1 "
             "generate views write t.csv write.kind=2 write t.msh"),
        Host("n_sites=4 areas=1,2,3,4 n_areas=4 generate views write t.vtu"),
        Host("n_sites=12 aspect=2 aspect_degrees=30 short_edges=0.1 generate views"),
        Host("n_sites=12 symmetry=11 generate views"),
        Host(f"n_sites=9 fixed_sites=0.1,0.1,0.6,0.5 n_fixed_sites=2 grain_order=2 grain_per_edge=2 generate views"),
        Host("n_sites=3 orientations=1,2,3,4,5,6,7,8,9 n_orientations=3 grain_size=0.2 find_origin=1 generate views")],
    "c-plane-walls": [Host("n_sites=10 walls=2 lattice=2,0,0,1 generate views write w.obj write w.foam"),
                      Host("n_sites=10 walls=3 wall_cells=1 generate views write.kind=1 write w.vtu"),
                      Host(f"n_sites=150 {SHAPES} generate write t.obj write t.vtu write t.csv "
                           "reset write.kind=2 write t.msh"),
                      Host(f"n_sites=150 {SHAPES} holes=a generate write h.foam write h.obj"),
                      Host("n_sites=200 fibres=0.2,3 seed=4 generate write f.vtu write f.svg"),
                      "check w.obj w.foam w.vtu t.obj t.vtu t.msh h.foam h.obj f.vtu"],
    "c-plane-runs": [Host("n_sites=16 density=wave generate views write t.obj"),
                     Host("n_sites=16 'density_source=1 + u * (1 - u)' solver=3 generate views"),
                     Host("n_sites=16 density=nan generate density=fail generate reset n_sites=16 "
                          "'density_source=u +' generate"),
                     alone("n_sites=14", [f"start={k}" for k in (1, 2, 3)] + ["start=4 budget=5000"],
                           "generate views"),
                     alone("n_sites=14", [f"solver={k}" for k in (1, 2, 3)] + [
                         "tolerance=1e-3", "max_iterations=2", "tolerance=1e-17"], "generate views")],
    "c-plane-progress": [Host("n_sites=30 progress=print generate write.progress=print write t.obj write t.foam"),
                         Host("n_sites=10 progress=sites max_iterations=3 generate"),
                         Host("n_sites=30 progress=cancel:4 generate"),
                         Host("n_sites=30 generate write.progress=cancel:2 write t.obj "
                              "write.progress=cancel:1 write t.glb")],
    "c-plane-refusals": [alone("n_sites=5", [
        "n_sites=0", "n_sites=-1", "n_sites=268435457", "lattice=1,0,2,0", "lattice=1,0,nan,1", "origin=inf,0",
        "sites=0,0,0.5,0.5,nan,0,0.1,0.1,0.2,0.2", "sites=0,0,0.5,0.5,1,1,0.1,0.1,0.2,0.2", "start=5", "start=-1",
        "solver=4", "tolerance=0", "tolerance=nan", "n_threads=-1", "n_threads=1025", "columns=0", "rows=-2",
        "grain_order=3", "grain_size=-1", "grain_size=0.1 grain_per_edge=2", "short_edges=0.6", "budget=-1", "budget=5",
        "density_source=", "density_source=w", "density_source=none.png", "density_range=2,1", "areas=1,2 n_areas=2",
        "areas=1,2,3,-4,5 n_areas=5", "area_law=normal:3", "aspect=0", "aspect_degrees=nan", "phases=a:0.5",
        "orientations=1,2,3 n_orientations=1", "symmetry=18", "symmetry=11 walls=1", "walls=4", "wall_cells=1",
        "'inclusions=circle a 0.5 0.5 0.8'", "'inclusions=square a 1'", "fibres=2,2", "fixed_sites=0,0 n_fixed_sites=9",
        "holes=a", "reserved=1", "reserved2=1", "reserved3=1", "reserved4=1", "dimension=0", "dimension=4",
        "lattice3=2,0,0,0,1,0,0,0,1", "struct_size=8", "struct_size=4000"])],
    "c-plane-write-refusals": [Host("n_sites=8 generate " + " ".join(f"reset {words}" for words in (
        "write t.xyz", "write t", "write -", "write /dev/null/t.obj", "write.kind=3 write t.obj",
        "write.outline=2 write t.obj", "write.kind=1 write.outline=1 write t.obj", "write t.msh",
        "write.colour=9 write t.svg",
        "write.colour=5 write t.svg", "write.gltf_nodes=3 write t.glb", "write.gltf_nodes=1 write t.obj",
        "write.single_precision=1 write t.obj", "write.pixels=-1 write t.png", "write.pixels=64 write t.obj",
        "write.element=2 write t.inp", "write.cut_width=-1 write t.svg", "write.background=red write t.svg",
        "write.voxels=1,2 write t.obj", "write.job=2 write t.inp", "write.voxel_layers=1 write t.obj",
        "write.thickness=-1 write t.foam", "write.surface=1 write t.obj", "write.reserved2=1 write t.obj",
        "write.struct_size=8 write t.obj", "write.report=/dev/null/r.json write t.obj", "write s.obj write s.obj",
        "write.replace=1 write s.obj"))), Host("n_sites=3 generate misuse")],
}

SPACE_C = {
    "c-space-views": [Host(f"{SPACE} n_sites={n} seed={n} generate views") for n in (1, 2, 5, 8)] + [
        Host(f"{OBLIQUE3} n_sites=9 generate views"),
        Host(f"{SPACE} lattice3=1,0,0,0,0,1.1,0.3,0.8,0 n_sites=6 max_iterations=0 generate views"),
        Host(f"{SPACE} sites={SITES3} n_sites=3 max_iterations=0 generate views")],
    "c-space-formats": [Host(f"{OBLIQUE3} n_sites=20 seed=7 generate " + writes([
        "vtu", "vtu:write.kind=1", "foam", "msh", "msh:write.kind=1", "obj", "obj:write.surface=1", "ply",
        "ply:write.surface=1", "glb", "glb:write.surface=1", "om", "svg", "png", "txt", "vtu:write.report=r.json"])
        + " reset write.report=alone.json write -"),
        "check t0.vtu t1.vtu t2.foam t3.msh t4.msh t5.obj t6.obj t7.ply t8.ply t9.glb t10.glb t11.om t15.vtu"],
    "c-space-runs": [
        alone(f"{SPACE} n_sites=16", ["start=1", "start=3", "start=2", "solver=1", "solver=2 max_iterations=4",
                                      "tolerance=1e-2", "tolerance=1e-10", "max_iterations=0", "n_threads=1",
                                      "n_threads=3", "short_edges=0.05"], "generate views"),
        Host(f"{OBLIQUE3} n_sites=16 short_edges=0.05 generate write t.vtu write t.foam write t.obj")],
    "c-space-progress": [
        Host(f"{SPACE} n_sites=20 progress=print generate write.progress=print write t.vtu write t.msh"),
        Host(f"{SPACE} n_sites=10 progress=sites max_iterations=2 generate"),
        Host(f"{SPACE} n_sites=20 progress=cancel:1 generate progress=cancel:4 generate"),
        Host(f"{SPACE} n_sites=20 generate write.progress=cancel:2 write t.vtu write.progress=cancel:3 write t.foam")],
    "c-space-refusals": [alone(f"{SPACE} n_sites=3", [
        "n_sites=0", "n_sites=67108865", "tolerance=0", "n_threads=1025", "sites=0.1,0.2,0.3,0.6,0.5,nan,1,1,1",
        "sites=0.25,0.5,0,0.5,0.5,0,1.25,-0.5,3", f"sites={SITES3} start=1", "lattice3=1,0,0,0,1,0,0,0,0",
        "lattice3=1,0,0,0,1,0,0,0,inf", "short_edges=0.2", "short_edges=-1", "reserved4=1", "start=4", "start=77",
        "solver=3", "solver=-1", "lattice=1,0,0.5,1",
        "grain_per_edge=2", "walls=2", "wall_cells=1",
        "'inclusions=circle a 0.5 0.5 0.1'",
        "fibres=0.2,2", "holes=fibre", "budget=5", "density_source=1", "density_range=0,1", "density=wave",
        "areas=1,2,3", "n_areas=3", "area_law=equal", "aspect_degrees=30",
        "symmetry=1", "fixed_sites=1,2,3", "n_fixed_sites=1"])],
    "c-space-write-refusals": [Host(f"{SPACE} n_sites=8 generate " + " ".join(f"reset {words}" for words in (
        "write t.nc", "write t.xyz", "write t", "write -", "write /dev/null/t.vtu",
        "write.kind=1 write t.foam", "write.kind=1 write t.obj",
        "write.colour=1 write t.vtu",
        "write.gltf_nodes=2 write t.glb", "write.single_precision=1 write t.ply", "write.pixels=64 write t.png",
        "write.element=1 write t.vtu", "write.cut_width=100 write t.svg", "write.background=none write t.svg",
        "write.job=1 write t.vtu", "write.thickness=0.1 write t.foam",
        "write.surface=2 write t.obj", "write.surface=1 write t.vtu", "write.struct_size=8 write t.vtu",
        "write s.vtu write s.vtu", "write.replace=1 write s.vtu"))), Host(f"{SPACE} n_sites=3 generate misuse"),
        Host(f"{SPACE} n_sites=38 start=3 generate write flat.msh")],
}

PLANE_PYTHON = {
    "python-plane-arrays": [Python("show_result(pcvt.mesh(7, OBLIQUE, seed=3))"),
                            Python("show_result(pcvt.mesh([[0.1, 0.2], [0.6, 0.5], [5.3, -0.2]], max_iterations=0))"),
                            Python("show_result(pcvt.mesh(2, period=(2, 1), repeat=(2, 1), origin=(0.3, -7)))")],
    "python-plane-files": [Python("""
result = pcvt.mesh(20, OBLIQUE, seed=7)
for name in "obj ply glb gltf om vtu foam svg dxf png html csv txt".split():
    result.write(f"t.{name}", progress=Watch())
result.write("d.msh", "delaunay", report="r.json")
result.write("g.inp", "grains", job="elastic", element="CPS")
result.write("b.ply", outline="box", float32=True)
result.write("o.glb", gltf_nodes="one", colour="size")
result.write("c.svg", cut_width=100, replace=True)
result.write("p.png", pixels=64)
result.write("v.foam", thickness=0.5)
pcvt.mesh(100, period=(2, 1)).write("v.vti", voxels=(24, 12))
"""), "check t.obj t.ply t.glb t.gltf t.om t.vtu t.foam d.msh g.inp b.ply o.glb v.foam v.vti"],
    "python-plane-functions": [Python("""
show_result(pcvt.mesh(16, density=lambda x, y: 2 + np.sin(2 * np.pi * x), progress=Watch()), ["voronoi"], ["whole"])
show_result(pcvt.mesh(16, density="1 + u * (1 - u)", solver="newton"), ["voronoi"], ["whole"])
refused(pcvt.mesh, 16, density=lambda x, y: x - x)
refused(pcvt.mesh, 16, density=lambda x, y: {}["mine"])
refused(pcvt.mesh, 30, progress=Watch(3))
refused(pcvt.mesh(30).write, "t.obj", progress=Watch(2))
""")],
    "python-plane-cells": [Python("""
for options in (dict(areas="lognormal:0.4", max_iterations=5, phases={"soft": 0.7, "hard": 0.3}, orientations="random"),
                dict(aspect=(2, 30), short_edges=0.1), dict(symmetry="p4m"), dict(fixed=[[0.1, 0.1], [0.6, 0.5]]),
                dict(walls="y", period=(2, 1)), dict(areas=np.arange(1, 13.0))):
    show_result(pcvt.mesh(12, **options), ["voronoi"], ["whole"])
shapes = [("circle", "a", 0.5, 0.5, 0.2), ("polygon", "b", [[0, 0], [0.1, 0], [0.05, 0.1]])]
show_result(pcvt.mesh(150, inclusions=shapes, holes="a"), ["voronoi"], ["whole"])
show_result(pcvt.mesh(150, fibres=(0.2, 3)), ["voronoi"], ["whole"])
""")],
    "python-plane-refusals": [Python("""
for sites, options in (
        (0, {}), (2**33 + 10, {}), ([[0, 0], [np.nan, 1]], {}), ([[0, 0], [1, 1]], {}), ([[0, 0, 0]], {}),
        (9, dict(lattice=((1, 0), (2, 0)))), (9, dict(lattice=(1, 1))), (9, dict(tolerance=0)),
        (9, dict(density="x +")),
        (9, dict(density="x\\0")), (9, dict(grain_size=0.1, grain_per_edge=2)), (9, dict(seed=-1)),
        (9, dict(solver="magic")), (9, dict(max_iterations=1.5)), (9, dict(start="nowhere")),
        (9, dict(period=(2, 0))), (9, dict(period=2)),
        (9, dict(lattice=OBLIQUE, period=(1, 1))), (9, dict(symmetry="p5")), (9, dict(walls="z")),
        (9, dict(origin="best")), (9, dict(areas=[1, 2])), (9, dict(phases="a:0.5")),
        (9, dict(orientations="fixed")), (9, dict(holes="a")),
        (9, dict(inclusions="square a 1")), (9, dict(fibres=(2, 2)))):
    refused(pcvt.mesh, sites, **options)
result = pcvt.mesh(9)
for path, options in (("t.xyz", {}), ("/dev/null/t.ply", {}), ("t.msh", {}), (None, {}), ("t.obj", dict(kind="cube")),
                      ("t.obj", dict(outline="round")), ("t.svg", dict(colour="red")), ("t.png", dict(pixels=-1))):
    refused(result.write, path, **options)
refused(result.mesh, "grains")
refused(result.tile, "delaunay", "box")
""")],
}

SPACE_PYTHON = {
    "python-space-arrays": [Python("show_space(pcvt.space(6))"),
                            Python("show_space(pcvt.space(9, OBLIQUE3, seed=3, short_edges=0.05))"),
                            Python("show_space(pcvt.space([[0.1, 0.2, 0.3], [5.5, -0.25, 0.5]], max_iterations=0))")],
    "python-space-files": [Python("""
result = pcvt.space(20, OBLIQUE3, seed=7)
for name in "vtu foam msh obj ply glb om svg png txt".split():
    result.write(f"t.{name}", progress=Watch())
result.write("d.vtu", mesh="delaunay", report="r.json")
for name in "obj ply glb".split():
    result.write(f"b.{name}", surface="boundary")
result.write(None, report="alone.json")
result.write("t.vtu", replace=True)
"""), "check t.vtu t.foam t.msh t.obj t.ply t.glb t.om d.vtu b.obj b.ply b.glb"],
    "python-space-runs": [Python("""
for options in (dict(start="lattice"), dict(start="coarse"), dict(solver="lloyd", max_iterations=4),
                dict(tolerance=1e-2), dict(tolerance=1e-10), dict(threads=1), dict(seed=5), dict(period=(1, 2, 0.5)),
                dict(max_iterations=0)):
    print(options)
    show_space(pcvt.space(16, **options))
""")],
    "python-space-functions": [Python("""
show_space(pcvt.space(8, progress=Watch()))
refused(pcvt.space, 20, progress=Watch(3))
refused(pcvt.space, 20, progress=lambda _: {}["mine"])
refused(pcvt.space(20).write, "t.vtu", progress=Watch(2))
""")],
    "python-space-refusals": [Python("""
for sites, options in (
        (0, {}), ([[0, 0]], {}), ([[0, 0, 0], [np.nan, 1, 0]], {}), ([[0, 0, 0], [1, 1, -2]], {}),
        (9, dict(lattice=((1, 0), (0, 1)))), (9, dict(lattice=((1, 0, 0), (0, 1, 0), (1, 1, 0)))),
        (9, dict(lattice=CUBE, period=(1, 1, 1))), (9, dict(period=(1, 0, 1))), (9, dict(period=(1, 1))),
        (9, dict(start="best")), (9, dict(solver="newton")), (9, dict(tolerance=0)), (9, dict(short_edges=0.2)),
        (9, dict(seed=-1)), (9, dict(threads=5000)), (9, dict(areas="equal"))):
    refused(pcvt.space, sites, **options)
result = pcvt.space(9)
for path, options in (("t.xyz", {}), ("/dev/null/t.vtu", {}), (None, {}),
                      ("t.obj", dict(mesh="delaunay")), ("t.foam", dict(surface="boundary")),
                      ("t.obj", dict(surface="skin"))):
    refused(result.write, path, **options)
refused(pcvt.space(9, short_edges=0.05).write, "t.obj")
""")],
    "python-signatures": [Python("""
for call in (pcvt.mesh, pcvt.space, pcvt.version, pcvt.Result.write, pcvt.Result.mesh, pcvt.Result.tile,
             pcvt.Result.plot, pcvt.Tile.polygons, pcvt.Tile.plot, pcvt.SpaceResult.write, pcvt.SpaceResult.tile,
             pcvt.SpaceTile.polygons):
    show_signature(call)
show("names", sorted(pcvt.__all__))
show("version", pcvt.version())
""")],
}

HOSTS = {**PLANE_C, **SPACE_C, **PLANE_PYTHON, **SPACE_PYTHON}
