# The configuration of emscripten, read through EM_CONFIG: Debian's own one, with a cache that may be written, and with
# the compilers behind ccache where the environment names it.
import os

EMSCRIPTEN_ROOT = "/usr/share/emscripten"
LLVM_ROOT = "/usr/bin"
BINARYEN_ROOT = "/usr"
LLVM_ADD_VERSION = "14"
CLANG_ADD_VERSION = "14"
NODE_JS = ["/usr/bin/node", "--no-experimental-fetch"]
CACHE = os.environ.get("PCVT_EMSCRIPTEN_CACHE") or os.path.expanduser("~/.cache/pcvt/emscripten")

FROZEN_CACHE = False
