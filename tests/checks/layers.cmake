# Fails when an #include points the wrong way (docs/design.md, section 1).
# usage: cmake -DROOT=SOURCE_DIR -P layers.cmake
cmake_minimum_required(VERSION 3.25)

# What each folder may include; cli, bench and tests may include anything.
set(allowed_texunit texunit)
set(allowed_raster texunit raster)
set(allowed_factor texunit factor)
set(allowed_scenes texunit raster factor scenes)
set(allowed_study texunit raster factor scenes study)
set(folders texunit raster factor scenes study)

set(wrong "")

function(check_include folder file target)
  set(place "${file} includes ${target}")
  if(target MATCHES "^OpenImageIO/" AND NOT file STREQUAL "texunit/image_file.cpp")
    set(wrong "${wrong}${place}: only texunit/image_file.cpp may\n" PARENT_SCOPE)
  elseif(target MATCHES "(^|/)\\.\\.?/")
    set(wrong "${wrong}${place}: write the path from the root of the tree\n" PARENT_SCOPE)
  elseif(target MATCHES "^(texunit|raster|factor|scenes|study|cli|bench|tests)/")
    if(NOT CMAKE_MATCH_1 IN_LIST allowed_${folder})
      set(wrong "${wrong}${place}: ${folder} may include only ${allowed_${folder}}\n" PARENT_SCOPE)
    endif()
  endif()
endfunction()

foreach(folder ${folders})
  file(GLOB_RECURSE files RELATIVE ${ROOT} ${ROOT}/${folder}/*.hpp ${ROOT}/${folder}/*.cpp)
  foreach(file ${files})
    file(STRINGS ${ROOT}/${file} lines REGEX "^[ \t]*#[ \t]*include[ \t]*[<\"]")
    foreach(line ${lines})
      if(line MATCHES "[<\"]([^>\"]+)[>\"]")
        check_include(${folder} ${file} ${CMAKE_MATCH_1})
      endif()
    endforeach()
  endforeach()
endforeach()

if(wrong)
  message(FATAL_ERROR "${wrong}")
endif()
