# SPDX-License-Identifier: GPL-3.0-or-later
# Dependencies point one way: app -> ui -> devices -> core. This reads every #include of the tree when CMake
# configures and stops at the first one that points the other way or reaches for a library its layer must not see.

set(_gripscope_widgets "Q(Application|Widget|MainWindow|Dialog|PushButton|Label|Painter|Pixmap|Icon|Font|Color|Image|Window)[>\"]|QtWidgets|QtGui|QtCharts|QtOpenGL|QOpenGL")
set(_gripscope_forbidden_core    "(\"|<)(devices|ui|app)/|<vtk|hidapi|QtConcurrent|${_gripscope_widgets}")
set(_gripscope_forbidden_devices "(\"|<)(ui|app)/|<vtk|<QtSql|<QSql|${_gripscope_widgets}")
set(_gripscope_forbidden_ui      "(\"|<)app/|hidapi|<QtSql|<QSql")
set(_gripscope_forbidden_app     "hidapi|<QtSql|<QSql|<vtk")

# Returns in OUT the includes of FILE that LAYER must not have, and nothing when all is well.
function(gripscope_layer_violations LAYER FILE OUT)
  file(STRINGS "${FILE}" includes REGEX "^[ \t]*#[ \t]*include")
  set(found "")
  foreach(line IN LISTS includes)
    if(line MATCHES "${_gripscope_forbidden_${LAYER}}")
      list(APPEND found "${FILE}: ${line}")
    elseif(LAYER STREQUAL "core" AND line MATCHES "<QtSql|<QSql" AND NOT FILE MATCHES "/core/store/")
      list(APPEND found "${FILE}: ${line} (SQL belongs in core/store)")
    endif()
  endforeach()
  set(${OUT} "${found}" PARENT_SCOPE)
endfunction()

function(gripscope_check_layers)
  set(all "")
  foreach(layer core devices ui app)
    file(GLOB_RECURSE files CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/${layer}/*.h" "${PROJECT_SOURCE_DIR}/${layer}/*.cpp")
    foreach(file IN LISTS files)
      gripscope_layer_violations(${layer} "${file}" found)
      list(APPEND all ${found})
    endforeach()
  endforeach()
  if(all)
    list(JOIN all "\n  " text)
    message(FATAL_ERROR "Dependencies run app -> ui -> devices -> core; these point the other way:\n  ${text}")
  endif()
endfunction()
