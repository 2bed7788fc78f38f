# Compiles the styles of src/SUSPENSION and src/SUSPENSION-ADVISER into LAMMPS, without touching the LAMMPS tree:
#   cmake -D CMAKE_PROJECT_lammps_INCLUDE=<this file> [options of LAMMPS] <lammps>/cmake
#
# The other way, as packages of the tree: copy both folders to <lammps>/src, add their names to the list
# STANDARD_PACKAGES, and configure LAMMPS with -D PKG_SUSPENSION=on -D PKG_SUSPENSION-ADVISER=on (ignored silently without
# the names in the list). SUSPENSION works without the other one, SUSPENSION-ADVISER needs both:
#   sed -i -e 's/^  TALLY$/  SUSPENSION\n  SUSPENSION-ADVISER\n  TALLY/' \
#     -e 's/^pkg_depends(RHEO BPM)$/&\npkg_depends(SUSPENSION-ADVISER SUSPENSION)/' <lammps>/cmake/CMakeLists.txt
# -D SUSPENSION_COMPILE_OPTIONS=... is added for our files only.
# With -march=native or the like add -ffp-contract=off to CMAKE_CXX_FLAGS, or a restart is exact to rounding only.

get_filename_component(SUSPENSION_DIR ${CMAKE_CURRENT_LIST_DIR}/../src/SUSPENSION ABSOLUTE)

# Right after project(lammps): our headers enter the lists from which LAMMPS generates style_pair.h and its like.
include(${CMAKE_CURRENT_SOURCE_DIR}/Modules/StyleHeaderUtils.cmake)
RegisterStyles(${SUSPENSION_DIR})
RegisterStyles(${SUSPENSION_DIR}-ADVISER)

# At the end of LAMMPS' CMakeLists.txt: our sources enter its target. The include folder is given only to the files
# which need it: a flag of the whole target would compile all of LAMMPS again.
function(suspension_add_sources)
  file(GLOB ours CONFIGURE_DEPENDS ${SUSPENSION_DIR}/[^.]*.cpp ${SUSPENSION_DIR}-ADVISER/[^.]*.cpp)
  target_sources(lammps PRIVATE ${ours})
  # as in our CMakeLists.txt
  set_property(SOURCE ${ours} APPEND PROPERTY COMPILE_OPTIONS -ffp-contract=off -fno-math-errno -fno-trapping-math
    ${SUSPENSION_COMPILE_OPTIONS})
  set_property(SOURCE ${ours} PROPERTY SKIP_PRECOMPILE_HEADERS ON)    # those are LAMMPS' own
  set_property(SOURCE ${ours} APPEND PROPERTY COMPILE_DEFINITIONS SUSPENSION_UNFUSED)
  # optional, for pair_style lubcontact ... voronoi; Debian: voro++-dev
  find_path(VOROPP_INCLUDE_DIR voro++/voro++.hh)
  find_library(VOROPP_LIBRARY voro++)
  if(VOROPP_INCLUDE_DIR AND VOROPP_LIBRARY)
    set(voronoi ${SUSPENSION_DIR}/radical_tessellation.cpp)
    set_property(SOURCE ${voronoi} APPEND PROPERTY COMPILE_DEFINITIONS SUSPENSION_VOROPP)
    set_property(SOURCE ${voronoi} APPEND PROPERTY INCLUDE_DIRECTORIES ${VOROPP_INCLUDE_DIR})
    target_link_libraries(lammps PRIVATE ${VOROPP_LIBRARY})
  endif()
  # optional, for fix pore/pressure and fix hydro; Debian: libfftw3-dev. LAMMPS' own FFTs may be others
  find_path(FFTW_INCLUDE_DIR fftw3.h)
  find_library(FFTW_LIBRARY fftw3)
  file(GLOB of_fftw ${SUSPENSION_DIR}/pore_*.cpp ${SUSPENSION_DIR}/fix_pore_*.cpp ${SUSPENSION_DIR}/fix_hydro_*.cpp)
  if(of_fftw AND FFTW_INCLUDE_DIR AND FFTW_LIBRARY)
    set_property(SOURCE ${of_fftw} APPEND PROPERTY COMPILE_DEFINITIONS SUSPENSION_FFTW)
    set_property(SOURCE ${of_fftw} APPEND PROPERTY INCLUDE_DIRECTORIES ${FFTW_INCLUDE_DIR})
    target_link_libraries(lammps PRIVATE ${FFTW_LIBRARY})
  endif()
  file(GLOB sources ${LAMMPS_SOURCE_DIR}/[^.]*.cpp)
  foreach(source ${sources})
    file(STRINGS ${source} includes_styles LIMIT_COUNT 1 REGEX "^#include \"style_")
    if(includes_styles)
      list(APPEND ours ${source})
    endif()
  endforeach()
  set_property(SOURCE ${ours} APPEND PROPERTY INCLUDE_DIRECTORIES ${SUSPENSION_DIR} ${SUSPENSION_DIR}-ADVISER)
endfunction()
cmake_language(DEFER CALL suspension_add_sources)
