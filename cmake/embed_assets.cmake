# SPDX-License-Identifier: MIT
# cmake -DFOLDER=web/dist -DOUT=DIR -DNAMES=a|b/c -P embed_assets.cmake: writes DIR/assets.cpp
set(type_html "text/html; charset=utf-8")
set(type_js "text/javascript; charset=utf-8")
set(type_css "text/css; charset=utf-8")
set(type_txt "text/plain; charset=utf-8")
set(type_json "application/json")
set(type_svg "image/svg+xml")
set(type_png "image/png")
string(REPLACE "|" ";" names "${NAMES}")
set(code "")
set(table "")
set(number 0)
foreach(name IN LISTS names)
  set(file ${FOLDER}/${name})
  set(packed ${OUT}/${number}.gz)
  file(MAKE_DIRECTORY ${OUT})
  execute_process(COMMAND gzip -9nc ${file} OUTPUT_FILE ${packed} COMMAND_ERROR_IS_FATAL ANY)
  get_filename_component(extension ${name} LAST_EXT)
  string(SUBSTRING "${extension}" 1 -1 extension)
  if(NOT DEFINED type_${extension})
    message(FATAL_ERROR "${name}: no content type is known for .${extension}; add it to cmake/embed_assets.cmake")
  endif()
  file(SHA256 ${file} hash)
  string(SUBSTRING ${hash} 0 16 hash)
  foreach(part plain gzip)
    set(path ${file})
    if(part STREQUAL gzip)
      set(path ${packed})
    endif()
    string(APPEND code
      "__asm__(\".section .rodata\\n.balign 16\\n\"\n"
      "        \"odas_asset_${number}_${part}:\\n.incbin \\\"${path}\\\"\\n\"\n"
      "        \"odas_asset_${number}_${part}_end:\\n.byte 0\\n.previous\\n\");\n"
      "extern const char odas_asset_${number}_${part}[], odas_asset_${number}_${part}_end[];\n")
  endforeach()
  string(APPEND table
    "      Asset{\"/${name}\", \"${type_${extension}}\", \"\\\"${hash}\\\"\",\n"
    "            bytes(odas_asset_${number}_plain, odas_asset_${number}_plain_end),\n"
    "            bytes(odas_asset_${number}_gzip, odas_asset_${number}_gzip_end)},\n")
  math(EXPR number "${number} + 1")
endforeach()
file(WRITE ${OUT}/assets.cpp "// Made by cmake/embed_assets.cmake.
#include \"odas/studio/assets.hpp\"

#include <array>

extern \"C\" {
${code}}

namespace odas {
namespace {

std::string_view bytes(const char* begin, const char* end) noexcept {
  return {begin, static_cast<std::size_t>(end - begin)};
}

}  // namespace

std::span<const Asset> assets() noexcept {
  static const std::array<Asset, ${number}> table{
${table}  };
  return table;
}

}  // namespace odas
")
