# Installs the public headers. A header is public when it and all it includes hold nothing but the standard library and
# public headers of the project, and no type whose layout follows compiler flags: neither packets nor libraries that a
# user of the installed library would have to have. Reads SHABON_HEADERS_FROM (the folder shabon/) and
# SHABON_HEADERS_TO; leaves the public headers, relative to shabon/, in SHABON_PUBLIC_HEADERS.
cmake_policy(PUSH)
cmake_policy(VERSION 3.25)

set(private_headers "^math/packet|^optics/packet/|^render/kernel")

file(GLOB_RECURSE headers RELATIVE ${SHABON_HEADERS_FROM} ${SHABON_HEADERS_FROM}/*.h)
list(SORT headers)
set(SHABON_PUBLIC_HEADERS "")
foreach(header IN LISTS headers)
  file(STRINGS ${SHABON_HEADERS_FROM}/${header} includes REGEX "^[ \t]*#[ \t]*include")
  set(needs "")
  set(public TRUE)
  if(header MATCHES "${private_headers}")
    set(public FALSE)
  endif()
  foreach(line IN LISTS includes)
    if(line MATCHES "include[ \t]*\"shabon/([^\"]+)\"")
      list(APPEND needs ${CMAKE_MATCH_1})
    elseif(NOT line MATCHES "include[ \t]*<[a-z_0-9]+>")  # the standard headers have no extension
      set(public FALSE)
    endif()
  endforeach()
  if(public)
    list(APPEND SHABON_PUBLIC_HEADERS ${header})
    set(needs_${header} "${needs}")
  endif()
endforeach()

# Whatever includes a private header is private too, until nothing changes.
set(changed TRUE)
while(changed)
  set(changed FALSE)
  foreach(header IN LISTS SHABON_PUBLIC_HEADERS)
    foreach(need IN LISTS needs_${header})
      if(NOT need IN_LIST SHABON_PUBLIC_HEADERS)
        list(REMOVE_ITEM SHABON_PUBLIC_HEADERS ${header})
        set(changed TRUE)
        break()
      endif()
    endforeach()
  endforeach()
endwhile()

foreach(header IN LISTS SHABON_PUBLIC_HEADERS)
  cmake_path(GET header PARENT_PATH folder)
  file(INSTALL DESTINATION ${SHABON_HEADERS_TO}/${folder} TYPE FILE FILES ${SHABON_HEADERS_FROM}/${header})
endforeach()

cmake_policy(POP)
