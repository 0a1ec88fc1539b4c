# With -DCMAKE_PROJECT_INCLUDE=tests/sanitize/plain_threads.cmake: plain threads in place of oneTBB, whose
# library is not instrumented, so that the thread sanitizer would not see what orders its tasks.
function(take_plain_threads)
  get_target_property(sources texunit SOURCES)
  list(FILTER sources EXCLUDE REGEX "/parallel.cpp$")
  set_target_properties(
    texunit PROPERTIES SOURCES "${sources};${PROJECT_SOURCE_DIR}/tests/platforms/thread_parallel.cpp")
endfunction()
cmake_language(DEFER DIRECTORY ${CMAKE_SOURCE_DIR} CALL take_plain_threads)
