#!/usr/bin/env python3
"""vectorized_kernels_test.py OBJECT...  Every version of these kernels must be vectorised: energies, formulas, shapes
of tetrahedra.

The compiler writes each kernel for three kinds of processors (mesher/base/target_clones.hpp). A version whose
loop it does not vectorise gives the same numbers, but takes four times as long, and only on processors
of that kind. All divisions of a kernel of the energy stand in its loop, so that none of them may be scalar; a block
function and a shape have no scalar operation at all.
"""

import itertools
import re
import subprocess
import sys
import unittest

ENERGIES = ("pcvt::space::TetrahedronBlock::compute", "pcvt::plane::TriangleBlock::compute",
            "pcvt::space::PowerBlock::compute", "pcvt::space::PowerBlock::compute_moments")
BLOCKS = tuple("pcvt::block_" + name for name in (
    "exp log log2 log10 sqrt cbrt sinh cosh tanh asinh acosh atanh sin cos tan asin acos atan atan2 "
    "add subtract multiply divide round squared_difference add_product add_squared_difference").split())
BLOCKS += ("pcvt::(anonymous namespace)::normal_powers", "pcvt::(anonymous namespace)::all_powers")
SHAPES = ("pcvt::space::StarShape::qualities_of", "pcvt::space::StarShape::qualities_and_ratios_of")
OBJECTS = 8  # three files of energies and power cells, that of shapes, and the files of the block functions
VERSIONS = ("default", "arch_x86_64_v3", "arch_x86_64_v4")


def operations(objects):
    """The floating-point instructions, by the name of their function."""
    text = subprocess.run(["objdump", "--disassemble", "--demangle", "--no-show-raw-insn", *objects],
                          check=True, capture_output=True, text=True).stdout
    found, name = {}, None
    for line in text.splitlines():
        if head := re.fullmatch(r"[0-9a-f]+ <(.*)>:", line):
            name = head[1]
        elif word := re.search(r"\sv?(add|sub|mul|div|sqrt)[ps]d\s", line):
            found.setdefault(name, []).append(word[0].strip())
    return found


class VectorizedKernels(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.found = operations(sys.argv[1:])

    def words_of(self, kernel, version):
        own = [words for name, words in self.found.items()
               if name.startswith(kernel + "(") and f"[clone .{version}]" in name]
        self.assertEqual(len(own), 1, "functions of this name that compute")
        return own[0]

    def test_every_kernel_is_looked_at(self):
        # Their files stay out of the units; objects of other names would not come here.
        self.assertEqual(len(sys.argv) - 1, OBJECTS, "objects of the kernels")

    def test_no_version_of_an_energy_divides_number_by_number(self):
        for kernel, version in itertools.product(ENERGIES, VERSIONS):
            with self.subTest(kernel=kernel, version=version):
                divisions = [word for word in self.words_of(kernel, version) if "div" in word]
                self.assertTrue(divisions)
                self.assertTrue(all(word.endswith("pd") for word in divisions), divisions)

    def test_no_version_of_a_block_function_or_a_shape_computes_number_by_number(self):
        for kernel, version in itertools.product(BLOCKS + SHAPES, VERSIONS):
            with self.subTest(kernel=kernel, version=version):
                words = self.words_of(kernel, version)
                self.assertTrue(all(word.endswith("pd") for word in words), words)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
