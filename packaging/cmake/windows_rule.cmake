# SPDX-License-Identifier: GPL-3.0-or-later
# STOP has to work whatever is open, so no window may keep presses from another: nothing is modal, nothing runs a
# loop of its own, and every dialog comes from ui/windows (see dialog.h), where it gets its STOP. This reads the
# sources when CMake configures, and stops at a dialog or menu that is made in another way, and at a class of
# dialogs that has no row in the table from which the test of STOP takes them.

set(_gripscope_window_dialogs "(Dialog|MessageBox|FileDialog|InputDialog|ProgressDialog|ColorDialog|FontDialog|ErrorMessage|PrintDialog|PrintPreviewDialog|Wizard)")
set(_gripscope_windows_forbidden
  "new[ \t]+Q${_gripscope_window_dialogs}[^A-Za-z]"        # made past the base class
  "Q${_gripscope_window_dialogs}[ \t]+[a-z][A-Za-z]*[ \t]*[({;]" # on the stack: only for a loop of its own
  "public[ \t]+Q${_gripscope_window_dialogs}[^A-Za-z]"
  "QMessageBox::(question|information|warning|critical|about)"
  "QFileDialog::get|QInputDialog::get|QColorDialog::get|QFontDialog::get"
  "(->|\\.)exec[ \t]*\\("                                  # of a dialog, a menu or a drag
  "QMenu::exec"
  "setModal[ \t]*\\(|setWindowModality|WA_ShowModal|ApplicationModal|WindowModal"
  "Key_Escape|StandardKey::Cancel|QKeySequence::Cancel")   # a shortcut would keep Esc from Stop

# Returns in OUT what FILE does that only ui/windows may.
function(gripscope_window_violations FILE OUT)
  set(found "")
  foreach(pattern IN LISTS _gripscope_windows_forbidden)
    file(STRINGS "${FILE}" lines REGEX "${pattern}")
    foreach(line IN LISTS lines)
      if(NOT line MATCHES "^[ \t]*//" AND NOT line MATCHES "loop\\.exec") # a plain event loop shows nothing
        list(APPEND found "${FILE}: ${line}")
      endif()
    endforeach()
  endforeach()
  set(${OUT} "${found}" PARENT_SCOPE)
endfunction()

function(gripscope_check_windows)
  file(GLOB_RECURSE files CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/ui/*.h" "${PROJECT_SOURCE_DIR}/ui/*.cpp"
    "${PROJECT_SOURCE_DIR}/app/desktop/*.cpp")
  set(all "")
  set(classes "")
  set(rows "")
  foreach(file IN LISTS files)
    if(NOT file MATCHES "/ui/windows/")
      gripscope_window_violations("${file}" found)
      list(APPEND all ${found})
    endif()
    file(STRINGS "${file}" lines REGEX "(:[ \t]*public[ \t]+(Dialog|QFileDialog)[^A-Za-z]|RegisteredDialog<)")
    foreach(line IN LISTS lines)
      if(line MATCHES "class[ \t]+([A-Za-z]+)[ \t]*(final)?[ \t]*:[ \t]*public")
        list(APPEND classes ${CMAKE_MATCH_1})
      elseif(line MATCHES "RegisteredDialog<([A-Za-z]+)>")
        list(APPEND rows ${CMAKE_MATCH_1})
      endif()
    endforeach()
  endforeach()
  foreach(class IN LISTS classes)
    if(NOT class IN_LIST rows)
      list(APPEND all "${class} is a dialog without a row in the table: put a RegisteredDialog<${class}> beside it")
    endif()
  endforeach()
  if(all)
    list(JOIN all "\n  " text)
    message(FATAL_ERROR "STOP has to work over every window (packaging/cmake/windows_rule.cmake):\n  ${text}")
  endif()
endfunction()
