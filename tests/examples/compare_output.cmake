# Run by ctest: COMMAND must succeed and print what the file EXPECTED holds.
execute_process(COMMAND ${COMMAND} RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE messages)
file(READ ${EXPECTED} expected)
if(NOT code EQUAL 0 OR NOT output STREQUAL expected)
  message(FATAL_ERROR "exit code ${code}\n${messages}\nexpected:\n${expected}\ngot:\n${output}")
endif()
