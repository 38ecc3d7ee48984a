"""pcvt mesh: options of the files of solvers."""

import json
import re

from support.cli import CliTest, main


class Elements(CliTest):
    def types(self, *options):
        self.succeed("mesh", "--sites", 12, "--mesh", "grains", *options, "-o", "t.inp", "--force")
        self.succeed("check", "t.inp")
        return re.findall(r"^\*ELEMENT,TYPE=(\w+)", self.path("t.inp").read_text(), re.M)

    def test_elements_are_for_plane_strain_or_plane_stress(self):
        self.assertEqual(self.types(), ["CPE3"])
        self.assertEqual(self.types("--element", "CPE"), ["CPE3"])
        self.assertEqual(self.types("--element", "CPS"), ["CPS3"])
        self.assertEqual(self.types("--element", "CPS", "--order", 2), ["CPS6"])

    def test_wedges_have_the_order_of_their_triangles(self):
        self.assertEqual(self.types("--element", "C3D6", "--thickness", 0.2), ["C3D6"])
        self.assertEqual(self.types("--element", "C3D15"), ["C3D15"])
        self.assertEqual(self.types("--element", "C3D15", "--order", 2, "--outline", "box", "-o", "t.vtu"), ["C3D15"])
        wedges = ("mesh", "--sites", 12, "--mesh", "grains", "-o", "no.inp", "--element")
        self.refuse(2, "C3D6 have only corners; take the elements C3D15 for order 2", *wedges, "C3D6", "--order", 2)
        self.refuse(2, "C3D15 have nodes in the middle of edges; take order 2", *wedges, "C3D15", "--order", 1)
        self.refuse(2, "the thickness is not between 0.001 and 1000 times", *wedges, "C3D6", "--thickness", 1e6)

    def test_triangles_have_no_thickness(self):
        self.refuse(2, "no output takes a thickness; take the elements C3D6 or C3D15 of .inp", "mesh", "--sites", 12, "--mesh",
                    "grains", "--thickness", 0.2, "-o", "t.inp")
        # A thickness of another file is none of triangles.
        self.assertEqual(self.types("--thickness", 0.2, "-o", "t.foam"), ["CPE3"])

    def test_a_job_of_wedges_has_six_steps(self):
        self.types("--element", "C3D6", "--thickness", 0.25, "--period", "2,1", "--job", "elastic")
        text = self.path("t.inp").read_text()
        self.assertEqual(text.count("*STEP"), 6)
        self.assertRegex(text, "The volume of the period is 0.5[.] ")
        self.assertNotIn("\n1.\n", text)

    def test_elements_need_a_file_that_states_them(self):
        self.refuse(2, r"no output takes a type of elements; add one of \.inp", "mesh", "--sites", 12,
                    "--mesh", "grains", "--element", "CPS", "-o", "t.msh")
        self.refuse(2, "--element CPX: unknown; take CPE, CPS, C3D6 or C3D15", "mesh", "--sites", 12, "--mesh",
                    "grains", "--element", "CPX", "-o", "t.inp")


class MaterialFiles(CliTest):
    METALS = ("phase:\n  Soft:\n    mechanical:\n      elastic: {type: Hooke, C_11: 106.9e9, C_12: 60.5e9, C_44: 28.4e9}\n"
              "  hard: {mechanical: {elastic: {E: 2.0e+11, nu: 0.3}}}\n")
    JOB = ("mesh", "--sites", 8, "--mesh", "grains", "--phases", "soft:0.5,hard:0.5", "--job", "elastic", "-o", "t.inp")

    def test_phases_have_the_constants_of_the_file(self):
        self.write("metals.yaml", self.METALS)
        summary = self.succeed(*self.JOB, "--material", "metals.yaml", "--report", "t.json")
        self.assertRegex(summary, r"soft: C11 1.069e\+11, C12 6.05e\+10, C44 2.84e\+10 \(metals.yaml; DAMASK takes Pa\)")
        report = json.loads(self.path("t.json").read_text())["materials"]
        self.assertEqual(report[1], {"name": "hard", "E": 2e11, "nu": 0.3, "source": "metals.yaml"})
        text = self.path("t.inp").read_text()
        self.assertIn("*MATERIAL,NAME=soft\n*ELASTIC,TYPE=ORTHO\n1.069e+11,6.05e+10,", text)
        self.assertIn("*MATERIAL,NAME=hard\n*ELASTIC\n2e+11,0.3\n", text)
        self.assertNotIn("\ncontrast ", summary)
        # Perhaps in GPa, where the file is in Pa.
        summary = self.succeed(*self.JOB, "--force", "--material", "metals.yaml", "--material", "hard:7,0.25")
        self.assertRegex(summary, r"\ncontrast   the materials differ by a factor of 1\.01\d*e\+10 in C44; give all constants in one unit")
        self.assertIn("*MATERIAL,NAME=hard\n*ELASTIC\n7.,0.25\n", self.path("t.inp").read_text())

    def test_faults_name_the_file_and_the_line(self):
        self.write("metals.yaml", self.METALS.replace("60.5e9", "sixty"))
        self.refuse(2, "metals.yaml:4: 'sixty' is not a number; ", *self.JOB, "--material", "metals.yaml")
        self.write("metals.yaml", self.METALS.replace("60.5e9", "60,5e9"))
        self.refuse(2, "metals.yaml:4: the key '5e9' has no value; give it one, and write decimals with a point", *self.JOB,
                    "--material", "metals.yaml")
        self.write("two.yaml", self.METALS.replace("hard", "Hart"))
        self.refuse(2, "the phase hard has no elastic constants; .*the names in two.yaml: Soft, Hart", *self.JOB,
                    "--material", "two.yaml")
        self.refuse(2, "no.yaml: cannot read: ", *self.JOB, "--material", "no.yaml")
        self.refuse(2, "--material same and FILE exclude each other; ", *self.JOB, "--material", "same", "--material", "two.yaml")
        self.refuse(2, "t.material.yaml is an input as well", "mesh", "--sites", 8, "-o", "t.vti", "--material",
                    self.write("t.material.yaml", "phase: {GRAINS: {mechanical: {elastic: {E: 1, nu: 0.3}}}}"))
        self.assertFalse(self.path("t.inp").exists())


class Groups(CliTest):
    def test_a_group_that_lost_its_cell_is_refused(self):
        self.succeed("mesh", "--sites", 12, "--mesh", "delaunay", "-o", "t.msh")
        text = self.path("t.msh").read_text()
        self.assertRegex(text, '\n2 1 "cell_0"\n')
        self.write("bad.msh", text.replace('2 1 "cell_0"', '2 1 "cell_1"'))
        self.refuse(2, r"bad\.msh:\d+: the triangle is in the physical group 'cell_1', but its "
                    "cell_id is 0; ", "check", "bad.msh")


if __name__ == "__main__":
    main()
