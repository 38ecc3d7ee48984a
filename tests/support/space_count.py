"""Counts the tetrahedra, the polyhedra or the closed surfaces of a file in space again, from only its points and
elements. Nothing here knows pcvt but the words by which files state the lattice and the cells.

counted(path) reads an .msh, .inp or .vtu, the polyMesh of a .foam, or an .stl, and raises Fault unless

  the elements have positive volumes that sum to det L, cell by cell to the volumes that the file states, if any;
  each side has one or two elements, and those with one are paired by lattice translations, each with one partner;
  glued along these pairs V - E + F - T = 0, where images of a node are one node;
  the nodes in the middle of edges are in the middle;
  in an .inp all images of a node but one depend on that one by equations that state the translation between them, no
  node depends twice, and no dependent degree of freedom is held;
  in an .stl each directed edge occurs as often as its reverse, and the volume inside is that of the lattice.
"""

import re

import numpy as np

EDGES = ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3))
SIDES = ((0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2))
# Positions in files are rounded to 16 digits, in some .inp files.
ROUNDING = 1e-12


class Fault(Exception):
    """A count that is wrong."""


def require(holds, complaint):
    if not np.all(holds):
        raise Fault(complaint)


class Mesh:
    """points, n x 3; tetrahedra, m x 4 or m x 10, in VTK's order; the cell of each; the rows of the lattice."""

    def __init__(self, points, tetrahedra, cells, lattice):
        self.points, self.tetrahedra, self.cells, self.lattice = points, tetrahedra, cells, lattice
        self.ties = self.held = self.stated = None


def lattice_of(text):
    return np.array(re.search(r"pcvt lattice (.*)", text)[1].split(), float).reshape(3, 3)


def of_msh(path):
    text = path.read_text()

    def section(name):
        return re.search(rf"\${name}\n(.*?)\$End{name}\n", text, re.S)[1].split("\n")

    names = {}
    for line in section("PhysicalNames")[1:-1]:
        dimension, tag, name = line.split(maxsplit=2)
        names[int(dimension), int(tag)] = name.strip('"')
    lines = section("Entities")
    counts = list(map(int, lines[0].split()))
    cell_of = {}
    for line in lines[1 + sum(counts[:3]):1 + sum(counts)]:
        words = line.split()
        groups = [names[3, int(tag)] for tag in words[8:8 + int(words[7])]]
        cell_of[int(words[0])] = next((int(name[5:]) for name in groups if name.startswith("cell_")), -1)
    lines = section("Nodes")
    points, at = {}, 1
    for _ in range(int(lines[0].split()[0])):
        n = int(lines[at].split()[3])
        for tag, row in zip(lines[at + 1:at + 1 + n], lines[at + 1 + n:at + 1 + 2 * n], strict=True):
            points[int(tag)] = row.split()
        at += 1 + 2 * n
    lines = section("Elements")
    tetrahedra, cells, at = [], [], 1
    for _ in range(int(lines[0].split()[0])):
        dimension, entity, _, n = map(int, lines[at].split())
        if dimension == 3:
            tetrahedra += [line.split()[1:] for line in lines[at + 1:at + 1 + n]]
            cells += [cell_of[entity]] * n
        at += 1 + n
    require(sorted(points) == list(range(1, len(points) + 1)), "the nodes are not 1 ... n")
    tetrahedra = np.array(tetrahedra, int) - 1
    if tetrahedra.shape[1] == 10:
        # Gmsh exchanges the last two.
        tetrahedra = tetrahedra[:, [0, 1, 2, 3, 4, 5, 6, 7, 9, 8]]
    return Mesh(np.array([points[k] for k in sorted(points)], float), tetrahedra, np.array(cells), lattice_of(text))


def of_vtu(path):
    text = path.read_text()

    def array(name):
        found = re.search(rf'<DataArray [^>]*Name="{name}"[^>]*>\n(.*?)</DataArray>', text, re.S)
        return None if found is None else np.array(found[1].split(), float)

    lattice = array("PeriodicLattice").reshape(3, 3)
    points = array("Points").reshape(-1, 3)
    types = array("types").astype(int)
    require(np.isin(types, (10, 24)), "a cell is not a tetrahedron")
    tetrahedra = array("connectivity").astype(int).reshape(len(types), -1)
    within = text[text.find("<CellData"):text.find("</CellData>")]
    has_cells = 'Name="CellId"' in within
    cells = np.array(re.search(r'Name="CellId"[^>]*>\n(.*?)</', within, re.S)[1].split(), int) if has_cells else None
    mesh = Mesh(points, tetrahedra, np.full(len(types), -1) if cells is None else cells, lattice)
    mesh.stated = array("CellVolumes")
    return mesh


def of_inp(path):
    text = path.read_text()
    mesh = Mesh(None, None, None, lattice_of(text))
    points, tetrahedra, cells, words = {}, {}, {}, []
    nodes_of, equations, held = {}, [], []
    for block in re.split(r"\n(?=\*[A-Z])", re.sub(r"^\*\*.*\n", "", text, flags=re.M)):
        head, _, rows = block.strip().partition("\n")
        card = head.upper().split(",")
        words = [row.rstrip(",").split(",") for row in rows.split("\n") if row.strip()]
        if card[0] == "*NODE" and "NSET=NALL" in card:
            points.update((int(row[0]), row[1:4]) for row in words)
        elif card[0] == "*NODE":
            nodes_of[next(word for word in card if word.startswith("NSET="))[5:]] = [int(row[0]) for row in words]
        elif card[0] == "*ELEMENT":
            numbers = list(map(int, ",".join(",".join(row) for row in words).split(",")))
            width = 11 if "TYPE=C3D10" in card else 5
            for k in range(0, len(numbers), width):
                tetrahedra[numbers[k]] = numbers[k + 1:k + width]
        elif card[0] == "*ELSET" and any(word.startswith("ELSET=CELL_") for word in card):
            cell = int(next(word for word in card if word.startswith("ELSET=CELL_"))[11:])
            for row in words:
                cells.update((int(number), cell) for number in row)
        elif card[0] == "*NSET":
            nodes_of[next(word for word in card if word.startswith("NSET="))[5:]] = [int(n) for row in words for n in row]
        elif card[0] == "*EQUATION":
            equations += equations_of(words)
        elif card[0] == "*BOUNDARY":
            held += words
    n_mesh = max(max(row) for row in tetrahedra.values())
    require(sorted(points)[:n_mesh] == list(range(1, n_mesh + 1)), "the nodes are not 1 ... n")
    numbers = sorted(tetrahedra)
    mesh.points = np.array([points[k] for k in range(1, n_mesh + 1)], float)
    mesh.tetrahedra = np.array([tetrahedra[k] for k in numbers], int) - 1
    mesh.cells = np.array([cells.get(k, -1) for k in numbers])
    mesh.ties, mesh.held, mesh.sets = equations, held, nodes_of
    return mesh


def equations_of(rows):
    """The terms (node, degree of freedom, coefficient) of each equation of a card."""
    numbers = [float(word) for row in rows for word in row if word.strip()]
    equations, at = [], 0
    while at < len(numbers):
        n = int(numbers[at])
        terms = numbers[at + 1:at + 1 + 3 * n]
        equations.append([(int(terms[k]), int(terms[k + 1]), terms[k + 2]) for k in range(0, 3 * n, 3)])
        at += 1 + 3 * n
    return equations


def rows_of_foam(path):
    text = path.read_text()
    text = text[text.index("\n(\n") + 3:text.rindex("\n)")]
    return [re.sub(r"^\d*\(|\)$", "", line).split() for line in text.split("\n") if line]


def of_foam(path):
    folder = path / "constant/polyMesh"
    points = np.array(rows_of_foam(folder / "points"), float)
    faces = [list(map(int, row)) for row in rows_of_foam(folder / "faces")]
    owner = [int(row[0]) for row in rows_of_foam(folder / "owner")]
    neighbour = [int(row[0]) for row in rows_of_foam(folder / "neighbour")]
    corners = [set() for _ in range(1 + max(owner + neighbour))]
    for face, cell in zip(faces, owner, strict=True):
        corners[cell].update(face)
    for face, cell in zip(faces, neighbour):
        corners[cell].update(face)
    require([len(found) == 4 for found in corners], "a cell has not four corners")
    tetrahedra = np.array([sorted(found) for found in corners])
    volumes = volumes_of(points, tetrahedra)
    tetrahedra[volumes < 0] = tetrahedra[volumes < 0][:, [0, 1, 3, 2]]
    text = (folder / "cellZones").read_text()
    cells = np.full(len(tetrahedra), -1)
    for name, labels in re.findall(r"\ncell_(\d+)\n\{.*?\n\(\n(.*?)\n\)", text, re.S):
        cells[np.array(labels.split(), int)] = int(name)
    return Mesh(points, tetrahedra, cells, lattice_of((folder / "boundary").read_text()))


READERS = {".msh": of_msh, ".vtu": of_vtu, ".inp": of_inp, ".foam": of_foam}


def volumes_of(points, tetrahedra):
    a, b, c, d = (points[tetrahedra[:, k]] for k in range(4))
    return np.einsum("ij,ij->i", np.cross(b - a, c - a), d - a) / 6


def read(path):
    return (polyhedra_of_foam if path.suffix == ".foam" else polyhedra_of_vtu)(path) if holds_polyhedra(path) else READERS[path.suffix](path)


def counted(path):
    """Counts a file. Returns the numbers of its nodes, edges, sides and elements after gluing; of an .stl, its triangles."""
    return counted_surfaces(path) if path.suffix == ".stl" else count_of(read(path))


def count_of(mesh):
    if isinstance(mesh, Polyhedra):
        return count_of_polyhedra(mesh)
    mesh.volumes = volumes = volumes_of(mesh.points, mesh.tetrahedra)
    require(volumes > 0, "a tetrahedron has no positive volume")
    require_sum(volumes, mesh.lattice)
    if mesh.stated is not None:
        sums = np.bincount(mesh.cells, volumes, len(mesh.stated))
        require(abs(sums - mesh.stated) < 1e-9 * volumes.sum(), "the volume of a cell is not the stated one")
    mesh.elements = corners = mesh.tetrahedra[:, :4]
    mesh.owners = mesh.cells
    sides, times = sides_of(corners)
    outer = sides[times == 1]
    orbit = glued(mesh, outer.tolist(), middles_of(mesh))
    edges = np.sort(np.concatenate([corners[:, list(edge)] for edge in EDGES]), axis=1)
    counts = euler_counts(mesh, orbit, corners, edges, len(sides), len(corners))
    if mesh.tetrahedra.shape[1] == 10:
        require_middles(mesh)
    if mesh.ties is not None:
        require_ties(mesh, orbit)
    return counts


def require_sum(volumes, lattice, tolerance=1e-10):
    whole = abs(np.linalg.det(lattice))
    require(abs(volumes.sum() / whole - 1) < tolerance, f"the volumes sum to {volumes.sum()}, not {whole}")


def euler_counts(mesh, orbit, used, edges, n_uses, n_elements):
    """The numbers after gluing, from the number of uses of all sides by elements, which are two a side."""
    require(n_uses % 2 == 0, "a side of the boundary is missing")
    counts = len(np.unique(orbit[used])), count_of_glued_edges(mesh, edges, orbit), n_uses // 2, n_elements
    euler = counts[0] - counts[1] + counts[2] - counts[3]
    require(euler == 0, "V - E + F - T = {} - {} + {} - {} = {}".format(*counts, euler))
    return counts


def sides_of(corners):
    """Returns the triangles of all tetrahedra, and how often each set of three corners occurs among them."""
    sides = np.concatenate([corners[:, list(side)] for side in SIDES])
    _, which, times = np.unique(np.sort(sides, axis=1), axis=0, return_inverse=True, return_counts=True)
    which = which.reshape(-1)
    require(times <= 2, "a triangle has more than two elements")
    return sides, times[which]


def scale_of(mesh):
    return max(np.abs(mesh.points).max(), np.abs(mesh.lattice).max())


def crosses(p, q):
    """As numpy.cross, whose checks take most of its time for few vectors."""
    return p[:, [1, 2, 0]] * q[:, [2, 0, 1]] - p[:, [2, 0, 1]] * q[:, [1, 2, 0]]


def area_vector(points):
    spokes = points[1:] - points[0]
    return crosses(spokes[:-1], spokes[1:]).sum(axis=0) / 2


def glued(mesh, outer, middle):
    """Pairs the polygons of the boundary by translations. Returns the representative of each node."""
    require(len(outer) % 2 == 0, "the boundary has an odd number of sides")
    tolerance = ROUNDING * scale_of(mesh) + 1e-14 * np.abs(mesh.lattice).max()
    inverse = np.linalg.inv(mesh.lattice)
    centres = np.array([mesh.points[side].mean(axis=0) for side in outer])
    normals = np.array([area_vector(mesh.points[side]) for side in outer])
    parent = np.arange(len(mesh.points))

    def find(v):
        while parent[v] != v:
            parent[v] = parent[parent[v]]
            v = parent[v]
        return v

    def join(a, b):
        a, b = find(a), find(b)
        parent[max(a, b)] = min(a, b)

    partner = partners(centres @ inverse, normals, 100 * tolerance * np.abs(inverse).sum(axis=0).max())
    for f, g in enumerate(partner):
        require(partner[g] == f and g != f and len(outer[f]) == len(outer[g]), "a side has not one partner")
        if g < f:
            continue
        offset = np.round((centres[g] - centres[f]) @ inverse) @ mesh.lattice
        require(abs(centres[g] - centres[f] - offset).max() < tolerance * 10, "partners are no translation of each other")
        image = {}
        for v in outer[f]:
            distance = abs(mesh.points[outer[g]] - mesh.points[v] - offset).max(axis=1)
            require(distance.min() < tolerance * 10, "a corner of a side has no image at its partner")
            image[v] = outer[g][distance.argmin()]
            join(v, image[v])
        require(len(set(image.values())) == len(image), "two corners of a side have one image")
        for a, b in zip(outer[f], outer[f][1:] + outer[f][:1]) if middle else ():
            join(middle[min(a, b), max(a, b)], middle[min(image[a], image[b]), max(image[a], image[b])])
    return np.array([find(v) for v in range(len(parent))])


def middles_of(mesh):
    """The node in the middle of each edge; nothing of tetrahedra with four nodes."""
    if mesh.tetrahedra.shape[1] == 4:
        return {}
    rows = mesh.tetrahedra.tolist()
    return {(min(row[a], row[b]), max(row[a], row[b])): row[4 + k] for row in rows for k, (a, b) in enumerate(EDGES)}


def partners(places, normals, room):
    """Returns the side whose centre is that of each side modulo 1 and whose normal is opposite."""
    room = max(room, 1e-12)
    fractions = places - np.floor(places)
    order = np.argsort(fractions[:, 0], kind="stable")
    rising = fractions[order, 0]
    found = np.full(len(places), -1)
    for f in range(len(places)):
        x = fractions[f, 0]
        near = [order[slice(*np.searchsorted(rising, (y - room, y + room)))] for y in (x - 1, x, x + 1)]
        near = np.concatenate(near)
        gap = fractions[near] - fractions[f]
        near = near[(np.abs(gap - np.round(gap)) < room).all(axis=1)]
        near = near[np.einsum("ij,j->i", normals[near], normals[f]) < 0]
        require(len(near) > 0, "a side of the boundary has no partner")
        gap = fractions[near] - fractions[f]
        found[f] = near[np.abs(gap - np.round(gap)).max(axis=1).argmin()]
    return found


def count_of_glued_edges(mesh, edges, orbit):
    """Edges of one pair of nodes and one vector, forwards or backwards, are one edge."""
    edges = np.unique(edges, axis=0)
    a, b = orbit[edges[:, 0]], orbit[edges[:, 1]]
    vector = (mesh.points[edges[:, 1]] - mesh.points[edges[:, 0]]) / scale_of(mesh)
    turned = a > b
    vector[turned] *= -1
    low, high = np.minimum(a, b), np.maximum(a, b)
    same = low == high
    # A loop has a vector and its opposite: the first number that is not 0 is positive.
    first = np.where(abs(vector[:, 0]) > 1e-9, vector[:, 0], np.where(abs(vector[:, 1]) > 1e-9, vector[:, 1], vector[:, 2]))
    vector[same & (first < 0)] *= -1
    keys = {(i, j): [] for i, j in zip(low, high)}
    n = 0
    for i, j, v in zip(low, high, vector):
        known = keys[i, j]
        if not any(np.abs(v - w).max() < 1e-10 for w in known):
            known.append(v)
            n += 1
    return n


def require_middles(mesh):
    for k, (a, b) in enumerate(EDGES):
        middle = (mesh.points[mesh.tetrahedra[:, a]] + mesh.points[mesh.tetrahedra[:, b]]) / 2
        gap = np.abs(mesh.points[mesh.tetrahedra[:, 4 + k]] - middle).max()
        require(gap < 1e-12 * scale_of(mesh), "a node is not in the middle of its edge")
    edges = np.concatenate([np.sort(mesh.tetrahedra[:, list(edge)], axis=1) for edge in EDGES])
    middles = np.concatenate([mesh.tetrahedra[:, 4 + k] for k in range(6)])
    pairs = np.unique(np.column_stack([edges, middles]), axis=0)
    require(len(pairs) == len(np.unique(edges, axis=0)) == len(np.unique(middles)), "edges and middle nodes are not pairs")


def require_ties(mesh, orbit):
    """Each image but one of a node depends on that one; nothing that depends is held."""
    control = {mesh.sets[f"CONTROL_{k}"][0]: k - 1 for k in (1, 2, 3)}
    # The displacement of a control node, by degree of freedom: the component of the mean strain.
    strain = {0: (0, 1, 2), 1: (None, 0, 1), 2: (None, None, 0)}
    dependent, masters = {}, {}
    for terms in mesh.ties:
        (slave, dof, one), (master, same_dof, minus) = terms[:2]
        require(one == 1 and minus == -1 and dof == same_dof, "an equation does not tie one component of two nodes")
        require((slave, dof) not in dependent, f"node {slave} depends twice in {dof}")
        require(masters.setdefault(slave, master) == master, f"node {slave} has two masters")
        sums = np.zeros(3)
        for node, component, factor in terms[2:]:
            sums[axis_of(control[node], component, dof, strain)] -= factor
        dependent[slave, dof] = master
        shift = mesh.points[slave - 1] - mesh.points[master - 1]
        require(abs(sums - shift).max() < 1e-9 * scale_of(mesh), f"the equation of node {slave} has another translation")
    for slave, master in masters.items():
        require(all((slave, dof) in dependent for dof in (1, 2, 3)), f"node {slave} does not depend in all components")
        require(master not in masters, f"the master {master} depends")
    images = {}
    for v in np.unique(mesh.tetrahedra):
        images.setdefault(orbit[v], []).append(v + 1)
    for nodes in images.values():
        free = [v for v in nodes if v not in masters]
        require(len(free) == 1, f"of the images {nodes[:3]}... of a node {len(free)} do not depend")
        require(all(masters[v] == free[0] for v in nodes if v != free[0]), f"node {nodes[0]} has masters outside of its orbit")
    for row in mesh.held:
        word = row[0].strip()
        nodes = mesh.sets.get(word.upper(), None) if not word.isdigit() else [int(word)]
        first = int(row[1])
        last = int(row[2]) if len(row) > 2 and row[2].strip() else first
        for node in nodes:
            for dof in range(first, last + 1):
                require((node, dof) not in dependent, f"{word} is held in {dof}, which depends")


def axis_of(control, component, dof, strain):
    """The axis of the translation that a component of a control node multiplies in the equation of a displacement.

    CONTROL_1 holds e_xx, e_xy, e_xz, CONTROL_2 e_yy, e_yz in 2, 3, CONTROL_3 e_zz in 3."""
    first, second = control, component - 1
    require(strain[control][second] is not None, "an equation has a component that no control node has")
    axis = {first: second, second: first}.get(dof - 1)
    require(axis is not None, "an equation has a strain of another component")
    return axis


class Polyhedra:
    """points, and the faces of each cell, counter-clockwise seen from outside."""

    def __init__(self, points, cells, lattice):
        self.points, self.cells, self.lattice = points, cells, lattice


def holds_polyhedra(path):
    if path.suffix == ".foam":
        return "pcvt kind polyhedra" in (path / "constant/polyMesh/boundary").read_text()
    return path.suffix == ".vtu" and 'Name="faces"' in path.read_text()


def polyhedra_of_foam(path):
    folder = path / "constant/polyMesh"
    faces = [list(map(int, row)) for row in rows_of_foam(folder / "faces")]
    owner = [int(row[0]) for row in rows_of_foam(folder / "owner")]
    neighbour = [int(row[0]) for row in rows_of_foam(folder / "neighbour")]
    cells = [[] for _ in range(1 + max(owner + neighbour))]
    for face, cell in zip(faces, owner, strict=True):
        cells[cell].append(face)
    for face, cell in zip(faces, neighbour):
        cells[cell].append(face[::-1])
    mesh = Polyhedra(np.array(rows_of_foam(folder / "points"), float), cells, lattice_of((folder / "boundary").read_text()))
    # In a box cells are pieces, and no zone names their cells.
    mesh.owners = None
    return with_elements(mesh)


def polyhedra_of_vtu(path):
    text = path.read_text()

    def array(name, kind=int):
        return np.array(re.search(rf'<DataArray [^>]*Name="{name}"[^>]*>\n(.*?)</DataArray>', text, re.S)[1].split(), kind)

    numbers, cells, at = array("faces").tolist(), [], 0
    while at < len(numbers):
        faces, at = [], at + 1
        for _ in range(numbers[at - 1]):
            faces.append(numbers[at + 1:at + 1 + numbers[at]])
            at += 1 + numbers[at]
        cells.append(faces)
    mesh = Polyhedra(array("Points", float).reshape(-1, 3), cells, array("PeriodicLattice", float).reshape(3, 3))
    mesh.owners = array("CellId")
    return with_elements(mesh)


def with_elements(mesh):
    """The corners of each cell, padded by -1, as those of tetrahedra."""
    corners = [sorted({v for face in cell for v in face}) for cell in mesh.cells]
    mesh.elements = np.full((len(corners), max(map(len, corners))), -1)
    for row, found in zip(mesh.elements, corners):
        row[:len(found)] = found
    return mesh


def count_of_polyhedra(mesh):
    volumes, uses = [], {}
    for cell in mesh.cells:
        areas = np.array([area_vector(mesh.points[face]) for face in cell])
        require(abs(areas.sum(axis=0)).max() < 1e-10 * abs(areas).sum(), "a cell does not close")
        volumes.append(sum(volume_of_fan(mesh.points[face] - mesh.points[cell[0][0]]) for face in cell))
        for face in cell:
            uses.setdefault(tuple(sorted(face)), []).append(face)
    mesh.volumes = volumes = np.array(volumes)
    require(volumes > 0, "a cell has no positive volume")
    require_sum(volumes, mesh.lattice)
    require([len(found) <= 2 for found in uses.values()], "a face has more than two cells")
    orbit = glued(mesh, [found[0] for found in uses.values() if len(found) == 1], {})
    faces = [found[0] for found in uses.values()]
    edges = np.sort([edge for face in faces for edge in zip(face, face[1:] + face[:1])], axis=1)
    n_uses = sum(map(len, uses.values()))
    return euler_counts(mesh, orbit, np.unique(edges), edges, n_uses, len(volumes))


def volume_of_fan(points):
    """The volume of the cones over the triangles round the mean of the corners: bent faces have it from both sides."""
    centre = points.mean(axis=0)
    following = points[[*range(1, len(points)), 0]]
    return (crosses(points - centre, following - centre) @ centre).sum() / 6


def counted_surfaces(path):
    data = path.read_bytes()
    n = int.from_bytes(data[80:84], "little")
    require(len(data) == 84 + 50 * n, "the file has not the length of its triangles")
    facets = np.frombuffer(data, np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")]), n, 84)
    points, which = np.unique(facets["corners"].reshape(-1, 3), axis=0, return_inverse=True)
    corners = which.reshape(-1, 3)
    edges = np.concatenate([corners[:, [0, 1]], corners[:, [1, 2]], corners[:, [2, 0]]])
    require(edges[:, 0] != edges[:, 1], "a triangle has two equal corners")
    forwards = np.where(edges[:, 0] < edges[:, 1], 1, -1)
    _, which = np.unique(np.sort(edges, axis=1), axis=0, return_inverse=True)
    require(np.bincount(which.reshape(-1), forwards) == 0, "the surfaces do not close")
    p, q, r = (points[corners[:, k]].astype(float) - points[0] for k in range(3))
    lattice = re.search(rb"periods (.*)", data[:80])
    if lattice:
        require_sum(np.einsum("ij,ij->i", np.cross(p, q), r) / 6, np.array(lattice[1].split(), float).reshape(3, 3), 1e-4)
    cross = np.cross(q - p, r - p)
    require(np.einsum("ij,ij->i", cross, facets["normal"].astype(float)) > 0, "a normal is not that of its triangle")
    return (n,)
