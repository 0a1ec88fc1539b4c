# An independent validator against the schema and the shipped scenes; skipped where it is not installed.
find_program(TWOFOLD_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH)
if(TWOFOLD_PYTHON)
  add_test(NAME "scenes: the schema is valid and accepts the shipped scenes"
           COMMAND ${TWOFOLD_PYTHON} ${CMAKE_CURRENT_LIST_DIR}/schema_test.py
                   ${PROJECT_SOURCE_DIR}/scenes ${PROJECT_SOURCE_DIR}/study)
  set_tests_properties("scenes: the schema is valid and accepts the shipped scenes"
                       PROPERTIES LABELS scenes SKIP_RETURN_CODE 77 TIMEOUT 60)
endif()
