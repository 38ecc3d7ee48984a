# The Debian packages that `cmake --build BUILD --target package` makes: pcvt (the command and libpcvt), pcvt-dev and
# python3-pcvt, which holds the Blender add-on as well.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "The pcvt authors <pcvt@localhost>")
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL runtime dev python)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(same_version "pcvt (= ${PROJECT_VERSION})")

set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME pcvt)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION math)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SHLIBDEPS ON)
set(CPACK_COMPONENT_RUNTIME_DESCRIPTION
  "The command pcvt and the library libpcvt make meshes of the plane and of space that repeat without a seam.")

set(CPACK_DEBIAN_DEV_PACKAGE_NAME pcvt-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "${same_version}, libeigen3-dev, libmuparser-dev, \
libopenmesh-dev, libpng-dev, libtinygltf-dev, libyaml-cpp-dev, zlib1g-dev")
set(CPACK_COMPONENT_DEV_DESCRIPTION
  "Headers, static libraries, CMake package and pkg-config file of pcvt.")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-pcvt)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "${same_version}, python3, python3-numpy")
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS python3-matplotlib)
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_LIST_DIR}/python3-pcvt/prerm)
set(CPACK_COMPONENT_PYTHON_DESCRIPTION
  "The Python package pcvt, and the add-on pcvt_tile.zip for Blender.")
include(CPack)
