# SPDX-License-Identifier: MIT
# make install: libraries with headers as the CMake package odas (odas::core, odas::odas) and for pkg-config
# (odas_core, odas), programs, array files, man pages and completions.
include(CMakePackageConfigHelpers)
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME development)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/odas)

# Two sets of targets: who asks for the core alone need not have the libraries of the rest.
set_target_properties(odas_core PROPERTIES EXPORT_NAME core)
install(TARGETS odas_core EXPORT odas_core)
install(EXPORT odas_core NAMESPACE odas:: FILE odasCoreTargets.cmake DESTINATION ${package_dir})
if(NOT ODAS_CORE_ONLY)
  install(TARGETS odas EXPORT odas)
  install(EXPORT odas NAMESPACE odas:: FILE odasTargets.cmake DESTINATION ${package_dir})
endif()
configure_package_config_file(cmake/odasConfig.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/odasConfig.cmake
  INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/odasConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/odasConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/odasConfigVersion.cmake
  DESTINATION ${package_dir})

# The libraries are archives, so what they need is linked with them: Requires, not Requires.private.
function(odas_install_pc library)
  cmake_parse_arguments(ODAS_PC "" "WHAT;REQUIRES;LIBS" "" ${ARGN})
  set(folder ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
  file(RELATIVE_PATH ODAS_PC_TO_PREFIX /${folder} /)
  configure_file(cmake/odas.pc.in ${CMAKE_CURRENT_BINARY_DIR}/${library}.pc @ONLY)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/${library}.pc DESTINATION ${folder})
endfunction()
odas_install_pc(odas_core WHAT "the algorithms, without input and output" REQUIRES "fftw3f samplerate libhwy")
if(NOT ODAS_CORE_ONLY)
  set(devices "")
  if(ODAS_WITH_ALSA)
    string(APPEND devices " alsa")
  endif()
  if(ODAS_WITH_PULSE)
    string(APPEND devices " libpulse")
  endif()
  if(ODAS_WITH_STUDIO)
    string(APPEND devices " openssl")
    if(ODAS_WITH_WEBHOOKS)
      string(APPEND devices " libcurl")
    endif()
  endif()
  odas_install_pc(odas WHAT "all of it" REQUIRES "odas_core libconfig++ sndfile fmt${devices}" LIBS -pthread)
endif()

# Headers that name the libraries of the inside stay inside; so does the Studio, which is a program's part.
set(public_rooms ${ODAS_ROOMS})
list(REMOVE_ITEM public_rooms studio)
foreach(room IN LISTS public_rooms)
  install(DIRECTORY src/odas/${room} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/odas
    FILES_MATCHING PATTERN "*.hpp" PATTERN "json_reader.hpp" EXCLUDE PATTERN "report" EXCLUDE)
endforeach()

set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME programs)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
if(ODAS_BUILD_APPS AND NOT ODAS_CORE_ONLY)
  install(TARGETS odas_app odaslive odasserver)
  install(DIRECTORY configs/ DESTINATION ${CMAKE_INSTALL_DATADIR}/odas/configs FILES_MATCHING PATTERN "*.cfg")
  install(DIRECTORY packaging/man/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 FILES_MATCHING PATTERN "*.1")
  foreach(program odas odaslive odasserver)
    install(FILES packaging/completions/odas.bash
      DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME ${program})
  endforeach()
  install(FILES packaging/completions/_odas DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions)
  install(FILES packaging/completions/odas.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
  # For packages alone: not within the prefix, and none of `make install`.
  install(FILES packaging/systemd/odas@.service DESTINATION /usr/lib/systemd/system
    COMPONENT system EXCLUDE_FROM_ALL)
  install(FILES packaging/debian/README DESTINATION /etc/odas COMPONENT system EXCLUDE_FROM_ALL)
  install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright COMPONENT system EXCLUDE_FROM_ALL)
endif()
