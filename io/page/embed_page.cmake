# cmake -D OUTPUT=FILE.cpp -D FOLDER=DIR -P embed_page.cmake: writes a source file that holds the
# page's sources as the strings of page_parts.hpp.
set(scripts tile.js colours.js painter.js svg.js hover.js page.js controls.js)

set(text "// Made by embed_page.cmake.\n#include \"io/page/page_parts.hpp\"\n\nnamespace pcvt {\n\n")
# Appends a literal of one part a file.
function(append_literal name)
  set(literal "")
  foreach(file ${ARGN})
    file(READ "${FOLDER}/${file}" content)
    string(APPEND literal "\n    R\"page(${content})page\"")
  endforeach()
  set(text "${text}const std::string_view ${name} =${literal};\n\n" PARENT_SCOPE)
endfunction()
append_literal(kPageHtml page.html)
append_literal(kPageStyle page.css)
append_literal(kPageScript ${scripts})
append_literal(kStudyHtml study.html)
append_literal(kStudyStyle study.css)
append_literal(kStudyScript study.js)
file(WRITE "${OUTPUT}" "${text}}  // namespace pcvt\n")
