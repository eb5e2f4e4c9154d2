# SPDX-License-Identifier: GPL-3.0-or-later
# One place decides in which units a person reads forces, lengths, m, b and k (core/base/display_units.h). So nothing that is
# shown names a unit of its own: not ui/ and not what the sessions say. This reads them when CMake configures and stops at
# what does. "m" alone is not looked for: it is the mass, too.

set(_gripscope_unit "(N|kN|mN|mm|µm|kg|g|mg|N/m|kN/m|N/mm|N s/m|kN s/m|N/m³|N/mm³|lbf|kgf)")
set(_gripscope_unit_namers
  ui/format/shown_unit.cpp ui/format/channel_scale.cpp ui/format/number_format.cpp # what is read, and its multiples
  ui/profiles/profile_field_row.cpp ui/profiles/profile_dialog.cpp                 # what a gripper sends
  core/session/connection/gripper_port.h
  ui/pages/fit/fit_page_squeezes.cpp ui/pages/calibrate/calibrate_page.cpp)        # records that are made here, in SI

# Returns in OUT the lines of FILE (NAME within the tree) that name a unit, and nothing when all is well.
function(gripscope_unit_violations FILE NAME OUT)
  file(STRINGS "${FILE}" lines REGEX "\"" ENCODING UTF-8)
  set(found "")
  foreach(line IN LISTS lines)
    string(REPLACE ";" "" line "${line}") # it would part a list
    if(line MATCHES "^[ \t]*//" OR line MATCHES "^[ \t]*#" OR NAME IN_LIST _gripscope_unit_namers)
      continue()
    endif()
    string(REGEX REPLACE "//.*$" "" line "${line}")
    if(line MATCHES "\"[ ]?${_gripscope_unit}\"" OR line MATCHES "%L?[0-9]+ ${_gripscope_unit}([^a-zA-Z%]|$)" OR
       line MATCHES "\"[^\"]*\\(${_gripscope_unit}\\)")
      list(APPEND found "${NAME}: ${line}")
    endif()
  endforeach()
  set(${OUT} "${found}" PARENT_SCOPE)
endfunction()

function(gripscope_check_units)
  set(all "")
  file(GLOB_RECURSE files CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/ui/*.h" "${PROJECT_SOURCE_DIR}/ui/*.cpp"
    "${PROJECT_SOURCE_DIR}/core/session/*.h" "${PROJECT_SOURCE_DIR}/core/session/*.cpp")
  foreach(file IN LISTS files)
    file(RELATIVE_PATH name "${PROJECT_SOURCE_DIR}" "${file}")
    gripscope_unit_violations("${file}" "${name}" found)
    list(APPEND all ${found})
  endforeach()
  if(all)
    list(JOIN all "\n  " text)
    message(FATAL_ERROR "Units are chosen in core/base/display_units.h and shown by ui/format; these lines name one:\n  ${text}")
  endif()
endfunction()
