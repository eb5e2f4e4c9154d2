# SPDX-License-Identifier: GPL-3.0-or-later
# Several source files are compiled as one, in groups that change whenever a file comes or goes. A using-declaration of a
# source file's own then holds in those behind it as well: boost's quantile() once took the place of this program's, and
# ran for ever. So names are spelled out. (Aliases say what they are of, and clash where they differ.)

function(gripscope_check_unity)
  set(all "")
  foreach(layer app core devices ui)
    file(GLOB_RECURSE files CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/${layer}/*.cpp")
    foreach(file IN LISTS files)
      file(STRINGS "${file}" lines REGEX "^using [A-Za-z_:]+::[A-Za-z_]+;")
      if(lines)
        file(RELATIVE_PATH name "${PROJECT_SOURCE_DIR}" "${file}")
        string(REPLACE ";" "" lines "${lines}")
        list(APPEND all "${name}: ${lines}")
      endif()
    endforeach()
  endforeach()
  if(all)
    list(JOIN all "\n  " text)
    message(FATAL_ERROR "These hold in other source files too, once they are compiled as one; spell the names out:\n  ${text}")
  endif()
endfunction()
