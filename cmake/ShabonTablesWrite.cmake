# cmake -DLIST=name -DINPUTS=a.csv,b.csv -DOUTPUT=file.cpp -P: the build-time half of ShabonTables.cmake.
set(number "[-+]?(0|[1-9][0-9]*)([.][0-9]*)?([eE][-+]?[0-9]+)?")

# The text after `# key:` in the head of a CSV, as a C++ string literal.
function(head_line result text key file)
  if(NOT text MATCHES "# ${key}: ([^\r\n]*)")
    message(FATAL_ERROR "${file}: the head has no line '# ${key}: ...'")
  endif()
  string(REPLACE "\\" "\\\\" value "${CMAKE_MATCH_1}")
  string(REPLACE "\"" "\\\"" value "${value}")
  set(${result} "\"${value}\"" PARENT_SCOPE)
endfunction()

# A regular expression for a row of `count` fields with the one numbered `column` in brackets; 0: none.
function(row_pattern result count column)
  set(fields "")
  foreach(i RANGE 1 ${count})
    if(i EQUAL column)
      list(APPEND fields "([^,\n]*)")
    else()
      list(APPEND fields "[^,\n]*")
    endif()
  endforeach()
  string(JOIN "," pattern ${fields})
  set(${result} "${pattern}\n" PARENT_SCOPE)
endfunction()

# One column of `rows` as "1.5,\n2,\n".
function(column_values result rows column count file)
  row_pattern(pattern ${count} ${column})
  string(REGEX REPLACE "${pattern}" "\\1,\n" values "${rows}")
  string(REGEX REPLACE "${number},\n" "" rest "${values}")
  if(NOT rest STREQUAL "")
    string(SUBSTRING "${rest}" 0 60 rest)
    message(FATAL_ERROR "${file}: column ${column}: expected numbers, got '${rest}'")
  endif()
  set(${result} "${values}" PARENT_SCOPE)
endfunction()

function(write_table code_variable entry_variable file index)
  file(READ ${file} text)
  string(REPLACE "\r\n" "\n" text "${text}\n")
  string(REGEX REPLACE "\n\n+$" "\n" text "${text}")
  foreach(key name description unit source licence)
    head_line(${key} "${text}" ${key} ${file})
  endforeach()

  string(REGEX REPLACE "#[^\n]*\n" "" body "${text}")
  if(NOT body MATCHES "^([A-Za-z][^\n]*)\n(.*)$")
    message(FATAL_ERROR "${file}: the names of the columns are missing")
  endif()
  string(REPLACE "," ";" names "${CMAKE_MATCH_1}")
  set(rows "${CMAKE_MATCH_2}")
  list(LENGTH names count)

  row_pattern(pattern ${count} 0)
  string(REGEX REPLACE "${pattern}" "" rest "${rows}")
  if(NOT rest STREQUAL "" OR rows STREQUAL "")
    string(SUBSTRING "${rest}" 0 60 rest)
    message(FATAL_ERROR "${file}: expected ${count} fields in every row, got '${rest}'")
  endif()

  set(code "")
  set(columns "")
  foreach(i RANGE 1 ${count})
    column_values(values "${rows}" ${i} ${count} ${file})
    string(APPEND code "constexpr double table${index}_column${i}[] = {\n${values}};\n")
    list(APPEND columns "table${index}_column${i}")
  endforeach()
  string(REPLACE ";" ", " columns "${columns}")
  string(REPLACE ";" "\", \"" names "${names}")
  string(APPEND code "constexpr std::string_view table${index}_names[] = {\"${names}\"};\n"
                     "constexpr std::span<const double> table${index}_columns[] = {${columns}};\n\n")
  set(${code_variable} "${code}" PARENT_SCOPE)
  set(${entry_variable}
      "    {${name}, ${description},\n     ${unit},\n     ${source},\n     ${licence},\n     table${index}_names, table${index}_columns},\n"
      PARENT_SCOPE)
endfunction()

string(REPLACE "," ";" files "${INPUTS}")
set(all_code "")
set(all_entries "")
set(index 0)
foreach(file IN LISTS files)
  write_table(code entry ${file} ${index})
  string(APPEND all_code "${code}")
  string(APPEND all_entries "${entry}")
  math(EXPR index "${index} + 1")
endforeach()
file(WRITE ${OUTPUT} "// Written at build time from data/*.csv, whose licences apply to the numbers.
#include \"shabon/base/table.h\"

namespace shabon::tables {
namespace {
${all_code}constexpr Table entries[] = {
${all_entries}};
}  // namespace

std::span<const Table> ${LIST}();
std::span<const Table> ${LIST}() { return entries; }

}  // namespace shabon::tables
")
