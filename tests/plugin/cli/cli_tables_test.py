"""Tables that people have: every option that reads one, in every form, and the lines that refuse wrong ones."""

import csv
import itertools
import math
import re

from support.cli import CliTest, main

SEPARATORS = {"comma": ",", "semicolon": ";", "tab": "\t", "blanks": "  "}
ROWS = [(0.1, 0.2, 1.5, 10.5, 20.25, 30.0), (0.8, 0.3, 2.0, 0.0, 90.0, 45.0), (0.4, 0.7, 1.25, 5.0, 6.0, 7.5)]


def table(header, separator, comma, end, mark):
    """The rows as bytes, below a header if there is one."""
    lines = [separator.join(header)] if header else []
    for k, row in enumerate(ROWS):
        fields = [str(k + 1), *map(str, row)]
        lines.append(separator.join(f.replace(".", ",") if comma else f for f in fields))
    return (b"\xef\xbb\xbf" if mark else b"") + (end.join(lines) + end).encode()


class TableTest(CliTest):
    def cells(self, *arguments, **options):
        self.succeed("mesh", "--quiet", "--force", "--max-iterations", 0, *arguments, "-o", "t.csv", **options)
        lines = self.path("t.csv").read_text().splitlines()
        return list(csv.DictReader(line for line in lines if not line.startswith("#")))


class Forms(TableTest):
    NAMES = (None, ("Id", "x", "y", "ECD", "Euler1", "Euler2", "Euler3"),
             ("id", "X (um)", "Y (um)", "Equivalent_Diameter (um)", "phi1 (deg)", "PHI (deg)", "phi2 (deg)"))

    def forms(self):
        for (word, separator), header, comma, end, mark in itertools.product(
                SEPARATORS.items(), self.NAMES, (False, True), ("\n", "\r\n"), (False, True)):
            if comma and word not in ("semicolon", "tab"):
                continue
            yield self.write("e.csv", table(header, separator, comma, end, mark)), header

    def test_every_option_reads_every_form(self):
        circles = [math.pi / 4 * row[2] ** 2 for row in ROWS]
        plain = self.write("s.txt", "".join(f"{row[0]} {row[1]}\n" for row in ROWS))
        n = 0
        for name, header in self.forms():
            sites, sizes, angles = (name, name, name) if header else (
                f"{name}:2,3", f"diameter:{name}:4", f"deg:{name}:5,6,7")
            rows = self.cells("--input", sites, "--areas", sizes, "--orientations", angles)
            fixed = self.cells("--fixed", sites, "--sites", 3)
            for row, still, wanted, area in zip(rows, fixed, ROWS, circles, strict=True):
                self.assertAlmostEqual(float(row["x"]), wanted[0], 12)
                self.assertAlmostEqual(float(row["y"]), wanted[1], 12)
                self.assertAlmostEqual(float(still["x"]), wanted[0], 12)
                self.assertAlmostEqual(float(row["area"]), area / sum(circles), 9)
                self.assertEqual(tuple(float(row[k]) for k in ("phi1", "Phi", "phi2")), wanted[3:])
            rows = self.cells("--input", f"{name}:2,3", "--weights", f"diameter:{name}:3", "--phases", f"{name}:1")
            for k, (row, wanted) in enumerate(zip(rows, ROWS, strict=True)):
                self.assertAlmostEqual(float(row["weight"]), wanted[1] ** 2 / 4, 15)
                self.assertEqual(row["phase"], str(k + 1))
            n += 1
        self.assertEqual(n, 72)
        self.assertEqual(self.cells("--input", plain), self.cells("--input", f"{name}:2,3"))

    def test_space_has_a_third_coordinate(self):
        self.write("p.csv", "id,x,y,z\n1,0.1,0.2,0.3\n2,0.5,0.6,0.7\n3,0.2,0.9,0.4\n4,0.7,0.1,0.8\n")
        box = ("--period", "1,1,1", "--max-iterations", 0, "--quiet", "--force")
        self.succeed("mesh", "--input", "p.csv", *box, "-o", "a.txt")
        self.succeed("mesh", "--input", "p.csv:2,3,4", *box, "-o", "b.txt")
        self.assertEqual(self.path("a.txt").read_bytes(), self.path("b.txt").read_bytes())
        self.refuse(2, "p.csv:1: the header has a column z; give three periods", "mesh", "--input", "p.csv")

    def test_the_summary_says_what_was_read(self):
        self.write("e.csv", table(self.NAMES[2], ";", True, "\r\n", True))
        run = ("mesh", "--sites", 3, "--max-iterations", 0, "--areas")
        out = self.succeed(*run, "e.csv")
        self.assertRegex(out, r"(?m)^areas +diameters of column Equivalent_Diameter \(um\) of e\.csv \(each area times ")
        self.assertIn("areas of column 4 of d.csv", self.succeed(*run, self.write("d.csv", table(None, ",", False, "\n", False)) + ":4"))

    def test_the_summary_states_the_unit_of_the_period(self):
        run = ("mesh", "--max-iterations", 0)
        for option, name in (("--input", "e.csv"), ("--input", "e.csv:x,y"), ("--fixed", "e.csv:2,3")):
            self.write("e.csv", table(self.NAMES[2], ";", True, "\r\n", True))
            sites = () if option == "--input" else ("--sites", 3)
            self.assertRegex(self.succeed(*run, *sites, option, name), r"(?m)^sites +3; x, y are in um, and so is the period$")
            self.write("e.csv", table(self.NAMES[1], ";", True, "\r\n", True))
            self.assertRegex(self.succeed(*run, *sites, option, name), r"(?m)^sites +3$")
        self.write("far.csv", "x [mm],y [mm]\n120.25,0.5\n500.5,990.5\n900.25,0.25\n")
        self.assertRegex(self.succeed(*run, "--input", "far.csv"),
                         r"(?m)^sites +3; x, y are in mm, and so is the period; 3 of the file lie outside of .*: --period or --lattice may be "
                         r"wrong; the positions extend over 780 x 990.2 mm, which takes --period 780,990.2 or larger, in the same unit$")
        self.write("p.csv", "x (nm),y (nm),z (nm)\n0.1,0.2,0.3\n0.5,0.6,0.7\n0.2,0.9,0.4\n0.7,0.1,0.8\n")
        self.assertRegex(self.succeed(*run, "--input", "p.csv", "--period", "1,1,1"),
                         r"(?m)^sites +4; x, y, z are in nm, and so is the period$")

    def test_check_reads_the_same_table(self):
        self.write("e.csv", table(self.NAMES[1], ";", True, "\n", False))
        self.succeed("mesh", "--sites", 3, "--areas", "e.csv:ecd", "--max-iterations", 2, "-o", "t.obj")
        self.assertIn("areas of 3 cells within", self.succeed("check", "t.obj", "--areas", "e.csv"))
        self.refuse(2, "law of the areas", "check", "t.obj", "--areas", "area:e.csv:x")

    def test_names_of_files_may_hold_colons(self):
        self.write("rad:e.csv:x,y", "0.1 0.2\n0.5 0.6\n")
        self.assertEqual(len(self.cells("--input", "rad:e.csv:x,y")), 2)
        self.write("o.csv", "a,b,c\n" + "1,0.5,1\n" * 20)
        run = ("--sites", 20, "--orientations")
        self.assertAlmostEqual(float(self.cells(*run, "rad:o.csv:a,b,c")[3]["phi1"]), math.degrees(1), 12)
        self.assertEqual(float(self.cells(*run, "deg:o.csv:a,b,c")[3]["phi1"]), 1)
        self.refuse(2, "o.csv: .* look like radians; take --orientations rad:FILE", "mesh", *run, "o.csv:a,b,c")

    def test_standard_input_may_be_a_table(self):
        data = table(self.NAMES[1], ",", False, "\n", False)
        for name in ("-", "-:x,y", "-:2,3"):
            self.assertEqual(len(self.cells("--input", name, input=data)), 3)
        self.refuse(2, "standard input:1: there is no column 'q'; take one of", "mesh", "--input", "-:q,y", input=data)

    def test_a_table_is_not_overwritten(self):
        self.write("e.csv", table(self.NAMES[1], ",", False, "\n", False))
        for option in (("--input", "e.csv:x,y"), ("--sites", 3, "--areas", "diameter:e.csv:ECD"),
                       ("--sites", 3, "--orientations", "e.csv:Euler1,Euler2,Euler3"), ("--sites", 3, "--fixed", "e.csv:x,y")):
            self.refuse(2, "e.csv", "mesh", *option, "--force", "-o", "e.csv")


class Untidy(TableTest):
    """Tables as programs write them; the circles have the sizes of ROWS."""

    def assert_read(self, text, input_name="u.csv", sizes="u.csv"):
        self.write("u.csv", text)
        circles = [math.pi / 4 * row[2] ** 2 for row in ROWS]
        for row, wanted, area in zip(self.cells("--input", input_name, "--areas", sizes), ROWS, circles, strict=True):
            self.assertAlmostEqual(float(row["x"]), wanted[0], 9)
            self.assertAlmostEqual(float(row["y"]), wanted[1], 9)
            self.assertAlmostEqual(float(row["area"]), area / sum(circles), 6)

    def test_tables_of_other_programs(self):
        rows = [(k, x, y, d, math.pi / 4 * d * d) for k, (x, y, d, *_) in enumerate(ROWS, 1)]
        # ImageJ, with commas and with tabs.
        for mark in (",", "\t"):
            self.assert_read(mark.join((" ", "Area", "Mean", "X", "Y", "Feret")) + "\n" +
                             "".join(mark.join(map(str, (k, a, 128, x, y, 1))) + "\n" for k, x, y, _, a in rows))
        # pandas with its index, without and with quotes; a tab behind each row.
        self.assert_read(",x,y,diameter,phase\n" + "".join(f"{k - 1},{x},{y},{d},Ferrite\n" for k, x, y, d, _ in rows))
        self.assert_read('"","x","y","diameter"\n' + "".join(f'"{k}","{x}","{y}","{d}"\n' for k, x, y, d, _ in rows))
        self.assert_read("x\ty\tdiameter\t\n" + "".join(f"{x}\t{y}\t{d}\t\n" for _, x, y, d, _ in rows))
        self.assert_read("x\ty\tdiameter\n" + "".join(f"{x}\t{y}\t{d}\t\n" for _, x, y, d, _ in rows))
        # numpy.savetxt, whose header is a comment.
        self.assert_read("# x y d\n" + "".join(f"{x:.18e} {y:.18e} {d:.18e}\n" for _, x, y, d, _ in rows), "u.csv:1,2",
                         "diameter:u.csv:3")
        # A spreadsheet in German in the encoding of Windows.
        german = "Korn;X (\u00b5m);Y (\u00b5m);Fl\u00e4che (\u00b5m\u00b2)\r\n" + "".join(
            f"{k};{x};{y};{a:.9f}\r\n".replace(".", ",") for k, x, y, _, a in rows)
        self.assert_read(german.encode("cp1252"), sizes="area:u.csv:4")
        self.assert_read(german.encode("utf-8-sig"), sizes="area:u.csv:Fl\u00e4che")
        # Oxford: degrees.
        self.write("o.csv", "Id,Mean Orientation Phi1 (\u00b0),Mean Orientation PHI (\u00b0),Mean Orientation Phi2 (\u00b0)\n" +
                   "".join(f"{k},1,2,3\n" for k in range(12)))
        self.assertEqual(self.cells("--sites", 12, "--orientations", "o.csv")[5]["Phi"], "2")


class WrongTables(TableTest):
    def assert_refused(self, option, text, words, name="e.csv"):
        self.write("e.csv", text)
        sites = () if option == "--input" else ("--sites", 2)
        self.refuse(2, words, "mesh", *sites, option, name, "-o", "t.obj")

    def test_sizes(self):
        for text, words in (
                ("id,ECD\n1,2\n2\n", "^e.csv:3: the row has 1 field with commas between them, but the header has 2; "),
                ("id,ECD\n1,2\n2,0,5\n", "^e.csv:3: the row has 3 fields .* where commas are decimal marks write semicolons"),
                ("id,ECD\n1,2\n2,\n", "^e.csv:3: column 'ECD': the field is empty; give a number"),
                ("id,ECD\n1,2\n2,x\n", "^e.csv:3: column 'ECD': 'x' is not a number; write a decimal"),
                ("id,ECD\n1,2\n2,-1\n", "^e.csv:3: column 'ECD': '-1' is not the size of a cell; give a number"),
                ("id,ECD\n0,0\n1,2\n", "^e.csv:2: column 'ECD': .* a feature 0 without a size; remove the line"),
                ("id;ECD\n1;1.234,5\n2;1\n", "^e.csv:2: column 'ECD': '1.234,5' has 2 decimal marks; write one"),
                ("id;ECD\n1;0,5\n2;0.5\n", "^e.csv:3: column 'ECD': '0.5' has a decimal point, .* line 2 .*; write all"),
                ("id;ECD\n1;1,234\n2;2,345\n", "^e.csv:2: the comma may be a decimal mark or stand between thousands; "),
                ("id,Area,ECD\n1,2,3\n", "^e.csv:1: both column 'Area' and column 'ECD' hold sizes; name one, such as e.csv:Area"),
                ("id,size\n1,2\n", "^e.csv:1: no column is called area or diameter; name the column of sizes of 'id', 'size': --areas "
                                   "area:e.csv:size or --areas diameter:e.csv:size$"),
                ("id,ECD\n1,2\n2,1 234.5\n", "^e.csv:3: column 'ECD': '1 234.5' is not a number; write no separators of thousands$"),
                ("Grains,\nid,ECD\n1,2\n", r"^e.csv:1: .* \(if this is a title, remove the lines above the header\)"),
                ("id,ECD\n-,um\n1,2\n", "^e.csv:2: column 'ECD': 'um' is not a number; remove the row, or put units in brackets"),
                ("size\n1\n", "^e.csv:1: column 'size' may hold areas or diameters; write --areas area:e.csv or --areas diameter:e.csv"),
                ("id,Volume\n1,2\n", "^e.csv:1: cells in the plane have areas, not volumes; name the column"),
                ("0,5\n0,7\n", "^e.csv:1: '0,5' is not a number; write a decimal point, or .* name a column"),
                ("id,\"ECD\n1,2\n", "^e.csv:1: a quote is not closed; ")):
            self.assert_refused("--areas", text, words)
        self.assert_refused("--areas", "id,ECD\n1,2\n", "^e.csv:1: there is no column 'EDC'; take one of 'id', 'ECD'", "e.csv:EDC")
        self.assert_refused("--areas", "id,ECD\n1,2\n", "^e.csv:1: column 'ECD' holds diameters, but .*; remove area:",
                            "area:e.csv:ECD")

    def test_sites(self):
        for option in ("--input", "--fixed"):
            for text, words in (
                    ("a,b\n0.1,0.2\n", "^e.csv:1: the header has no column x; name the columns of the coordinates, e.csv:X,Y"),
                    ("x,y\n0.1,0.2\n0.3\n", "^e.csv:3: the row has 1 field "),
                    ("x,y,x\n0.1,0.2,0.3\n", "^e.csv:1: columns 1 and 3 are both called 'x'; "),
                    ("x (mm),y (um)\n0.1,0.2\n", "^e.csv:1: columns x and y do not have the same unit; "),
                    ("id,x,y\n1,0.1,0.2\n2,0.3,?\n", r"^e.csv:3: column 'y': '\?' is not a number; "),
                    ("0.1,0.2\n0.1,0.2,0.3\n", "^e.csv:2: a site has 2 coordinates, this line has 3; write"),
                    ("0,1 0,2\n", "^e.csv:1: '0,1' is not a number; use a decimal point, and blanks between")):
                self.assert_refused(option, text, words)
            self.assert_refused(option, "x,y\n0.1,0.2\n", "^e.csv:1: a site has 2 coordinates, 1 column is named; ", "e.csv:x")

    def test_suggestions_can_be_pasted(self):
        """What a message suggests behind the option is read."""
        german = "Korn-Nr.;Mittlerer Durchmesser (\u00b5m);Fl\u00e4che;X-Koordinate;Y-Koordinate;Phase\n1;0,5;0,2;0,1;0,2;a\n2;0,6;0,3;0,7;0,8;b\n"
        for encoding in ("utf-8", "cp1252"):
            self.write("my grains.csv", german.encode(encoding))
            for option in ("--input", "--areas"):
                sites = () if option == "--input" else ("--sites", 2)
                line = self.run_pcvt("mesh", *sites, option, "my grains.csv").stderr.decode()
                found = re.findall(r"'((?:\w+:)?my grains\.csv:[^']*)'", line)
                self.assertEqual(len(found), 1 if option == "--input" else 2, line)
                for name in found:
                    self.succeed("mesh", *sites, option, name, "--max-iterations", 0)

    def test_lengths_of_other_units_than_the_sites_are_refused(self):
        self.write("e.csv", "x (mm),y (mm),R (um),w (um),weight (um)\n0.1,0.2,0.1,0.01,0.01\n0.6,0.7,0.2,0.04,0.01\n")
        run = ("mesh", "--input", "e.csv:x,y", "--max-iterations", 0, "--weights")
        for name in ("e.csv:R", "radius:e.csv:w", "diameter:e.csv:w"):
            self.refuse(2, "^e.csv:1: the unit of the lengths is um, but that of the sites mm; give both in one unit$", *run, name)
        # The unit of weights is that of lengths squared.
        self.succeed(*run, "e.csv:weight")
        self.write("plain.csv", "R\n0.1\n0.2\n")
        self.succeed(*run, "plain.csv")

    def test_orientations(self):
        for text, words in (
                ("id,phi1,Phi\n1,2,3\n", "^e.csv:1: the header has no columns phi1, Phi and phi2; name the columns, e.csv:COLUMN"),
                ("phi1 (rad),Phi (deg),phi2 (rad)\n1,2,3\n", "^e.csv:1: column 'phi1' and column 'Phi' do not have the same unit"),
                ("phi1 (um),Phi (um),phi2 (um)\n1,2,3\n", "^e.csv:1: column 'phi1' has the unit 'um'; give angles in deg or rad"),
                ("phi1,Phi,phi2\n1,2,3\n1,2,\n", "^e.csv:3: column 'phi2': the field is empty; "),
                ("phi1,Phi,phi2\n1,2,3\n1,2,361\n", "^e.csv:3: "), ("1,2,3,4\n", "^e.csv:1: an orientation has 3 angles, .* 4; ")):
            self.assert_refused("--orientations", text, words)
        self.assert_refused("--orientations", "phi1 (rad),Phi (rad),phi2 (rad)\n1,2,3\n",
                            "^e.csv:1: the header states another unit of the angles than deg:; ", "deg:e.csv")


if __name__ == "__main__":
    main()
