"""A large tile must fit into the memory of a small machine."""

import resource
import unittest

from support.cli import CliTest, limit, main


class Large(CliTest):
    def test_a_hundred_thousand_sites_fit_into_4_GiB(self):
        small = limit(resource.RLIMIT_AS, 4 << 30)
        self.succeed("mesh", "--sites", 100000, "--max-iterations", 50, "--mesh", "voronoi",
                     "--mesh", "delaunay", "-o", "t.obj", "-o", "t.glb", "--quiet", preexec_fn=small)
        names = [f"t-{kind}.{e}" for kind in ("voronoi", "delaunay") for e in ("obj", "glb")]
        self.assertLessEqual(set(names), set(self.contents()))
        proofs = self.succeed("check", *names, preexec_fn=small)
        self.assertEqual(len(proofs.splitlines()), 4)


if __name__ == "__main__":
    main()
