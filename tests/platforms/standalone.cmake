# The libraries under the hash program from their own lists of sources, with headers alone of what they use.
cmake_path(GET CMAKE_CURRENT_SOURCE_DIR PARENT_PATH root)
cmake_path(GET root PARENT_PATH root)
set(PROJECT_SOURCE_DIR ${root})
include(${root}/cmake/exactness.cmake)

# Another processor's compiler must not look into this one's /usr/include.
set(headers ${CMAKE_BINARY_DIR}/headers)
file(MAKE_DIRECTORY ${headers})
foreach(package fmt glm hwy)
  file(CREATE_LINK /usr/include/${package} ${headers}/${package} SYMBOLIC)
endforeach()
set(hwy_INCLUDE_DIRS ${headers})

# image_file is never built here.
foreach(target glm::glm fmt::fmt TBB::tbb PkgConfig::OpenImageIO)
  add_library(${target} INTERFACE IMPORTED)
  target_include_directories(${target} SYSTEM INTERFACE ${headers})
endforeach()
target_compile_definitions(fmt::fmt INTERFACE FMT_HEADER_ONLY)
if(CMAKE_SYSTEM_PROCESSOR STREQUAL wasm32)
  include_directories(BEFORE SYSTEM ${CMAKE_CURRENT_SOURCE_DIR}/wasi)
else()
  target_link_options(TBB::tbb INTERFACE -pthread)
endif()

foreach(library texunit raster factor)
  add_subdirectory(${root}/${library} ${library} EXCLUDE_FROM_ALL)
endforeach()
get_target_property(sources texunit SOURCES)
list(FILTER sources EXCLUDE REGEX "/parallel.cpp$")
set_target_properties(texunit PROPERTIES SOURCES "${sources};${CMAKE_CURRENT_SOURCE_DIR}/thread_parallel.cpp")

include(${root}/cmake/precompiled.cmake)
