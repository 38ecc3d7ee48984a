#!/usr/bin/env python3
"""A tour of pcvt from Python in notebook cells (`# %%`).

    PYTHONPATH=plugin/python PCVT_LIBRARY=build/release/libpcvt.so samples/python_tour.py tour.png
"""

# %% Make a periodic tile of 150 cells on an oblique torus.
import sys

import matplotlib
import numpy as np

import pcvt

result = pcvt.mesh(sites=150, lattice=((1, 0), (0.37, 0.81)), seed=7)
figures = result.statistics
print(f"{figures.n_hexagons} of {figures.n_sites} cells are hexagons; "
      f"energy {figures.energy / figures.energy_bound:.6f} of the hexagonal bound")

# %% Check its seam: the boundary edge w0 -> w1 is v0 -> v1 moved by i a + j b.
tile = result.tile()
seam = tile.seam
move = np.column_stack([seam["i"], seam["j"]]) @ tile.lattice
misfit = np.abs(tile.points[seam["w0"]] - tile.points[seam["v0"]] - move).max()
print(f"{len(seam)} pairs on the seam; largest misfit {misfit:.1e}")

# %% Make smaller cells along a wave. A function of numpy arrays x, y works too, but more slowly.
wave = "1 + 12*exp(-8*(1 - cos(2*_pi*(y - 0.15*sin(2*_pi*x)))))"
graded = pcvt.mesh(sites=150, density=wave)

# %% Count how often random starts of 8 and 9 cells end in hexagons only, as in the paper's Fig. 11.
study = pcvt.study("fig11", sites=[8, 9], runs=50)
print(f"hexagons only: {study.table['percent']} percent")

# %% Draw cells, triangles and graded cells side by side.
matplotlib.use("Agg")
from matplotlib import pyplot

figure, axes = pyplot.subplots(1, 3, figsize=(18, 5), layout="constrained")
result.plot(axes=axes[0])
result.plot("delaunay", axes=axes[1])
graded.plot(axes=axes[2])
for panel, title in zip(axes, ("cells", "triangles", "cells of a density")):
    panel.set_title(title)
figure.savefig(sys.argv[1] if len(sys.argv) > 1 else "tour.png", dpi=100)
