#!/usr/bin/env python3
"""Moves the wings of pcvt into mesher/plane and mesher/space. Run in the root of a clean checkout."""
import re, subprocess, sys, pathlib, os
ROOT = pathlib.Path.cwd()
PLANE = {"lattice": "geometry", **{x: x for x in "delaunay power density symmetry energy areas interfaces cvt search mesh materials grains tile proof voxels".split()}}
# space: file stem -> (folder, new stem)
SPACE = {}
def sp(old, folder, *stems):
    for s in stems:
        a, _, b = s.partition("=")
        SPACE[(old, a)] = (folder, b or a)
sp("space_base", "geometry", "hilbert_curve", "insertion_order", "unspoilt_thread", "wide_integer")
sp("space", "geometry", "space_lattice=lattice", "space_sites=sites")
sp("space", "delaunay", "growing_tetrahedra", "moving_tetrahedra", "site_grid", "site_insertion", "space_delaunay=periodic_delaunay",
   "space_energy=energy", "space_mirrors=mirror_diagram", "space_predicates=predicates", "tetrahedra_flips", "tetrahedra_untangling", "tetrahedron_terms", "torus_tetrahedra")
sp("space_cvt", "cvt", "space_coarse_start=coarse_start", "space_cvt=cvt", "space_hessian=hessian", "space_minimum=minimum")
sp("space_search", "search", "obtuse_superbase", "space_pattern=lattice_pattern", "space_stability=lattice_stability")
sp("polyhedra", "mesh", "beltrami_flow", "boundary_surface", "cell_choice", "cell_complex", "cell_faces", "cell_sites", "polyhedral_assembly", "polyhedral_mesh", "polyhedron_graph", "seam_pairs", "short_edges", "voronoi_corners")
sp("polyhedra", "proof", "cell_proof", "polyhedral_proof")
sp("tetrahedra", "mesh", "tetrahedral_mesh")
sp("tetrahedra", "proof", "tetrahedral_proof")
sp("surfaces", "tile", "openmesh_surface", "tile_surface")
sp("surfaces", "proof", "surface_proof")
OLD_SPACE = {"space_base", "space", "space_cvt", "space_search", "polyhedra", "tetrahedra", "surfaces"}
WORDS = {  # identifiers of the wing for space, renamed everywhere
 "SpaceLattice": "Lattice", "SpaceSites": "Sites", "SpaceReduction": "Reduction", "SpaceFrame": "Frame", "SpaceForm": "HermiteForm",
 "SpacePattern": "LatticePattern", "SpaceEnergy": "Energy", "SpaceEnergyPass": "EnergyPass", "SpaceSuspects": "Suspects", "SpaceMirrors": "MirrorDiagram",
 "SpaceDelaunay": "PeriodicDelaunay", "SpaceSolver": "Solver", "SpaceCvtOptions": "CvtOptions", "SpaceCvtResult": "CvtResult", "SpaceCoarseStartOptions": "CoarseStartOptions",
 "Offset3": "Offset", "Points3": "Points", "Components3": "Components", "Corner3": "Corner", "Displacement3": "Displacement", "Gram3": "Gram", "Image3": "Image",
}
FUNCTIONS = {
 "space_pattern": "lattice_pattern", "best_space_pattern": "best_lattice", "space_stability": "lattice_stability", "space_energy": "energy_of_moment",
 "correct_space_energy": "correct_energy", "space_mirrors": "mirror_diagram", "space_full_copies": "full_copies_diagram", "space_delaunay": "periodic_delaunay",
 "space_tetrahedra": "torus_tetrahedra", "compute_space_cvt": "compute_cvt", "space_coarse_start": "coarse_start", "assemble_space_hessian": "assemble_hessian",
 "space_minimum": "decided_minimum",
}
def git(*a): subprocess.run(["git", *a], check=True)
def mv(a, b):
    b.parent.mkdir(parents=True, exist_ok=True)
    git("mv", str(a), str(b))
path_map = {}  # old path without extension -> new, and folders
def moves():
    for base in ("mesher", "tests/mesher"):
        for old, new in PLANE.items():
            src = ROOT / base / old
            if not src.exists(): continue
            mv(src.relative_to(ROOT), pathlib.Path(base) / "plane" / new)
        for old in sorted(OLD_SPACE):
            src = ROOT / base / old
            if not src.exists(): continue
            for f in sorted(src.iterdir()):
                if f.suffix not in (".hpp", ".cpp"): continue
                stem = f.stem
                t = ""
                if base.startswith("tests") and stem.endswith("_test"): stem, t = stem[:-5], "_test"
                key = (old, stem)
                if key in SPACE:
                    folder, ns = SPACE[key]
                else:
                    # helper or a test of more than one file
                    folder = {"space_base": "geometry", "space": "delaunay", "space_cvt": "cvt", "space_search": "search", "polyhedra": "mesh", "tetrahedra": "mesh", "surfaces": "tile"}[old]
                    ns = stem
                    print("unmapped", f, "->", folder, ns)
                new = pathlib.Path(base) / "space" / folder / (ns + t + f.suffix)
                if (ROOT/new).exists(): sys.exit(f"{new} exists")
                path_map[str(f.relative_to(ROOT).with_suffix(""))] = str(new.with_suffix(""))
                # stash under a temporary root to avoid clashes with mesher/space itself
                mv(f.relative_to(ROOT), pathlib.Path("tmp_space") / new)
            for f in sorted((ROOT / base / old).iterdir()):
                if f.name == "README.md":
                    mv(f.relative_to(ROOT), pathlib.Path("tmp_space") / base / "space" / f"README_{old}.md")
                else:
                    git("rm", "-q", str(f.relative_to(ROOT)))
    for f in sorted((ROOT / "tmp_space").rglob("*")):
        if f.is_file(): mv(f.relative_to(ROOT), f.relative_to(ROOT / "tmp_space"))

def cmake():
    w = lambda p, t: (p.write_text(t, encoding="utf-8"), git("add", str(p)))
    p = ROOT / "mesher/CMakeLists.txt"; t = p.read_text()
    t = re.sub(r"foreach\(room.*?\)\n", "foreach(room base portable optimize plane space finite_volume)\n", t, flags=re.S); w(p, t)
    p = ROOT / "tests/mesher/CMakeLists.txt"; t = p.read_text()
    t = re.sub(r"foreach\(room.*?\)\n", "foreach(room base portable optimize plane space finite_volume)\n", t, flags=re.S); w(p, t)
    plane = "geometry delaunay power density symmetry energy areas interfaces cvt search mesh materials grains tile proof voxels".split()
    space = "geometry delaunay cvt search mesh tile proof".split()
    loop = lambda rooms: "foreach(room " + " ".join(rooms) + ")\n  add_subdirectory(${room})\nendforeach()\n"
    def have(base, rooms): return [r for r in rooms if (ROOT / base / r).is_dir() and any((ROOT / base / r).glob("*.cpp"))]
    for base in ("mesher", "tests/mesher"):
        for wing, rooms in (("plane", plane), ("space", space)):
            w(ROOT / base / wing / "CMakeLists.txt", loop(have(f"{base}/{wing}", rooms)))
    for r in have("mesher/space", space):
        d = ROOT / "mesher/space" / r
        cpp = sorted(f.name for f in d.glob("*.cpp"))
        exact = [f for f in cpp if f == "mirror_diagram.cpp"]
        t = "".join(f"target_sources({lib} PRIVATE\n" + "".join(f"  {f}\n" for f in fs) + ")\n" for lib, fs in (("mesher_exact", exact), ("mesher", [f for f in cpp if f not in exact])) if fs)
        w(d / "CMakeLists.txt", t)
    for r in have("tests/mesher/space", space):
        d = ROOT / "tests/mesher/space" / r
        cpp = sorted(f.name for f in d.glob("*.cpp"))
        alone = [f for f in cpp if f == "mirrors_without_memory_test.cpp"]
        t = f"pcvt_room_test(mesher_space_{r} LIBRARIES mesher SOURCES\n" + "".join(f"  {f}\n" for f in cpp if f not in alone) + ")\n"
        if alone: t += "# Replaces the allocator, so that it is a program of its own.\npcvt_room_test(mesher_space_memory LIBRARIES mesher SOURCES mirrors_without_memory_test.cpp)\n"
        w(d / "CMakeLists.txt", t)
    for old, new in PLANE.items():
        p = ROOT / "tests/mesher/plane" / new / "CMakeLists.txt"
        if p.exists(): w(p, p.read_text().replace(f"pcvt_room_test(mesher_{old}", f"pcvt_room_test(mesher_plane_{new}"))
    for old in OLD_SPACE: 
        q = ROOT / "mesher/space" / f"README_{old}.md"
        if q.exists() and old not in ("space_cvt", "space_search"): git("rm", "-qf", str(q.relative_to(ROOT)))
    R = pathlib.Path("/tmp/move/readmes")
    mv_ = lambda a, b: git("mv", str(a), str(b))
    mv_("mesher/space/README_space_cvt.md", "mesher/space/cvt/README.md"); mv_("mesher/space/README_space_search.md", "mesher/space/search/README.md")
    w(ROOT / "mesher/space/README.md", (R / "README.md").read_text())
    for r in ("geometry", "delaunay", "mesh", "proof", "tile"): w(ROOT / f"mesher/space/{r}/README.md", (R / f"README_{r}.md").read_text())
    w(ROOT / "mesher/plane/README.md", (R / "README_plane.md").read_text())
    (ROOT / "tests/arrows").write_text(pathlib.Path("/tmp/move/arrows").read_text())

def text_files():
    out = subprocess.run(["git", "ls-files"], capture_output=True, text=True, check=True).stdout.split("\n")
    for name in out:
        p = ROOT / name
        if name and p.is_file() and not p.is_symlink() and p.suffix not in (".png", ".svg", ".glb", ".pyc") and "corpus" not in name:
            try: yield p, p.read_text(encoding="utf-8")
            except UnicodeDecodeError: pass

def fix_paths(s):
    for old in sorted(path_map, key=len, reverse=True):
        s = re.sub(rf"(?<![\w/]){re.escape(old)}(?=\.[hc]pp|\b(?!/))", path_map[old], s)
    for old, new in PLANE.items():
        s = re.sub(rf"(?<![\w/.]){'mesher/' + old}(?=[/\"'\s)\]`|,.;:]|$)", f"mesher/plane/{new}", s)
        s = re.sub(rf"\btests/mesher/{old}(?=[/\"'\s)\]`|,.;:]|$)", f"tests/mesher/plane/{new}", s)
    return s

CODE = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'(?!\w)', re.S)
def map_code(text, code_fn, comment_fn=None):
    out, last = [], 0
    for m in CODE.finditer(text):
        # digit separators such as 1'000 are no characters
        if m[0][0] == "'" and m.start() and text[m.start()-1].isdigit(): continue
        out.append(code_fn(text[last:m.start()]))
        out.append(comment_fn(m[0]) if comment_fn and m[0].startswith(("//", "/*")) else m[0])
        last = m.end()
    out.append(code_fn(text[last:]))
    return "".join(out)

def wing_of(rel):
    m = re.match(r"(?:tests/)?mesher/(plane|space)/", rel)
    return m[1] if m else None

def names_of(wing):
    types, constants, functions = set(), set(), set()
    for f in (ROOT / "mesher" / wing).rglob("*.hpp"):
        t = map_code(f.read_text(), lambda x: x, lambda c: "")
        t = re.sub(r"^\s*#.*$", "", t, flags=re.M)
        depth_ok = t
        for m in re.finditer(r"^(?:template\s*<[^\n]*>\s*\n?)?(?:struct|class|enum class|concept)\s+(?:alignas\(\w+\)\s+)?(\w+)", t, re.M): types.add(m[1])
        for m in re.finditer(r"^(?:template\s*<[^\n]*>\s*\n?)?using\s+(\w+)\s*=", t, re.M): types.add(m[1])
        for m in re.finditer(r"^(?:inline )?(?:constexpr|const|extern)\s[^\n(]*?\b(k[A-Z]\w*)\b", t, re.M): constants.add(m[1])
        for m in re.finditer(r"^[A-Za-z_][\w:<>,&*\s\[\]]*?\b([a-z_]\w*)\(", t, re.M): functions.add(m[1])
    return types, constants, functions

def main():
    moves()
    cmake()
    # words of space first
    for p, s in list(text_files()):
        rel = str(p.relative_to(ROOT))
        n = fix_paths(s)
        if p.suffix in (".hpp", ".cpp", ".md"):
            for a, b in WORDS.items(): n = re.sub(rf"\b{a}\b", f"\x01{b}", n)
            for a, b in FUNCTIONS.items(): n = re.sub(rf"\b{a}\b(?=\s*\()", f"\x01{b}", n)
            # outside of the wing the words need their namespace
            inside = wing_of(rel) == "space" or p.suffix == ".md"
            n = n.replace("\x01", "" if inside else "space::")
            n = n.replace("space::space::", "space::")
        if n != s: p.write_text(n, encoding="utf-8")
    tables = {w: names_of(w) for w in ("plane", "space")}
    for w in tables: print(w, [len(x) for x in tables[w]])
    import json; json.dump({w: [sorted(x) for x in tables[w]] for w in tables}, open("/tmp/move/names.json", "w"))
    both = tables["plane"][0] & tables["space"][0]
    print("types of both:", sorted(both))
    space_only = tables["space"][0] - both
    plane_types = tables["plane"][0] | set()
    for p, s in list(text_files()):
        if p.suffix not in (".hpp", ".cpp"): continue
        rel = str(p.relative_to(ROOT))
        wing = wing_of(rel)
        n = s
        if wing:
            n = re.sub(r"^namespace pcvt \{", f"namespace pcvt::{wing} {{", n, flags=re.M)
            n = re.sub(r"^\}  // namespace pcvt$", f"}}  // namespace pcvt::{wing}", n, flags=re.M)
        includes_plane = True
        own = set(re.findall(r"\b(?:struct|class|enum class|using|concept|typename)\s+(\w+)", map_code(n, lambda x: x, lambda c: "")))
        def qualify(code, names, ns, own=own):
            names = names - own
            return re.sub(r"(?<![\w:.])(?<!->)\b(" + "|".join(sorted(names, key=len, reverse=True)) + r")\b(?!\s*\()" if ns == "constants" else
                          r"(?<![\w:.])(?<!->)\b(" + "|".join(sorted(names, key=len, reverse=True)) + r")\b", lambda m: f"{ns}::{m[1]}", code)
        if wing != "plane":
            allp = (plane_types | {c for c in tables["plane"][1]})
            if wing == "space": allp = allp - tables["space"][0] - tables["space"][1]
            n = map_code(n, lambda c: "\n".join(l if l.lstrip().startswith("#") else qualify(l, allp, "plane") for l in c.split("\n")))
        if wing != "space":
            sps = (space_only | tables["space"][1]) - tables["plane"][1]
            if wing == "plane": sps = sps - tables["plane"][0]
            n = map_code(n, lambda c: "\n".join(l if l.lstrip().startswith("#") else qualify(l, sps, "space") for l in c.split("\n")))
        n = n.replace("pcvt::plane::plane::", "pcvt::plane::")
        # explicit pcvt::Type
        for w in ("plane", "space"):
            names = plane_types if w == "plane" else space_only
            n = re.sub(r"\bpcvt::(" + "|".join(sorted(names, key=len, reverse=True)) + r")\b", rf"pcvt::{w}::\1", n)
        if n != s: p.write_text(n, encoding="utf-8")
main()
