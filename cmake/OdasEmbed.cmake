# SPDX-License-Identifier: MIT
# odas_embed_text(TARGET HEADER FILES...): puts text files into the program, each as the std::string_view that
# HEADER declares in namespace odas: report.css -> kReportCss. They stay readable files in the tree.
function(odas_embed_text target header)
  foreach(file IN LISTS ARGN)
    get_filename_component(name ${file} NAME)
    set(out ${CMAKE_CURRENT_BINARY_DIR}/embedded/${name}.cpp)
    add_custom_command(OUTPUT ${out}
      COMMAND ${CMAKE_COMMAND} -DIN=${CMAKE_CURRENT_SOURCE_DIR}/${file} -DOUT=${out} -DHEADER=${header}
              -P ${PROJECT_SOURCE_DIR}/cmake/embed_text.cmake
      DEPENDS ${file} ${PROJECT_SOURCE_DIR}/cmake/embed_text.cmake
      COMMENT "Embedding ${name}" VERBATIM)
    target_sources(${target} PRIVATE ${out})
  endforeach()
endfunction()
