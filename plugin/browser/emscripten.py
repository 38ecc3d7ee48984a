# The configuration of emscripten, which reads it from the path in EM_CONFIG. It differs from Debian's own one in its
# cache, which every user may write, and in the launcher of the compilers, which is ccache where the environment names it.
import os

EMSCRIPTEN_ROOT = "/usr/share/emscripten"
LLVM_ROOT = "/usr/bin"
BINARYEN_ROOT = "/usr"
LLVM_ADD_VERSION = "14"
CLANG_ADD_VERSION = "14"
NODE_JS = ["/usr/bin/node", "--no-experimental-fetch"]
CACHE = os.environ.get("PCVT_EMSCRIPTEN_CACHE") or os.path.expanduser("~/.cache/pcvt/emscripten")
FROZEN_CACHE = False
COMPILER_WRAPPER = os.environ.get("CMAKE_CXX_COMPILER_LAUNCHER")
