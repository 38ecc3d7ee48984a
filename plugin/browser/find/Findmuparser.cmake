# muParser from its Debian source.
set(folder ${PCVT_SOURCES}/muparser)
add_library(muparser STATIC
  ${folder}/src/muParser.cpp
  ${folder}/src/muParserBase.cpp
  ${folder}/src/muParserBytecode.cpp
  ${folder}/src/muParserCallback.cpp
  ${folder}/src/muParserError.cpp
  ${folder}/src/muParserTokenReader.cpp
)
target_include_directories(muparser SYSTEM PUBLIC ${folder}/include)
target_compile_definitions(muparser PUBLIC MUPARSER_STATIC)
# It only parses formulas.
target_compile_options(muparser PRIVATE -w -ffp-contract=off -Os)
add_library(muparser::muparser ALIAS muparser)
set(muparser_FOUND TRUE)
