"""The Python package `pcvt` with the library that a test is given; exit 77 where numpy is missing.

    NAME_test.py COMMAND LIBRARY ...        LIBRARY is removed from the arguments
"""

import importlib.util
import os
import sys
from pathlib import Path

SKIPPED = 77
if importlib.util.find_spec("numpy") is None:
    print("skipped: numpy is missing; tests/packages test installs python3-numpy")
    sys.exit(SKIPPED)

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
PACKAGE = ROOT / "plugin" / "python"
LIBRARY = os.path.abspath(sys.argv.pop(2))
OBLIQUE = np.array([[1, 0], [0.37, 0.81]])

os.environ["PCVT_LIBRARY"] = LIBRARY
sys.path.insert(0, str(PACKAGE))
import pcvt
