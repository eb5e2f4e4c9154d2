# SPDX-License-Identifier: GPL-3.0-or-later
# Qt's elidedText() cuts a text that is as wide as its room to the pixel. elided() (ui/theme/elided_text.h) does not. This
# reads ui/ and app/desktop when CMake configures and stops at what goes round that.

function(gripscope_check_elided_text)
  set(all "")
  file(GLOB_RECURSE files CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/ui/*.h" "${PROJECT_SOURCE_DIR}/ui/*.cpp"
    "${PROJECT_SOURCE_DIR}/app/desktop/*.cpp")
  list(REMOVE_ITEM files "${PROJECT_SOURCE_DIR}/ui/theme/elided_text.h")
  foreach(file IN LISTS files)
    file(STRINGS "${file}" lines REGEX "elidedText[ ]*\\(")
    if(lines)
      file(RELATIVE_PATH name "${PROJECT_SOURCE_DIR}" "${file}")
      list(APPEND all "${name}")
    endif()
  endforeach()
  if(all)
    list(JOIN all "\n  " text)
    message(FATAL_ERROR "Texts are cut by elided() (ui/theme/elided_text.h); here they are by elidedText():\n  ${text}")
  endif()
endfunction()
