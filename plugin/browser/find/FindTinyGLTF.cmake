# The structures of tinygltf's header; pcvt reads and writes the files by itself.
pcvt_link_headers(nlohmann tiny_gltf.h)
add_library(TinyGLTF::TinyGLTF INTERFACE IMPORTED)
target_include_directories(TinyGLTF::TinyGLTF SYSTEM INTERFACE ${PCVT_SYSTEM_HEADERS})
target_compile_definitions(TinyGLTF::TinyGLTF INTERFACE
  TINYGLTF_NO_STB_IMAGE TINYGLTF_NO_STB_IMAGE_WRITE)
set(TinyGLTF_FOUND TRUE)
