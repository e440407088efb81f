# Flags that every target of the project shares.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

add_library(shabon_flags INTERFACE)
target_compile_options(shabon_flags INTERFACE
  -Wall -Wextra -Wshadow -Wnon-virtual-dtor
  -fno-math-errno               # std::sqrt becomes one instruction; results are unchanged
  -fno-semantic-interposition   # the library's functions may be inlined in it although it exports them
  -fvisibility-inlines-hidden
  # Without fused a*b+c every compiler gives the same bits; the renderer's variants ask for it (CONTRACT).
  -ffp-contract=$<IF:$<BOOL:$<TARGET_PROPERTY:SHABON_CONTRACT>>,fast,off>)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(shabon_flags INTERFACE -Wno-psabi)  # packets never cross the library's border
  if(CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    target_compile_options(shabon_flags INTERFACE -Wno-restrict)  # false alarm on std::string (GCC bug 105651)
  endif()
endif()
if(SHABON_BUILD_BENCH)
  target_compile_options(shabon_flags INTERFACE -g1)  # line tables, to tell what the time goes into; the code is the same
endif()
if(SHABON_WARNINGS_AS_ERRORS)
  target_compile_options(shabon_flags INTERFACE -Werror)
endif()
if(SHABON_SANITIZE)
  target_compile_options(shabon_flags INTERFACE
    -fsanitize=${SHABON_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(shabon_flags INTERFACE -Wno-maybe-uninitialized)  # false alarms on std::regex
  endif()
  target_link_options(shabon_flags INTERFACE -fsanitize=${SHABON_SANITIZE})
endif()
