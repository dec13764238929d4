# SPDX-License-Identifier: MIT
# What the libraries are made with; the reasons are in docs/decisions.md.
find_package(PkgConfig REQUIRED)
pkg_check_modules(ODAS_FFTW REQUIRED IMPORTED_TARGET fftw3f)
pkg_check_modules(ODAS_HWY REQUIRED IMPORTED_TARGET libhwy)
if(NOT ODAS_CORE_ONLY)
  pkg_check_modules(ODAS_CONFIGPP REQUIRED IMPORTED_TARGET libconfig++)
  pkg_check_modules(ODAS_SNDFILE REQUIRED IMPORTED_TARGET sndfile)
  pkg_check_modules(ODAS_SAMPLERATE REQUIRED IMPORTED_TARGET samplerate)
  find_package(nlohmann_json REQUIRED)
  find_package(fmt REQUIRED)
  find_package(Threads REQUIRED)
endif()
