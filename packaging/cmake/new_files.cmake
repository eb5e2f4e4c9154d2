# SPDX-License-Identifier: GPL-3.0-or-later

# CMake 3.25 knows from moc's last run which files moc depends on, so a file added since is never looked into,
# and its .moc never made. When the list of sources changes, this forgets that run.
# gripscope_notice_new_files(TARGET FILE...)
function(gripscope_notice_new_files target)
  set(record "${CMAKE_CURRENT_BINARY_DIR}/${target}_sources.txt")
  set(known "")
  if(EXISTS "${record}")
    file(READ "${record}" known)
  endif()
  list(JOIN ARGN "\n" sources)
  if(NOT known STREQUAL sources)
    file(REMOVE "${CMAKE_CURRENT_BINARY_DIR}/${target}_autogen/timestamp")
    file(WRITE "${record}" "${sources}")
  endif()
endfunction()
