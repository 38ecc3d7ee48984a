# zlib from its Debian source, so that compressed bytes equal the native ones.
set(folder ${PCVT_SOURCES}/zlib)
add_library(z STATIC
  ${folder}/adler32.c ${folder}/compress.c ${folder}/crc32.c ${folder}/deflate.c ${folder}/inffast.c
  ${folder}/inflate.c ${folder}/inftrees.c ${folder}/trees.c ${folder}/uncompr.c ${folder}/zutil.c)
target_include_directories(z SYSTEM PUBLIC ${folder})
target_compile_options(z PRIVATE -w)
add_library(ZLIB::ZLIB ALIAS z)
set(ZLIB_FOUND TRUE)
