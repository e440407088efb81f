# Run by ctest: installs, moves the installed tree elsewhere, and looks at it from outside.
cmake_minimum_required(VERSION 3.25)
string(REPLACE "," ";" LEVELS "${LEVELS}")
string(REPLACE "," ";" MACHINE_LEVELS "${MACHINE_LEVELS}")
set(PREFIX ${WORK}/moved)

function(run what)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "${what}: exit code ${code}\n${output}")
  endif()
  set(OUTPUT "${output}" PARENT_SCOPE)
endfunction()

macro(expect what)
  if(NOT (${ARGN}))
    message(SEND_ERROR "${what}")
  endif()
endmacro()

# The tree is installed in one place and used in another: it may hold no path of its own.
file(REMOVE_RECURSE ${WORK}/installed ${PREFIX} ${WORK}/consumer)
run("install" ${CMAKE_COMMAND} --install ${BUILD} --config ${CONFIG} --prefix ${WORK}/installed)
file(RENAME ${WORK}/installed ${PREFIX})

# The public headers hold nothing whose layout follows compiler options, and include nothing that is not there.
file(GLOB_RECURSE headers RELATIVE ${PREFIX}/${INCLUDEDIR}/shabon ${PREFIX}/${INCLUDEDIR}/shabon/*.h)
list(LENGTH headers count)
expect("only ${count} headers are installed" count GREATER 20)
foreach(header IN LISTS headers)
  expect("${header} should not be installed" NOT header MATCHES "packet|^render/kernel")
  file(STRINGS ${PREFIX}/${INCLUDEDIR}/shabon/${header} includes REGEX "^[ \t]*#[ \t]*include")
  foreach(line IN LISTS includes)
    if(line MATCHES "\"shabon/([^\"]+)\"")
      expect("${header} includes ${CMAKE_MATCH_1}, which is not installed"
        EXISTS ${PREFIX}/${INCLUDEDIR}/shabon/${CMAKE_MATCH_1})
    else()
      expect("${header} includes more than the standard library: ${line}" line MATCHES "<[a-z_0-9]+>")
    endif()
  endforeach()
endforeach()

# The libraries for wider machines have every name that the library for all machines has. Names inside the renderer that
# carry the width of its registers differ on purpose; no header that is installed mentions them.
function(names_of library result)
  run("names of ${library}" ${NM} --dynamic --defined-only --extern-only --format=posix ${library})
  string(REGEX MATCHALL "[^\n ]+ [TBDR] " names "${OUTPUT}")  # weak ones are copies of inline functions
  list(FILTER names EXCLUDE REGEX "registers_[0-9]+")
  set(${result} "${names}" PARENT_SCOPE)
endfunction()
names_of(${PREFIX}/${LIBDIR}/libshabon.so.0 base_names)
list(LENGTH base_names count)
expect("the library shows only ${count} names" count GREATER 20)
foreach(level IN LISTS LEVELS)
  names_of(${PREFIX}/${LIBDIR}/glibc-hwcaps/x86-64-${level}/libshabon.so.0 wide_names)
  set(missing ${base_names})
  list(REMOVE_ITEM missing ${wide_names})
  list(REMOVE_ITEM wide_names ${base_names})
  expect("the library for ${level} lacks ${missing}" NOT missing)
  expect("only the library for ${level} has ${wide_names}" NOT wide_names)
endforeach()

# A project that knows only the prefix.
run("configure the consumer" ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/consumer -B ${WORK}/consumer -G ${GENERATOR}
  -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_BUILD_TYPE=${CONFIG} -DCMAKE_PREFIX_PATH=${PREFIX})
run("build the consumer" ${CMAKE_COMMAND} --build ${WORK}/consumer)
run("run the consumer" ${WORK}/consumer/consumer)
message("${OUTPUT}")

# The loader picks the widest library that the machine runs, for the installed program and for the built one.
set(widest ${LIBDIR}/libshabon.so.0)
foreach(level IN LISTS MACHINE_LEVELS)
  set(widest ${LIBDIR}/glibc-hwcaps/x86-64-${level}/libshabon.so.0)
endforeach()
foreach(program ${PREFIX}/${BINDIR}/shabon ${WORK}/consumer/consumer)
  run("${program}" ${CMAKE_COMMAND} -E env LD_DEBUG=libs ${program} --version)
  string(REGEX MATCH "calling init: [^\n]*libshabon[^\n]*" loaded "${OUTPUT}")
  expect("${program} should load ${widest}, but: ${loaded}" loaded MATCHES "/${widest}$")
endforeach()
