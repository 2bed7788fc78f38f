# Compiles LAMMPS itself in less than half the time:
#   cmake -D CMAKE_PROJECT_lammps_INCLUDE_BEFORE=<this file> <lammps>/cmake
# With ccache: CMAKE_CXX_FLAGS=-fpch-preprocess and CCACHE_SLOPPINESS=pch_defines,time_macros.

function(lammps_quick)
  # precompiled headers
  set(headers <cmath> <cstring> <string> <vector> <map> <algorithm>)
  foreach(header pointers atom error modify domain comm)
    list(APPEND headers "$<$<COMPILE_LANGUAGE:CXX>:${LAMMPS_SOURCE_DIR}/${header}.h>")
  endforeach()
  target_precompile_headers(lammps PRIVATE ${headers})

  # Commands, computes, dumps and most fixes run now and then: little optimization does for them. What takes the time of
  # a step keeps all of it: pairs, bonds, neighbor lists, communication, integration.
  get_target_property(sources lammps SOURCES)
  list(FILTER sources INCLUDE REGEX "\\.cpp$")
  list(FILTER sources EXCLUDE REGEX
    "/(atom|bond|angle|comm|dihedral|domain|fix_neigh|fix_nve|fix_nh|fix_wall|gran_|granular|improper|integrate|math|min|my_|nbin|neigh|npair|nstencil|ntopo|pair|random|respa|verlet)[a-zA-Z_0-9]*\\.cpp$")
  set_property(SOURCE ${sources} APPEND PROPERTY COMPILE_OPTIONS -O1)
endfunction()
cmake_language(DEFER CALL lammps_quick)    # at the end of LAMMPS' CMakeLists.txt, when its target exists
