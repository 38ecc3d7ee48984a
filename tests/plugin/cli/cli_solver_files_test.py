"""pcvt mesh: options of the files of solvers."""

import re

from support.cli import CliTest, main


class Elements(CliTest):
    def types(self, *options):
        self.succeed("mesh", "--sites", 12, "--mesh", "grains", *options, "-o", "t.inp", "--force")
        self.succeed("check", "t.inp")
        return re.findall(r"TYPE=(\w+)", self.path("t.inp").read_text())

    def test_elements_are_for_plane_strain_or_plane_stress(self):
        self.assertEqual(self.types(), ["CPE3"])
        self.assertEqual(self.types("--element", "CPE"), ["CPE3"])
        self.assertEqual(self.types("--element", "CPS"), ["CPS3"])
        self.assertEqual(self.types("--element", "CPS", "--order", 2), ["CPS6"])

    def test_elements_need_a_file_that_states_them(self):
        self.refuse(2, r"no output takes a type of elements; add one of \.inp", "mesh", "--sites", 12,
                    "--mesh", "grains", "--element", "CPS", "-o", "t.msh")
        self.refuse(2, "--element CPX: unknown; take CPE or CPS", "mesh", "--sites", 12, "--mesh",
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
