# SPDX-License-Identifier: MIT
# cmake -DIN=page.css -DOUT=page.css.cpp -DHEADER=odas/io/assets.hpp -P embed_text.cmake
file(READ ${IN} text)
get_filename_component(name ${IN} NAME)
string(REGEX MATCHALL "[A-Za-z0-9]+" words ${name})
set(symbol k)
foreach(word IN LISTS words)
  string(SUBSTRING ${word} 0 1 first)
  string(SUBSTRING ${word} 1 -1 rest)
  string(TOUPPER ${first} first)
  string(APPEND symbol ${first}${rest})
endforeach()
file(WRITE ${OUT} "#include \"${HEADER}\"\n\nnamespace odas {\n"
  "const std::string_view ${symbol} = R\"~embedded~(${text})~embedded~\";\n}\n")
