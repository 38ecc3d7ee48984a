"""pcvt mesh -o mesh.nc: the attributes of the file, and the Coriolis parameter."""

import os

from support.cli import CliTest, main
from support.netcdf import Header


class Mpas(CliTest):
    def mesh(self, *arguments, name="t.nc"):
        self.succeed("mesh", "--sites", 40, "--retry", 40, *arguments, "-o", name, "--quiet", "--force")
        return Header(self.path(name).read_bytes())

    def test_every_variable_has_units_and_a_name(self):
        found = self.mesh()
        for name, attributes in found.of.items():
            self.assertEqual(list(attributes), ["units", "long_name"], name)
            self.assertTrue(all(attributes.values()), name)
        for name, units in (("xCell", "m"), ("latEdge", "rad"), ("zVertex", "m"), ("areaCell", "m^2"), ("dvEdge", "m"),
                            ("angleEdge", "rad"), ("cellsOnEdge", "unitless"), ("indexToCellID", "unitless")):
            self.assertEqual(found.of[name]["units"], units)
        self.assertNotIn("fCell", found.of)
        self.succeed("check", "t.nc")

    def test_the_history_holds_the_options_that_count_and_the_seed(self):
        os.makedirs(self.path("deep/er"))
        self.write("deep/er/my sites.txt", "".join(f"{(k % 6 + 0.5 * (k // 6 % 2)) / 6} {k // 6 / 6}\n" for k in range(36)))
        history = self.mesh("--seed", 3, "--period", "2,1").attributes["history"]
        self.assertRegex(history, r"^pcvt \d+\.\d+\.\d+: mesh --sites 40 --seed 3 --retry 40 --period 2,1; seed \d+$")
        self.succeed("mesh", "--input", "deep/er/my sites.txt", "--lattice", "1,0,0,0.8660254", "--density",
                     "2 + cos(2 * _pi * v) / 1e9", "--max-iterations", 3, "-o", "s.nc", "--quiet")
        self.assertRegex(Header(self.path("s.nc").read_bytes()).attributes["history"],
                         r": mesh --input 'my sites\.txt' --lattice 1,0,0,0\.8660254 --density "
                         r"'2 \+ cos\(2 \* _pi \* v\) / 1e9' --max-iterations 3; seed 0$")

    def test_the_history_does_not_depend_on_how_a_run_is_called(self):
        self.mesh(name="one.nc")
        self.mesh("--threads", 1, "--report", "r.json", "--cells", "c.csv", name="two.nc")
        os.mkdir(self.path("folder"))
        self.succeed("mesh", "-o", "three.nc", "--retry", 40, "--sites", 40, cwd=self.path("folder"))
        one = self.path("one.nc").read_bytes()
        self.assertEqual(one, self.path("two.nc").read_bytes())
        self.assertEqual(one, self.path("folder/three.nc").read_bytes())

    def test_the_coriolis_parameter_is_f_plus_beta_y(self):
        for given, f, beta in (("1e-4", 1e-4, 0), ("1e-4,2e-11", 1e-4, 2e-11), ("-3e-5,1e-3", -3e-5, 1e-3), ("0", 0, 0)):
            found = self.mesh(f"--coriolis={given}", "--origin", "5,-2")
            self.assertEqual((found.attributes["coriolis_f"], found.attributes["coriolis_beta"]), (f, beta))
            for word in ("Cell", "Edge", "Vertex"):
                self.assertEqual(found.doubles("f" + word), tuple(f + beta * y for y in found.doubles("y" + word)))
                self.assertEqual(found.of["f" + word]["units"], "s^{-1}")
            self.succeed("check", "t.nc")
        data = bytearray(self.path("t.nc").read_bytes())
        data[found.begin["fEdge"] + 8] ^= 0x3F
        self.write("bad.nc", bytes(data))
        self.refuse(2, r"law \(6\) of C-grids, Coriolis parameter", "check", "bad.nc")

    def test_bad_parameters_are_refused(self):
        for wrong in ("x", "1,2,3", "nan", "1,inf"):
            self.refuse(2, "--coriolis", "mesh", "--sites", 40, f"--coriolis={wrong}", "-o", "u.nc")
        self.refuse(2, r"no output takes a Coriolis parameter; add one of \.nc", "mesh", "--sites", 40, "--coriolis",
                    "1e-4", "-o", "u.obj")


if __name__ == "__main__":
    main()
