# SPDX-License-Identifier: BSD-3-Clause
# The window in other languages, included by gui. The target `translations` brings the .ts files up to
# date with the texts of the sources; what it adds to them is to be filled in, and a test finds what is
# not.
set(folder ${PROJECT_SOURCE_DIR}/resources/translations)
set(sheets ${folder}/angiomesh_de.ts ${folder}/angiomesh_tr.ts)
qt_add_lrelease(angiomesh_gui TS_FILES ${sheets} QM_FILES_OUTPUT_VARIABLE compiled)
qt_add_resources(angiomesh_gui angiomesh_translations PREFIX /translations
  BASE ${CMAKE_CURRENT_BINARY_DIR} FILES ${compiled})

# Titles and help of parameters and measures are rows of tables below gui, which know no Qt.
add_executable(table_texts ${folder}/table_texts.cpp)
angiomesh_options(table_texts)
target_link_libraries(table_texts PRIVATE angiomesh_io)
set(texts ${CMAKE_CURRENT_BINARY_DIR}/table_texts.h)
add_custom_command(OUTPUT ${texts} COMMAND table_texts ${texts} DEPENDS table_texts VERBATIM)
add_custom_target(table_texts_header ALL DEPENDS ${texts})

# lupdate's arguments: what to search, and how.
set(ANGIOMESH_TEXT_SEARCH ${PROJECT_SOURCE_DIR}/gui ${PROJECT_SOURCE_DIR}/app ${texts}
  -I ${PROJECT_SOURCE_DIR} -locations none -no-obsolete)
add_custom_target(translations COMMAND Qt6::lupdate ${ANGIOMESH_TEXT_SEARCH} -ts ${sheets}
  DEPENDS table_texts_header VERBATIM)
list(JOIN ANGIOMESH_TEXT_SEARCH "|" joined)
set_property(GLOBAL PROPERTY ANGIOMESH_TEXT_SEARCH ${joined})
