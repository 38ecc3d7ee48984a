#!/usr/bin/python3
"""conductivity.py tile.msh  The mean conductivity in x of a periodic rectangle of two materials, by
dolfinx and dolfinx_mpc (Debian's python3-dolfinx-mpc and python3-gmsh).

The tag of cell_s is s + 1. The corner of the rectangle is at 0, 0.
"""

import sys

import gmsh
import numpy as np
import ufl
from dolfinx import fem
from dolfinx.io import gmshio
from dolfinx_mpc import LinearProblem, MultiPointConstraint
from mpi4py import MPI

gmsh.initialize()
gmsh.open(sys.argv[1])
mesh, cell_tags, _ = gmshio.model_to_mesh(gmsh.model, MPI.COMM_WORLD, 0, gdim=2)
gmsh.finalize()
site = np.empty(mesh.topology.index_map(2).size_local, int)
site[cell_tags.indices] = cell_tags.values - 1

constants = fem.FunctionSpace(mesh, ("DG", 0))
odd, k = fem.Function(constants), fem.Function(constants)
odd.x.array[:] = site % 2
k.x.array[:] = np.where(site % 2 == 0, 1, 10)

# Each node on the right and at the top is the image of one on the left or at the bottom. dolfinx_mpc
# finds the latter by its position, which must not lie outside of the mesh by rounding.
V = fem.FunctionSpace(mesh, ("CG", 1))
size = mesh.geometry.x.max(axis=0)[:2]
constraint = MultiPointConstraint(V)
for right, top in ((True, False), (False, True), (True, True)):
    move = np.array([right * size[0], top * size[1], 0])

    def is_image(x, right=right, top=top):
        return ((np.isclose(x[0], size[0]) == right) & (np.isclose(x[1], size[1]) == top))

    def original(x, move=move):
        moved = x - move[:, None]
        moved[:2] = np.clip(moved[:2].T, 1e-9 * size, (1 - 1e-9) * size).T
        return moved

    constraint.create_periodic_constraint_geometrical(V, is_image, original, [])
constraint.finalize()

# The temperature is x + u. The last term fixes the constant that periodic functions leave free.
u, v = ufl.TrialFunction(V), ufl.TestFunction(V)
a = (k * ufl.inner(ufl.grad(u), ufl.grad(v)) + 1e-9 * u * v) * ufl.dx
problem = LinearProblem(a, -k * v.dx(0) * ufl.dx, constraint,
                        petsc_options={"ksp_type": "preonly", "pc_type": "lu"})
u = problem.solve()

area = size[0] * size[1]
print("share", fem.assemble_scalar(fem.form(odd * ufl.dx)) / area)
print("mean", fem.assemble_scalar(fem.form(k * (1 + u.dx(0)) * ufl.dx)) / area)
