"""Words of options that the add-on shows. Written by plugin/words."""

MESH = ("voronoi", "delaunay", "grains")
OUTLINE = ("whole", "box")
