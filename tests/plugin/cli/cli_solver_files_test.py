"""pcvt mesh: options of the files of solvers."""

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
