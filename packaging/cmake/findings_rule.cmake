# SPDX-License-Identifier: GPL-3.0-or-later
# What the numerics have to say are values (core/base/finding.h), worded where a person reads them: these rooms of core
# ask for no translation and no locale. This reads them when CMake configures and stops at what does.

set(_gripscope_rooms_of_findings signal identification calibration recognition clustering quality research math)
set(_gripscope_language "[^a-zA-Z_]tr\\(|translate\\(|QLocale\\(\\)|QLocale::system|QLocale [a-z]+;|\\.describe\\(\\)")

# Returns in OUT the lines of FILE (NAME within the tree) that depend on a language, and nothing when all is well.
function(gripscope_language_violations FILE NAME OUT)
  file(STRINGS "${FILE}" lines REGEX "tr\\(|translate|QLocale|describe\\(")
  set(found "")
  foreach(line IN LISTS lines)
    string(REPLACE ";" "" line "${line}") # it would part a list
    if(line MATCHES "^[ \t]*//" OR NOT line MATCHES "${_gripscope_language}")
      continue()
    endif()
    list(APPEND found "${NAME}: ${line}")
  endforeach()
  set(${OUT} "${found}" PARENT_SCOPE)
endfunction()

function(gripscope_check_findings)
  set(all "")
  foreach(room IN LISTS _gripscope_rooms_of_findings)
    file(GLOB_RECURSE files CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/core/${room}/*.h" "${PROJECT_SOURCE_DIR}/core/${room}/*.cpp")
    foreach(file IN LISTS files)
      file(RELATIVE_PATH name "${PROJECT_SOURCE_DIR}" "${file}")
      gripscope_language_violations("${file}" "${name}" found)
      list(APPEND all ${found})
    endforeach()
  endforeach()
  if(all)
    list(JOIN all "\n  " text)
    message(FATAL_ERROR "The numerics speak no language (core/base/finding.h); these lines do:\n  ${text}")
  endif()
endfunction()
