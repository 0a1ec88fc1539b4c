# With -DCMAKE_PROJECT_INCLUDE=cmake/precompiled.cmake: the headers that a third of a build goes into are compiled once
# for each library, where a build is made only to be looked at. The product's own builds do without, so that a missing
# #include is found.
function(twofold_precompile)
  # g++ 12 without optimisation takes the immediates of AVX-512's macros for variables when they follow such a header.
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_FLAGS MATCHES "-O0")
    return()
  endif()
  foreach(library texunit raster factor scenes study)
    if(TARGET ${library})
      target_precompile_headers(${library} PRIVATE <fmt/format.h> <algorithm> <array> <cmath> <functional> <optional>
                                <span> <string> <variant> <vector> <glm/mat3x3.hpp> <glm/mat4x4.hpp>)
    endif()
  endforeach()
endfunction()
cmake_language(DEFER DIRECTORY ${CMAKE_SOURCE_DIR} CALL twofold_precompile)
