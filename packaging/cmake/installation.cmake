# SPDX-License-Identifier: GPL-3.0-or-later
# What `cmake --install` puts where. The programs carry the manual, the translations and the paper's tables inside and look
# for nothing of their own on the disk, so that they run from any prefix.
include(GNUInstallDirs)
set(CMAKE_INSTALL_DOCDIR "${CMAKE_INSTALL_DATAROOTDIR}/doc/gripscope")

set(programs gripscope-cli)
if(TARGET gripscope-virtual-gripper)
  list(APPEND programs gripscope-virtual-gripper)
endif()
if(TARGET gripscope-station)
  list(APPEND programs gripscope-station)
endif()
if(TARGET gripscope)
  list(APPEND programs gripscope)
endif()
install(TARGETS ${programs})

# A program's own help makes its manual page, so that the page cannot lag behind; hence when it is installed.
foreach(program IN LISTS programs)
  set(page "${PROJECT_BINARY_DIR}/man/${program}.1")
  install(CODE "file(MAKE_DIRECTORY \"${PROJECT_BINARY_DIR}/man\")
    execute_process(COMMAND \"${PROJECT_SOURCE_DIR}/packaging/man/man_page.sh\" \"$<TARGET_FILE:${program}>\"
      OUTPUT_FILE \"${page}\" COMMAND_ERROR_IS_FATAL ANY)")
  install(FILES "${page}" DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
endforeach()

if(TARGET gripscope)
  install(FILES packaging/desktop/org.gripscope.gripscope.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
  install(FILES packaging/desktop/org.gripscope.gripscope.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo)
  install(FILES packaging/desktop/org.gripscope.gripscope.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages)
  install(FILES resources/icons/org.gripscope.gripscope.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
endif()
# Read where there is no window, and by search engines.
install(DIRECTORY resources/manual DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES devices/PROTOCOL.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY resources/profiles DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples)
if(TARGET gripscope-station)
  install(FILES packaging/systemd/gripscope-station.service DESTINATION lib/systemd/system)
endif()
# Not CMAKE_INSTALL_LIBDIR: udev looks into lib whatever the architecture.
install(FILES packaging/70-gripscope.rules DESTINATION lib/udev/rules.d)
