"""The same job through the command and through the C interface gives the same bytes."""

import subprocess
import sys
import unittest

from support.cli import CliTest, main

CLIENT = ""


class SameBytes(CliTest):
    def compare(self, n_sites, seed):
        for extension in ("ply", "obj", "glb", "om"):
            tile = f"c.{extension}"
            subprocess.run([CLIENT, str(n_sites), str(seed), tile, f"{extension}.txt"], check=True,
                           cwd=self.folder, stdout=subprocess.DEVNULL)
            self.succeed("mesh", "--sites", n_sites, "--seed", seed, "--lattice", "1,0,0.37,0.81", "-o",
                         f"command.{extension}", "-o", "command.txt", "--force")
            files = self.contents()
            self.assertEqual(files[f"{extension}.txt"], files["command.txt"])
            if extension != "obj":  # an OBJ file names its material file
                self.assertEqual(files[tile], files[f"command.{extension}"])

    def test_few_sites(self):
        self.compare(30, 5)

    def test_a_thousand_sites(self):
        self.compare(1000, 2)


if __name__ == "__main__":
    CLIENT = sys.argv.pop()
    main()
