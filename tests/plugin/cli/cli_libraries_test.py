"""The shared libraries that the command and libpcvt load.

    cli_libraries_test.py COMMAND LIBRARY
"""

import os
import re
import subprocess
import sys
import unittest

from support import cli

LIBRARY = os.path.abspath(sys.argv.pop(2))
# The run time of a sanitizer and the parts of glibc that it names.
OF_SANITIZERS = re.compile(r"lib(asan|tsan|ubsan|rt|dl|pthread|resolv)[.]")
MOST_OBJECTS = 15


def objects_of(file):
    """Returns the lines of ldd, one for each object that the dynamic linker loads with `file`."""
    done = subprocess.run(["ldd", file], capture_output=True, check=True, text=True)
    return [line for line in done.stdout.splitlines() if not OF_SANITIZERS.search(line)]


class Libraries(cli.CliTest):
    def test_command_and_library_load_few_objects_and_not_netcdf(self):
        for file in (cli.BINARY, LIBRARY):
            objects = objects_of(file)
            self.assertLessEqual(len(objects), MOST_OBJECTS, objects)
            self.assertNotRegex("".join(objects), "not found|netcdf|hdf5|curl")


if __name__ == "__main__":
    cli.main()
