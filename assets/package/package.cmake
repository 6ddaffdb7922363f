# What `cmake --install` and `cpack` put where: a package for Debian 12. tests/package.sh installs it in a bare system.
set(CMAKE_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE
  WORLD_READ WORLD_EXECUTE)
set(here ${PROJECT_SOURCE_DIR}/assets/package)
set(made ${PROJECT_BINARY_DIR}/package)

string(TIMESTAMP HW_RELEASE_DATE "%Y-%m-%d" UTC)
string(TIMESTAMP HW_CHANGELOG_DATE "%a, %d %b %Y %H:%M:%S +0000" UTC)
configure_file(${here}/changelog.in ${made}/changelog @ONLY)
configure_file(${here}/org.handwheel.handwheel.metainfo.xml.in ${made}/org.handwheel.handwheel.metainfo.xml @ONLY)

# The program writes these itself, from the tables of its command line.
install(CODE "
  set(program \"$<TARGET_FILE:handwheel>\")
  set(made \"${made}\")
  set(changes \"${PROJECT_SOURCE_DIR}/CHANGELOG.md\")
")
install(CODE [[
  foreach(pair IN ITEMS man=handwheel.1 bash=handwheel zsh=_handwheel fish=handwheel.fish)
    string(REPLACE "=" ";" pair ${pair})
    list(GET pair 0 form)
    list(GET pair 1 file)
    execute_process(COMMAND ${program} reference ${form} OUTPUT_FILE ${made}/${file} COMMAND_ERROR_IS_FATAL ANY)
  endforeach()
  execute_process(COMMAND gzip -9nf ${made}/handwheel.1 COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND gzip -9nkf ${made}/changelog COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND gzip -9nc ${changes} OUTPUT_FILE ${made}/CHANGELOG.md.gz COMMAND_ERROR_IS_FATAL ANY)
]])

install(TARGETS handwheel RUNTIME DESTINATION bin)
if(TARGET handwheel-watchdog)
  install(TARGETS handwheel-watchdog RUNTIME DESTINATION libexec/handwheel)
endif()
install(DIRECTORY assets/manual assets/examples assets/screenshots DESTINATION share/handwheel)
install(FILES assets/udev/70-handwheel.rules DESTINATION lib/udev/rules.d)
install(FILES ${here}/handwheel.desktop DESTINATION share/applications)
install(FILES ${here}/handwheel.svg DESTINATION share/icons/hicolor/scalable/apps)
install(FILES ${made}/org.handwheel.handwheel.metainfo.xml DESTINATION share/metainfo)
install(FILES ${made}/handwheel.1.gz DESTINATION share/man/man1)
install(FILES ${made}/handwheel DESTINATION share/bash-completion/completions)
install(FILES ${made}/_handwheel DESTINATION share/zsh/vendor-completions)
install(FILES ${made}/handwheel.fish DESTINATION share/fish/vendor_completions.d)
install(FILES ${made}/changelog.gz ${made}/CHANGELOG.md.gz ${here}/copyright DESTINATION share/doc/handwheel)
# What is inside the program and no package that it depends on.
foreach(part IN ITEMS fonts-inter fonts-jetbrains-mono libimgui-dev libcli11-dev libtomlplusplus-dev nlohmann-json3-dev
    libexpected-dev)
  install(FILES /usr/share/doc/${part}/copyright DESTINATION share/doc/handwheel/licenses RENAME ${part} OPTIONAL)
endforeach()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME handwheel)
set(CPACK_PACKAGE_VENDOR "The Handwheel authors")
set(CPACK_PACKAGE_CONTACT "The Handwheel authors <authors@handwheel.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "control console for motion controllers")
set(CPACK_PACKAGE_DESCRIPTION "One window to jog, home, program and set up a motion controller, real or
emulated: Velmex VXM, Arcus PMX-4EX-SA and DMX-K-SA, Oregon Micro Systems
VME58. Drawings (DXF) are cut, programs rehearsed before metal moves, and
scripts run without a window.")
set(CPACK_PACKAGE_CHECKSUM SHA256)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_SECTION electronics)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# GLFW looks for these while it runs: cursors, screens, raw motion.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libxcursor1, libxi6, libxinerama1, libxrandr2")
include(CPack)
