# Flags that every target of the project shares.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

add_library(shabon_flags INTERFACE)
target_compile_options(shabon_flags INTERFACE
  -Wall -Wextra -Wshadow -Wnon-virtual-dtor -Wno-psabi
  -fno-math-errno          # std::sqrt becomes one instruction; results are unchanged
  -ffp-contract=off        # the same bits from every compiler; the wide renderer variants switch it on
  -fvisibility-inlines-hidden)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(shabon_flags INTERFACE -Wno-restrict)  # false alarm on std::string (GCC bug 105651)
endif()
if(SHABON_WARNINGS_AS_ERRORS)
  target_compile_options(shabon_flags INTERFACE -Werror)
endif()
if(SHABON_SANITIZE)
  target_compile_options(shabon_flags INTERFACE -fsanitize=${SHABON_SANITIZE} -fno-omit-frame-pointer)
  target_link_options(shabon_flags INTERFACE -fsanitize=${SHABON_SANITIZE})
endif()
