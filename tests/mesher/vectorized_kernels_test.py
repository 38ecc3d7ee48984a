#!/usr/bin/env python3
"""vectorized_kernels_test.py OBJECT...  Every version of the kernels of the energy must be vectorised.

The compiler writes each kernel for three kinds of processors (mesher/base/target_clones.hpp). A version whose
loop it does not vectorise gives the same numbers, but takes four times as long, and only on processors
of that kind. All divisions of a kernel stand in its loop, so that none of them may be scalar.
"""

import itertools
import re
import subprocess
import sys
import unittest

# By the object that holds them.
KERNELS = {"tetrahedron_terms": ("pcvt::space::TetrahedronBlock::compute",),
           "triangle_terms": ("pcvt::plane::TriangleBlock::compute",),
           "power_terms": ("pcvt::space::PowerBlock::compute", "pcvt::space::PowerBlock::compute_moments")}
VERSIONS = ("default", "arch_x86_64_v3", "arch_x86_64_v4")


def divisions(objects):
    """The instructions that divide, by the name of their function."""
    text = subprocess.run(["objdump", "--disassemble", "--demangle", "--no-show-raw-insn", *objects],
                          check=True, capture_output=True, text=True).stdout
    found, name = {}, None
    for line in text.splitlines():
        if head := re.fullmatch(r"[0-9a-f]+ <(.*)>:", line):
            name = head[1]
        elif word := re.search(r"\sv?div[ps]d\s", line):
            found.setdefault(name, []).append(word[0].strip())
    return found


class VectorizedKernels(unittest.TestCase):
    def test_no_version_divides_number_by_number(self):
        # Their files stay out of the units; objects of other names would not come here.
        self.assertEqual(len(sys.argv) - 1, len(KERNELS), "one object for each kernel")
        found = divisions(sys.argv[1:])
        for kernel in itertools.chain(*KERNELS.values()):
            for version in VERSIONS:
                with self.subTest(kernel=kernel, version=version):
                    own = [words for name, words in found.items()
                           if name.startswith(kernel + "(") and f"[clone .{version}]" in name]
                    self.assertEqual(len(own), 1, "functions of this name that divide")
                    self.assertTrue(all(word.endswith("divpd") for word in own[0]), own[0])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
