# An independent validator against the schema and the shipped scenes; skipped where it is not installed.
find_package(Python3 COMPONENTS Interpreter)
if(Python3_FOUND)
  add_test(NAME "scenes: the schema is valid and accepts the shipped scenes"
           COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_LIST_DIR}/schema_test.py
                   ${PROJECT_SOURCE_DIR}/scenes)
  set_tests_properties("scenes: the schema is valid and accepts the shipped scenes"
                       PROPERTIES LABELS scenes SKIP_RETURN_CODE 77 TIMEOUT 60)
endif()
