# SPDX-License-Identifier: MIT
# make deb: the Debian packages odas (programs, arrays, service) and libodas-dev (libraries and headers).
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME odas)
set(CPACK_PACKAGE_CONTACT "The odas developers <odas@localhost>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_OUTPUT_FILE_PREFIX ${PROJECT_BINARY_DIR}/packages)
set(CPACK_COMPONENTS_ALL programs system development)
set(CPACK_COMPONENT_PROGRAMS_GROUP programs)
set(CPACK_COMPONENT_SYSTEM_GROUP programs)
set(CPACK_COMPONENT_DEVELOPMENT_GROUP development)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
if(CMAKE_CROSSCOMPILING)
  set(CPACK_DEBIAN_PACKAGE_ARCHITECTURE arm64)
endif()

set(CPACK_DEBIAN_PROGRAMS_PACKAGE_NAME odas)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SECTION sound)
set(CPACK_DEBIAN_PROGRAMS_DESCRIPTION "Says in real time where the sounds come from that a microphone array hears,
follows each source, and hands out each source's sound on its own. Reads the
configuration files of ODAS, and takes its place.")
file(WRITE ${PROJECT_BINARY_DIR}/package/conffiles "/etc/odas/README\n")
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_CONTROL_EXTRA ${PROJECT_BINARY_DIR}/package/conffiles
  ${PROJECT_SOURCE_DIR}/packaging/debian/postinst ${PROJECT_SOURCE_DIR}/packaging/debian/prerm
  ${PROJECT_SOURCE_DIR}/packaging/debian/postrm)

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libodas-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "Headers and static libraries: odas_core, the algorithms alone, and odas, all of it.")
# What the CMake and pkg-config files ask for.
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
  "libfftw3-dev, libsamplerate0-dev, libhwy-dev, libconfig++-dev, libsndfile1-dev, libfmt-dev, libasound2-dev, libpulse-dev, libssl-dev, libcurl4-openssl-dev")
include(CPack)
