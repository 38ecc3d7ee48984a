"""Bounds of the stiffness of a job by the materials of its elements, for samples/stiffness."""

import math
import re

# The components in the order of the script, and their places in it for elements in the plane.
PAIRS = ((0, 0), (1, 1), (2, 2), (1, 2), (0, 2), (0, 1))
PLANE = (0, 1, 5)


def inverse(matrix):
    """Returns the inverse of a matrix by Gauss-Jordan with pivots; None where it has none."""
    n = len(matrix)
    rows = [[*row, *(float(i == j) for j in range(n))] for i, row in enumerate(matrix)]
    for k in range(n):
        pivot = max(range(k, n), key=lambda i: abs(rows[i][k]))
        rows[k], rows[pivot] = rows[pivot], rows[k]
        if not abs(rows[k][k]) > 0:
            return None
        rows[k] = [x / rows[k][k] for x in rows[k]]
        for i in range(n):
            if i != k:
                rows[i] = [x - rows[i][k] * y for x, y in zip(rows[i], rows[k])]
    return [row[n:] for row in rows]


def product(a, b):
    return [[sum(x * b[k][j] for k, x in enumerate(row)) for j in range(len(b[0]))] for row in a]


def transposed(a):
    return [list(column) for column in zip(*a)]


class Materials:
    """The sections of a job: the elements, the material and the orientation of each, as its cards state them."""

    def __init__(self, lines):
        self.sets, self.axes, self.elastic, self.sections = {}, {}, {}, []
        self.is_plane_stress = False
        rows = name = None
        for _, line in lines:
            if line.startswith("**") or not line.strip():
                continue
            if not line.startswith("*"):
                if rows is not None:
                    rows += [word for word in line.strip().rstrip(",").split(",") if word.strip()]
                continue
            card, *parameters = re.sub(r"\s", "", line).split(",")
            options = {key.upper(): value.upper() for key, _, value in (word.partition("=") for word in parameters)}
            rows = None
            if card.upper() == "*ELSET":
                rows = self.sets.setdefault(options.get("ELSET"), [])
            elif card.upper() == "*ORIENTATION":
                rows = self.axes.setdefault(options.get("NAME"), [])
            elif card.upper() == "*MATERIAL":
                name = options.get("NAME")
            elif card.upper() == "*ELASTIC":
                rows = self.elastic.setdefault((name, options.get("TYPE", "ISO")), [])
            elif card.upper() == "*SOLIDSECTION":
                self.sections.append((options.get("ELSET"), options.get("MATERIAL"), options.get("ORIENTATION")))
            elif card.upper() == "*ELEMENT":
                self.is_plane_stress = self.is_plane_stress or options.get("TYPE", "").startswith("CPS")

    def stiffness(self, material, orientation):
        """Returns the 6 x 6 stiffness of a section along the axes of the job."""
        local = self.of_material(material)
        if orientation is None:
            return local
        a, b = (list(map(float, self.axes[orientation][k:k + 3])) for k in (0, 3))
        x = [p / math.hypot(*a) for p in a]
        along = sum(p * q for p, q in zip(x, b))
        y = [q - along * p for p, q in zip(x, b)]
        y = [q / math.hypot(*y) for q in y]
        z = [x[k - 2] * y[k - 1] - x[k - 1] * y[k - 2] for k in range(3)]
        turn = transposed([x, y, z])
        bond = [[turn[i][k] * turn[j][m] + (turn[i][m] * turn[j][k] if k != m else 0) for k, m in PAIRS] for i, j in PAIRS]
        return product(product(bond, local), transposed(bond))

    def of_material(self, material):
        stiffness = [[0.0] * 6 for _ in range(6)]
        if (material, "ORTHO") in self.elastic:
            c = list(map(float, self.elastic[material, "ORTHO"][:9]))
            for (i, j), value in zip(((0, 0), (0, 1), (1, 1), (0, 2), (1, 2), (2, 2), (5, 5), (4, 4), (3, 3)), c, strict=True):
                stiffness[i][j] = stiffness[j][i] = value
            return stiffness
        modulus, nu = map(float, self.elastic[material, "ISO"][:2])
        shear = modulus / (2 * (1 + nu))
        for i in range(3):
            stiffness[i + 3][i + 3] = shear
            for j in range(3):
                stiffness[i][j] = modulus * nu / ((1 + nu) * (1 - 2 * nu)) + (2 * shear if i == j else 0)
        return stiffness


def section_stiffness(full, in_space, is_plane_stress):
    """Returns the stiffness in the components of the elements."""
    if in_space:
        return full
    if is_plane_stress:
        compliance = inverse(full)
        return inverse([[compliance[i][j] for j in PLANE] for i in PLANE])
    return [[full[i][j] for j in PLANE] for i in PLANE]


def bounds(lines, volumes, volume, in_space):
    """Returns the least and the greatest diagonal of the stiffness: Reuss's and Voigt's means of the materials of the elements
    over the volume of the period. None where the job does not state one linear material for each element.

    lines    of the job, each with its place
    volumes  of the elements
    """
    materials = Materials(lines)
    n = 6 if in_space else 3
    stiffest, softest = ([[0.0] * n for _ in range(n)] for _ in range(2))
    filled = 0.0
    try:
        for elements, material, orientation in materials.sections:
            numbers = volumes if elements == "EALL" else map(int, materials.sets[elements])
            part = sum(volumes[number] for number in numbers) / volume
            if not part > 0:
                continue
            c = section_stiffness(materials.stiffness(material, orientation), in_space, materials.is_plane_stress)
            s = inverse(c)
            filled += part
            for i in range(n):
                for j in range(n):
                    stiffest[i][j] += part * c[i][j]
                    softest[i][j] += part * s[i][j]
    except (KeyError, ValueError, TypeError, ZeroDivisionError):
        return None
    if not math.isclose(filled, sum(volumes.values()) / volume, rel_tol=1e-6):
        return None
    # Holes have no stiffness.
    least = inverse(softest) if math.isclose(filled, 1, rel_tol=1e-6) else [[0.0] * n for _ in range(n)]
    return least and [(least[k][k], stiffest[k][k]) for k in range(n)]
