# libshabon: one shared library from all rooms, and the same library once more for each wider kind of x86-64. The C
# library's loader picks the widest that the machine runs from glibc-hwcaps/ beside it (docs/decisions/0001).
include(CMakePackageConfigHelpers)

set(SHABON_SOVERSION 0)
file(RELATIVE_PATH SHABON_BIN_TO_LIB ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
set(CMAKE_INSTALL_RPATH "$ORIGIN/${SHABON_BIN_TO_LIB}")  # of the programs; the library sits beside none of its own
set(CMAKE_INSTALL_RPATH_USE_LINK_PATH ON)
set(CMAKE_BUILD_RPATH_USE_ORIGIN ON)
if(SHABON_BIN_TO_LIB STREQUAL "../lib")  # the build folder is laid out alike: no second path, none to replace
  set(CMAKE_BUILD_WITH_INSTALL_RPATH ON)
endif()

# shabon_link_library(TARGET SUFFIX): a shared library of every room that has sources, in the variant SUFFIX where a
# room has variants.
function(shabon_link_library target suffix)
  set(objects "")
  set(packages "")
  foreach(room IN LISTS SHABON_ROOM_NAMES)
    set(part shabon_${room}${suffix})
    if(NOT TARGET ${part})
      set(part shabon_${room})
    endif()
    if(NOT TARGET ${part})
      continue()
    endif()
    get_target_property(type ${part} TYPE)
    if(NOT type STREQUAL "INTERFACE_LIBRARY")
      list(APPEND objects $<TARGET_OBJECTS:${part}>)
      if(TARGET shabon_${room}_common)
        list(APPEND objects $<TARGET_OBJECTS:shabon_${room}_common>)
      endif()
      get_target_property(needs ${part} SHABON_PACKAGES)
      list(APPEND packages ${needs})
    endif()
  endforeach()
  list(REMOVE_DUPLICATES packages)
  add_library(${target} SHARED ${objects})
  target_link_libraries(${target} PRIVATE shabon_flags ${packages})
  set(symbols ${PROJECT_SOURCE_DIR}/cmake/shabon.map)
  target_link_options(${target} PRIVATE LINKER:--version-script=${symbols} LINKER:-Bsymbolic-functions)
  if(NOT SHABON_SANITIZE)  # whose own names come from the program
    target_link_options(${target} PRIVATE LINKER:-z,defs)
  endif()
  set_target_properties(${target} PROPERTIES
    OUTPUT_NAME shabon VERSION ${PROJECT_VERSION} SOVERSION ${SHABON_SOVERSION} LINKER_LANGUAGE CXX
    LINK_DEPENDS ${symbols} INSTALL_RPATH "")
endfunction()

shabon_link_library(libshabon "")
target_include_directories(libshabon INTERFACE
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
target_compile_features(libshabon INTERFACE cxx_std_20)
set_target_properties(libshabon PROPERTIES EXPORT_NAME shabon)
add_library(shabon::shabon ALIAS libshabon)

shabon_remove_stale_variants(${CMAKE_LIBRARY_OUTPUT_DIRECTORY})
foreach(level IN LISTS SHABON_WIDE_LEVELS)
  shabon_link_library(libshabon_${level} _${level})
  set_target_properties(libshabon_${level} PROPERTIES
    LIBRARY_OUTPUT_DIRECTORY ${CMAKE_LIBRARY_OUTPUT_DIRECTORY}/${SHABON_HWCAPS}${level})
  add_dependencies(libshabon libshabon_${level})  # whoever runs with one may run with the other
  install(TARGETS libshabon_${level}
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/${SHABON_HWCAPS}${level} NAMELINK_SKIP)
endforeach()

install(TARGETS libshabon EXPORT shabon LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT shabon NAMESPACE shabon:: FILE shabonConfig.cmake DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/shabon)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/shabonConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/shabonConfigVersion.cmake DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/shabon)

# Which headers are public is read from the headers themselves, at the time of installing.
install(CODE "
  set(SHABON_HEADERS_FROM \"${PROJECT_SOURCE_DIR}/shabon\")
  set(SHABON_HEADERS_TO \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_INCLUDEDIR}/shabon\")
  include(\"${PROJECT_SOURCE_DIR}/cmake/InstallHeaders.cmake\")")
