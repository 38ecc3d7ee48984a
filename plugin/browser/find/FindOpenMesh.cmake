# OpenMesh's core from its Debian source.
set(folder ${PCVT_SOURCES}/openmesh/src)
file(GLOB files CONFIGURE_DEPENDS
  ${folder}/OpenMesh/Core/Mesh/*.cc ${folder}/OpenMesh/Core/System/*.cc ${folder}/OpenMesh/Core/Utils/*.cc)
set(core ${folder}/OpenMesh/Core/IO)
add_library(OpenMeshCore STATIC ${files}
  ${core}/BinaryHelper.cc ${core}/IOManager.cc ${core}/OMFormat.cc
  ${core}/reader/BaseReader.cc ${core}/reader/OBJReader.cc ${core}/reader/OFFReader.cc
  ${core}/reader/OMReader.cc ${core}/reader/PLYReader.cc ${core}/reader/STLReader.cc
  ${core}/writer/BaseWriter.cc ${core}/writer/OBJWriter.cc ${core}/writer/OFFWriter.cc
  ${core}/writer/OMWriter.cc ${core}/writer/PLYWriter.cc ${core}/writer/STLWriter.cc
  ${core}/writer/VTKWriter.cc)
target_include_directories(OpenMeshCore SYSTEM PUBLIC ${folder})
target_compile_definitions(OpenMeshCore PUBLIC OM_STATIC_BUILD)
target_compile_options(OpenMeshCore PRIVATE -w -Os)
set(OpenMesh_FOUND TRUE)
