# The compiler flags that keep every output bit the same (docs/exactness.md, rule E01).

# Partial fast-math flags leave no macro behind in clang, so they are looked for by name.
foreach(flags CMAKE_CXX_FLAGS CMAKE_CXX_FLAGS_RELEASE CMAKE_CXX_FLAGS_DEBUG)
  if("${${flags}}" MATCHES "-Ofast|-ffast-math|-funsafe-math|-fassociative-math|-mfpmath=387")
    message(FATAL_ERROR "twofold: ${flags} holds '${CMAKE_MATCH_0}', which breaks exactness")
  endif()
endforeach()

# -fno-trapping-math changes no value: it lets loops with a comparison become vectors.
# g++ 12's vectoriser of straight-line code makes vfmaddsub of neighbouring a * b - c and a * b + c in spite of
# -ffp-contract=off, so it is switched off there (tests/checks/fused.sh finds such instructions).
function(twofold_library name)
  add_library(${name} STATIC ${ARGN})
  target_include_directories(${name} PUBLIC ${PROJECT_SOURCE_DIR})
  twofold_exact(${name})
endfunction()

function(twofold_exact target)
  target_compile_options(${target} PRIVATE -ffp-contract=off -fno-math-errno -fno-trapping-math)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(${target} PRIVATE -fno-tree-slp-vectorize)
  endif()
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "^i[3-6]86$")
    target_compile_options(${target} PRIVATE -msse2 -mfpmath=sse)
  endif()
endfunction()
