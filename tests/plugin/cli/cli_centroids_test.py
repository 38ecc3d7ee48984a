"""pcvt mesh --centroids FILE --volumes|--areas FILE: the cells of measured grains, from their sizes and centroids."""

import csv
import json
import math
import xml.etree.ElementTree as ElementTree

from support.cli import CliTest, main

CUBE = ("--period", "2,1,1")


def arrays(path):
    return {array.get("Name"): array.text.split() for array in ElementTree.parse(path).iter("DataArray")}


def minus(p, q):
    return [a - b for a, b in zip(p, q)]


def cell_moments(path):
    """The volume and the centroid of each cell of a .vtu of polyhedra, by tetrahedra from a point of it."""
    data = arrays(path)
    numbers = list(map(float, data["Points"]))
    points = [numbers[k:k + 3] for k in range(0, len(numbers), 3)]
    faces, begin = list(map(int, data["faces"])), 0
    for end in map(int, data["faceoffsets"]):
        at, origin, volume, first = begin + 1, None, 0, [0, 0, 0]
        for _ in range(faces[begin]):
            corners = [points[v] for v in faces[at + 1:at + 1 + faces[at]]]
            at += 1 + faces[at]
            origin = origin or corners[0]
            a = minus(corners[0], origin)
            for p, q in zip(corners[1:], corners[2:]):
                b, c = minus(p, origin), minus(q, origin)
                part = (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2])
                        + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6
                volume += part
                first = [f + part * (x + y + z) / 4 for f, x, y, z in zip(first, a, b, c)]
        yield volume, [o + f / volume for o, f in zip(origin, first)]
        begin = end


class Centroids(CliTest):
    def rows(self, path):
        with open(self.path(path), encoding="utf-8") as file:
            return list(csv.DictReader(line for line in file if not line.startswith("#")))

    def grains(self, n=40, noise=0):
        """Writes known.csv and grains.csv, a grain map of its cells whose centroids are off by `noise`."""
        self.succeed("mesh", "--sites", n, *CUBE, "--volumes", "lognormal:0.35", "-o", "known.vtu", "--cells", "known.csv",
                     "--force")
        text = "id;Centroid X;Centroid Y;Centroid Z;Volume;Phase\n"
        for k, (volume, centroid) in enumerate(cell_moments(self.path("known.vtu"))):
            x, y, z = (c + noise * math.sin(7 * k + axis) for axis, c in enumerate(centroid))
            text += f"{k};{x!r};{y!r};{z!r};{volume * 1e9!r};{'ab'[k % 2]}\n"
        self.write("grains.csv", text)

    TABLES = ("--centroids", "grains.csv:Centroid X,Centroid Y,Centroid Z", "--volumes", "grains.csv:Volume")

    def test_cells_are_found_from_one_table(self):
        self.grains()
        summary = self.succeed("mesh", *self.TABLES, *CUBE, "--phases", "grains.csv:Phase", "-o", "t.vtu", "--cells", "t.csv",
                               "--report", "r.json", "--strict")
        self.assertIn("converged after", summary)
        self.assertRegex(summary, r"volumes of column Volume of grains\.csv \(each volume times 1e-09\)")
        self.assertRegex(summary, r"centroids  off those of grains\.csv:.* by \S+ h on average, by at most \S+ h")
        self.assertIn("power cells of 40 sites", self.succeed("check", "t.vtu"))
        for k, (row, known) in enumerate(zip(self.rows("t.csv"), self.rows("known.csv"))):
            self.assertEqual(row["neighbours"], known["neighbours"])
            self.assertEqual(row["phase"], "ab"[k % 2])
            self.assertAlmostEqual(float(row["volume"]), float(known["volume"]), delta=1e-9 * 2 / 40)
        figures = json.loads(self.path("r.json").read_text(encoding="utf-8"))["centroids"]
        self.assertLess(figures["mean_misfit"], figures["largest_misfit"])
        self.assertLess(figures["largest_misfit"], 1e-6)

    def test_the_misfit_of_noisy_grains_is_the_true_one(self):
        self.grains(noise=0.02)
        self.succeed("mesh", *self.TABLES, *CUBE, "--max-iterations", 15, "-o", "t.vtu", "--report", "r.json")
        wanted = [[float(row["Centroid " + axis]) for axis in "XYZ"]
                  for row in csv.DictReader(self.path("grains.csv").read_text(encoding="utf-8").splitlines(), delimiter=";")]
        h, off = (2 / 40) ** (1 / 3), []
        for (_, found), centroid in zip(cell_moments(self.path("t.vtu")), wanted):
            off.append(math.hypot(*(math.remainder(a - b, w) for a, b, w in zip(found, centroid, (2, 1, 1)))) / h)
        figures = json.loads(self.path("r.json").read_text(encoding="utf-8"))["centroids"]
        self.assertGreater(max(off), 1e-5)
        self.assertAlmostEqual(figures["largest_misfit"], max(off), delta=1e-9)
        self.assertAlmostEqual(figures["mean_misfit"], sum(off) / 40, delta=1e-9)

    def test_the_plane_takes_areas(self):
        self.succeed("mesh", "--sites", 50, "--areas", "lognormal:0.4", "--max-iterations", 2, "-o", "k.vtu", "--cells", "k.csv")
        data = arrays(self.path("k.vtu"))
        numbers = list(map(float, data["Points"]))
        points = [numbers[k:k + 2] for k in range(0, len(numbers), 3)]
        text, begin = "x y area\n", 0
        for end in map(int, data["offsets"]):
            corners = [points[v] for v in map(int, data["connectivity"][begin:end])]
            cross = [(p[0] * q[1] - p[1] * q[0], p, q) for p, q in zip(corners, corners[1:] + corners[:1])]
            area = sum(c for c, _, _ in cross) / 2
            x, y = (sum(c * (p[k] + q[k]) for c, p, q in cross) / (6 * area) for k in range(2))
            text, begin = text + f"{x!r} {y!r} {area!r}\n", end
        self.write("g.txt", text)
        self.succeed("mesh", "--centroids", "g.txt", "--areas", "g.txt:area", "--cells", "c.csv", "--strict")
        for row, known in zip(self.rows("c.csv"), self.rows("k.csv")):
            self.assertEqual(sorted(row["neighbours"].split()), sorted(known["neighbours"].split()))

    def test_refusals(self):
        self.write("c.txt", "0.1 0.2 0.3\n0.6 0.5 0.4\n0.2 0.8 0.9\n")
        self.write("v.txt", "1\n2\n3\n")
        run = ("mesh", "--centroids", "c.txt", "--period", "1,1,1")
        for words, pattern in (
                (run, "--centroids needs the sizes of the grains; add --areas, in space --volumes$"),
                ((*run, "--volumes", "gamma:0.3"), "--volumes gamma:0.3: a law does not give the sizes of measured grains; "),
                ((*run, "--volumes", "v.txt", "--aspect", 2), "--centroids does not work with --aspect or --walls; leave "),
                ((*run, "--volumes", "v.txt", "--sites", 3), "--sites and --centroids exclude each other; remove one$"),
                ((*run, "--volumes", "v.txt", "--input", "c.txt"), "--input and --centroids exclude each other; remove one$"),
                ((*run, "--volumes", "v.txt", "--seed", 3), "--seed is for random sites, but --centroids gives them; "),
                (("mesh", "--centroids", "", "--period", "1,1,1"), "--centroids: the name is empty; give a file")):
            self.refuse(2, "^pcvt: " + pattern, *words)
        self.refuse(2, r"^none\.txt: cannot read", "mesh", "--centroids", "none.txt", "--period", "1,1,1", "--volumes", "v.txt")
        self.write("c.txt", "0.1 0.2 0.3\n0.6 0.5 0.4\n1.1 0.2 0.3\n")
        self.refuse(2, r"^c\.txt:3: the site coincides with the site of line 1", *run, "--volumes", "v.txt")
        self.write("v.txt", "1\n2\n")
        self.refuse(2, r"^v\.txt:2: the last of 2 volumes, but there are 3 sites", *run, "--volumes", "v.txt", "--duplicates", "drop")

    def test_centroids_that_nearly_coincide_are_refused(self):
        """Two centroids 2e-8 apart, with diameters 0.13 and 4.5, belong to no power cells."""
        self.write("grains.txt", "0.18691108429475145 0.25422977118704937 0.94211657818824979\n"
                                 "0.18691110401043406 0.25422977118704937 0.94211657818824979\n"
                                 "0.87091015729644228 0.99132497308662504 0.96981735074225717\n"
                                 "0.023513458317998559 0.30863693842414375 0.44890985885549717\n"
                                 "0.90906886040761015 0.34203352136111798 0.74658294358711874\n"
                                 "0.91225220609238566 0.55368492517602352 0.46504039739261305\n"
                                 "0.96075144180815308 0.034310138865351836 0.29239468170545035\n")
        self.write("sizes.txt", "diameter\n0.128923\n4.45243\n2.57475\n0.749935\n0.333288\n0.437902\n0.808724\n")
        self.refuse(2, r"^pcvt: the centroids of grains 0 and 1 nearly coincide, .*; correct one of them",
                    "mesh", "--period", "1,1,1", "--centroids", "grains.txt", "--volumes", "sizes.txt", "--max-iterations", 1,
                    "--origin", "1e3,0,-7", "-o", "t.vtu")


if __name__ == "__main__":
    main()
