# Builds data/*.csv into a library.
#
#   shabon_tables(<sources-variable> <list> <file.csv>...)
#
# writes one C++ file in the build tree that defines `std::span<const shabon::Table> shabon::tables::<list>()`, one entry
# a CSV in the order given, and appends the file to <sources-variable>. Adding a table is one CSV and one list entry.
# A CSV begins with `# name:`, `# description:`, `# unit:`, `# source:` and `# licence:` lines (other comments are free),
# then names its columns, then holds numbers only. What breaks these rules stops the build with the file's name.
set(SHABON_TABLES_SCRIPT ${CMAKE_CURRENT_LIST_DIR}/ShabonTablesWrite.cmake)

function(shabon_tables sources_variable list)
  set(output ${CMAKE_CURRENT_BINARY_DIR}/${list}_tables.cpp)
  list(TRANSFORM ARGN PREPEND ${PROJECT_SOURCE_DIR}/data/)
  string(JOIN "," inputs ${ARGN})  # a list would not survive the command line
  add_custom_command(
    OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DLIST=${list} -DINPUTS=${inputs} -DOUTPUT=${output} -P ${SHABON_TABLES_SCRIPT}
    DEPENDS ${ARGN} ${SHABON_TABLES_SCRIPT}
    COMMENT "Building the tables ${list}"
    VERBATIM)
  set(${sources_variable} ${${sources_variable}} ${output} PARENT_SCOPE)
endfunction()
