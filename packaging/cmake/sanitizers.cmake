# SPDX-License-Identifier: GPL-3.0-or-later
# What GRIPSCOPE_SANITIZE says. GCC's own warnings about bounds and uninitialised values err under its sanitizers: those builds
# leave warnings alone, and take -O1, which compiles the templates of the numerics in half the time.

set(gripscope_sanitizer_options -fsanitize=${GRIPSCOPE_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all -O1 -g1 -Wno-error)
# Null pointers and sizes are the address sanitizer's, too; alignment is looked at where the fuzzers feed the parsers.
# At every access of the numerics these three took half of the time.
if(GRIPSCOPE_SANITIZE MATCHES "address" AND NOT GRIPSCOPE_FUZZ)
  list(APPEND gripscope_sanitizer_options -fno-sanitize=null,alignment,object-size)
endif()

# gripscope_sanitize(): the folders that are added from here on.
macro(gripscope_sanitize)
  add_compile_options(${gripscope_sanitizer_options})
  # An empty optional that is read, which the sanitizers see only where it hits foreign memory.
  add_compile_definitions(_GLIBCXX_ASSERTIONS)
  add_link_options(-fsanitize=${GRIPSCOPE_SANITIZE})
endmacro()

# gripscope_shared_by_threads(SOURCE...): sources of core that threads of devices share. The thread sanitizer watches these and
# devices; the rest of core, which knows no threads, is then compiled as everywhere, and found in the compiler's cache. In
# every build they stand outside the joined sources, so that those are the same everywhere.
function(gripscope_shared_by_threads)
  set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  if(GRIPSCOPE_SANITIZE STREQUAL "thread")
    set_source_files_properties(${ARGN} PROPERTIES COMPILE_OPTIONS "${gripscope_sanitizer_options}"
      SKIP_PRECOMPILE_HEADERS ON)
  endif()
endfunction()
