# The faces of the look, found where Debian's fonts-inter and fonts-jetbrains-mono put them and carried inside
# the binary by the assembler (.incbin: no compile time), so that the program runs without the packages.
enable_language(ASM)
set(font_assembly "    .section .rodata\n")
foreach(face IN ITEMS
    "inter_regular=Inter-Regular.otf;Inter-Regular.ttf"
    "inter_medium=Inter-Medium.otf;Inter-Medium.ttf"
    "inter_semibold=Inter-SemiBold.otf;Inter-SemiBold.ttf"
    "mono_regular=JetBrainsMono-Regular.ttf")
  list(POP_FRONT face first)
  string(REPLACE "=" ";" first "${first}")
  list(GET first 0 symbol)
  list(GET first 1 file)
  find_file(HW_FONT_${symbol} NAMES ${file} ${face}
    PATHS /usr/share/fonts/opentype/inter /usr/share/fonts/truetype/inter /usr/share/fonts/truetype/jetbrains-mono
    NO_DEFAULT_PATH)
  if(NOT HW_FONT_${symbol})
    message(FATAL_ERROR "${file} not found: install fonts-inter and fonts-jetbrains-mono")
  endif()
  string(APPEND font_assembly
    "    .global hw_font_${symbol}\n    .global hw_font_${symbol}_end\n    .balign 16\n"
    "hw_font_${symbol}:\n    .incbin \"${HW_FONT_${symbol}}\"\nhw_font_${symbol}_end:\n    .byte 0\n")
endforeach()
string(APPEND font_assembly "    .section .note.GNU-stack,\"\",%progbits\n")
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/fonts_data.s CONTENT "${font_assembly}" @ONLY)
set_source_files_properties(${PROJECT_BINARY_DIR}/fonts_data.s PROPERTIES LANGUAGE ASM)
target_sources(hw_gui PRIVATE ${PROJECT_BINARY_DIR}/fonts_data.s)
