# SPDX-License-Identifier: GPL-3.0-or-later
# Names come from grippers, files and people, and Qt takes a text for markup wherever it looks like some. So labels are
# made by makeLabel(), which says that they are plain, and markup is written in the few files named here, which escape
# what is not their own. This reads ui/ and app/desktop when CMake configures and stops at what goes round that.

set(_gripscope_label_makers ui/widgets/controls.cpp)
set(_gripscope_markup_writers
  ui/widgets/plain_text.cpp                      # makeMarkedLabel()
  ui/reports/pdf_layout.cpp              # lays out reports, loads nothing
  ui/help/help_windows.h ui/help/manual_window.cpp) # the manual's own pages
set(_gripscope_bare_label "new QLabel\\(|[^a-zA-Z:]QLabel [a-zA-Z_]+([({]|$)")
set(_gripscope_markup "Qt::(RichText|AutoText|MarkdownText)|setHtml\\(|insertHtml\\(|appendHtml\\(|setMarkdown\\(|QStaticText|QGraphicsTextItem|(new|public) Q(TextBrowser|TextEdit)[^a-zA-Z]|QErrorMessage|setTitleText\\(|QMessageBox::(question|warning|information|critical|about)\\(")

# Returns in OUT the lines of FILE (NAME within the tree) that read texts as markup, and nothing when all is well.
function(gripscope_markup_violations FILE NAME OUT)
  file(STRINGS "${FILE}" lines REGEX "QLabel|Qt::[RAM]|[hH]tml|Markdown|QStaticText|QGraphicsText|QText|QErrorMessage|QMessageBox|setTitleText|setTextFormat")
  set(found "")
  set(boxes FALSE)
  set(saysPlain FALSE)
  foreach(line IN LISTS lines)
    string(REPLACE ";" "" line "${line}") # it would part a list
    if(line MATCHES "^[ \t]*(//|#[ \t]*include|class [a-zA-Z]*;?$)")
      continue()
    endif()
    if(line MATCHES "new QMessageBox")
      set(boxes TRUE)
    endif()
    if(line MATCHES "setTextFormat\\(Qt::PlainText\\)")
      set(saysPlain TRUE)
    endif()
    if(line MATCHES "${_gripscope_bare_label}" AND NOT NAME IN_LIST _gripscope_label_makers)
      list(APPEND found "${NAME}: a label that is not made by makeLabel():${line}")
    elseif(line MATCHES "${_gripscope_markup}" AND NOT NAME IN_LIST _gripscope_markup_writers)
      list(APPEND found "${NAME}: text that is read as markup:${line}")
    endif()
  endforeach()
  if(boxes AND NOT saysPlain)
    list(APPEND found "${NAME}: a message box without setTextFormat(Qt::PlainText)")
  endif()
  set(${OUT} "${found}" PARENT_SCOPE)
endfunction()

function(gripscope_check_plain_text)
  set(all "")
  file(GLOB_RECURSE files CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/ui/*.h" "${PROJECT_SOURCE_DIR}/ui/*.cpp"
    "${PROJECT_SOURCE_DIR}/app/desktop/*.cpp")
  foreach(file IN LISTS files)
    file(RELATIVE_PATH name "${PROJECT_SOURCE_DIR}" "${file}")
    gripscope_markup_violations("${file}" "${name}" found)
    list(APPEND all ${found})
  endforeach()
  if(all)
    list(JOIN all "\n  " text)
    message(FATAL_ERROR "Texts are plain (ui/widgets/plain_text.h); these are not:\n  ${text}")
  endif()
endfunction()
