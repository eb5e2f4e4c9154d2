# SPDX-License-Identifier: GPL-3.0-or-later

# gripscope_quicken_moc(FOLDER): all targets of the folder and of those in it start moc.sh in place of moc; see there.
function(gripscope_quicken_moc folder)
  get_target_property(GRIPSCOPE_MOC Qt6::moc LOCATION)
  set(script "${PROJECT_BINARY_DIR}/moc.sh")
  configure_file("${PROJECT_SOURCE_DIR}/packaging/cmake/moc.sh.in" "${script}" @ONLY FILE_PERMISSIONS
                 OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
  get_property(targets DIRECTORY "${folder}" PROPERTY BUILDSYSTEM_TARGETS)
  set_property(TARGET ${targets} PROPERTY AUTOMOC_EXECUTABLE "${script}")
  get_property(folders DIRECTORY "${folder}" PROPERTY SUBDIRECTORIES)
  foreach(inner IN LISTS folders)
    gripscope_quicken_moc("${inner}")
  endforeach()
endfunction()
