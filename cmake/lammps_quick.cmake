# Precompiled headers for LAMMPS itself: its compilation takes a bit more than half the time.
#   cmake -D CMAKE_PROJECT_lammps_INCLUDE_BEFORE=<this file> <lammps>/cmake
# With ccache: CMAKE_CXX_FLAGS=-fpch-preprocess and CCACHE_SLOPPINESS=pch_defines,time_macros.

function(lammps_pch)
  set(headers <cmath> <cstring> <string> <vector> <map> <algorithm>)
  foreach(header pointers atom error modify domain comm)
    list(APPEND headers "$<$<COMPILE_LANGUAGE:CXX>:${LAMMPS_SOURCE_DIR}/${header}.h>")
  endforeach()
  target_precompile_headers(lammps PRIVATE ${headers})
endfunction()
cmake_language(DEFER CALL lammps_pch)    # at the end of LAMMPS' CMakeLists.txt, when its target exists
