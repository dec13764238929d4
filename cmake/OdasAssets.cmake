# SPDX-License-Identifier: MIT
# odas_embed_assets(TARGET FOLDER): puts all files of a folder into the program, plain and compressed, as
# odas/studio/assets.hpp declares them. The assembler reads the files; the compiler sees only their names.
function(odas_embed_assets target folder)
  file(GLOB_RECURSE files CONFIGURE_DEPENDS RELATIVE ${folder} ${folder}/*)
  list(SORT files)
  set(out ${CMAKE_CURRENT_BINARY_DIR}/assets)
  set(depends)
  foreach(file IN LISTS files)
    list(APPEND depends ${folder}/${file})
  endforeach()
  list(JOIN files "|" names)
  add_custom_command(OUTPUT ${out}/assets.cpp
    COMMAND ${CMAKE_COMMAND} -DFOLDER=${folder} -DOUT=${out} "-DNAMES=${names}"
            -P ${PROJECT_SOURCE_DIR}/cmake/embed_assets.cmake
    DEPENDS ${depends} ${PROJECT_SOURCE_DIR}/cmake/embed_assets.cmake
    COMMENT "Embedding the page of the Studio" VERBATIM)
  target_sources(${target} PRIVATE ${out}/assets.cpp)
endfunction()
