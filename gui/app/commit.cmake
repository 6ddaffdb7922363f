# Run at each build: writes HEADER anew when the commit has changed, so that only version.cpp is compiled.
#   cmake -DSOURCE=... -DHEADER=... -P commit.cmake
set(commit "")
find_program(git git)
if(git)
  # A tree without git that lies in the folders of another one is not of its commit.
  get_filename_component(parent ${SOURCE} DIRECTORY)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env GIT_CEILING_DIRECTORIES=${parent} ${git} -C ${SOURCE} describe --always --dirty=,\ changed --exclude=* --abbrev=12
    OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()
set(text "#define HW_COMMIT \"${commit}\"\n")
set(before "")
if(EXISTS ${HEADER})
  file(READ ${HEADER} before)
endif()
if(NOT text STREQUAL before)
  file(WRITE ${HEADER} "${text}")
endif()
