# A room is one folder of shabon/ and one target. It may link only rooms with a smaller number, never its equals.
# This list is the only place where the numbers stand; tests/architecture reads the includes against it.
set(SHABON_ROOMS base=0 math=1 io=1 color=2 optics=2 geometry=2 film=3 desk=3 scene=4 render=5 api=6)

set(SHABON_ROOM_NAMES "")
foreach(room IN LISTS SHABON_ROOMS)
  string(REPLACE "=" ";" room ${room})
  list(GET room 0 room_name)
  list(GET room 1 SHABON_ROOM_NUMBER_${room_name})
  list(APPEND SHABON_ROOM_NAMES ${room_name})
endforeach()

# Adds the folder of every room that has one below the current folder.
macro(shabon_add_rooms)
  foreach(room IN LISTS SHABON_ROOM_NAMES)
    if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${room}/CMakeLists.txt)
      add_subdirectory(${room})
    endif()
  endforeach()
endmacro()

# shabon_room(NAME SOURCES ... ROOMS ... PACKAGES ... [SUFFIX _v3] [CONTRACT] [OPTIONS ...])
# SUFFIX names a variant of the room, compiled with OPTIONS; CONTRACT lets the compiler fuse a*b+c.
function(shabon_room name)
  cmake_parse_arguments(ARG "CONTRACT" "SUFFIX" "SOURCES;ROOMS;PACKAGES;OPTIONS" ${ARGN})
  foreach(other IN LISTS ARG_ROOMS)
    if(NOT SHABON_ROOM_NUMBER_${other} LESS SHABON_ROOM_NUMBER_${name})
      message(FATAL_ERROR "room '${name}' (${SHABON_ROOM_NUMBER_${name}}) may not link room '${other}' (${SHABON_ROOM_NUMBER_${other}})")
    endif()
  endforeach()
  set(target shabon_${name}${ARG_SUFFIX})
  if(NOT ARG_SOURCES)  # a room of headers only
    add_library(${target} INTERFACE)
    target_include_directories(${target} INTERFACE ${PROJECT_SOURCE_DIR})
    foreach(other IN LISTS ARG_ROOMS)
      target_link_libraries(${target} INTERFACE shabon_${other})
    endforeach()
    return()
  endif()
  add_library(${target} STATIC ${ARG_SOURCES})
  target_include_directories(${target} PUBLIC ${PROJECT_SOURCE_DIR})
  target_link_libraries(${target} PRIVATE shabon_flags)
  foreach(other IN LISTS ARG_ROOMS)
    target_link_libraries(${target} PUBLIC shabon_${other})
  endforeach()
  target_link_libraries(${target} PRIVATE ${ARG_PACKAGES})
  target_compile_options(${target} PRIVATE ${ARG_OPTIONS})
  set_target_properties(${target} PROPERTIES SHABON_CONTRACT "${ARG_CONTRACT}" SHABON_PACKAGES "${ARG_PACKAGES}")
endfunction()

# The wider kinds of x86-64 that a room with variants is compiled for besides the one that every machine runs, and the
# compiler options of each.
set(SHABON_WIDE_LEVELS "")
if(SHABON_WIDE_VARIANTS AND CMAKE_SYSTEM_NAME STREQUAL "Linux" AND CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64")
  set(SHABON_WIDE_LEVELS v3 v4)
endif()
set(SHABON_HWCAPS glibc-hwcaps/x86-64-)  # the folder names that the loader knows: x86-64-v3, x86-64-v4
set(SHABON_WIDE_OPTIONS_v3 -march=x86-64-v3)
set(SHABON_WIDE_OPTIONS_v4 -march=x86-64-v4 -mprefer-vector-width=512)

# What an earlier configuration left in the library folder for levels that are no longer built: the loader would still
# prefer it to what is built now.
function(shabon_remove_stale_variants folder)
  foreach(level v2 v3 v4)
    if(NOT level IN_LIST SHABON_WIDE_LEVELS)
      file(REMOVE_RECURSE ${folder}/${SHABON_HWCAPS}${level})
    endif()
  endforeach()
endfunction()

# shabon_variants(NAME SOURCES ... COMMON ... ROOMS ... PACKAGES ... OPTIONS ...): the room as shabon_NAME, and one more
# target shabon_NAME_v3 and so on for each wide level, all with fused a*b+c where the machine has it. COMMON sources are
# compiled once, for any machine, and are the same in all variants.
function(shabon_variants name)
  cmake_parse_arguments(ARG "" "" "SOURCES;COMMON;ROOMS;PACKAGES;OPTIONS" ${ARGN})
  if(ARG_COMMON)
    add_library(shabon_${name}_common OBJECT ${ARG_COMMON})
    target_include_directories(shabon_${name}_common PRIVATE ${PROJECT_SOURCE_DIR})
    target_link_libraries(shabon_${name}_common PRIVATE shabon_flags ${ARG_PACKAGES})
    list(APPEND ARG_SOURCES $<TARGET_OBJECTS:shabon_${name}_common>)
  endif()
  if(SHABON_SANITIZE)
    set(ARG_OPTIONS "")  # sanitizers are slow enough to compile
  endif()
  set(common SOURCES ${ARG_SOURCES} ROOMS ${ARG_ROOMS} PACKAGES ${ARG_PACKAGES} CONTRACT)
  shabon_room(${name} ${common} OPTIONS ${ARG_OPTIONS})
  if(ARG_SOURCES)
    foreach(level IN LISTS SHABON_WIDE_LEVELS)
      shabon_room(${name} ${common} SUFFIX _${level} OPTIONS ${ARG_OPTIONS} ${SHABON_WIDE_OPTIONS_${level}})
    endforeach()
  endif()
endfunction()
