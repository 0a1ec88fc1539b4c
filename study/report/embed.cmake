# Writes OUTPUT, a C++ source that holds each of FILES (a list joined by '|') as a string view named
# after it: report.css becomes report_css. Characters one by one, because a string literal has a
# length limit and needs a delimiter that the text does not contain.
string(REPLACE "|" ";" files "${FILES}")
set(source "#include <string_view>\nnamespace twofold::report_files {\n")
foreach(file IN LISTS files)
  get_filename_component(name ${file} NAME)
  string(MAKE_C_IDENTIFIER ${name} name)
  file(READ ${file} hex HEX)
  string(REGEX REPLACE "(..)" "'\\\\x\\1'," characters "${hex}")
  string(APPEND source "constexpr char ${name}_bytes[] = {${characters}};\n"
                       "extern const std::string_view ${name};\n"
                       "const std::string_view ${name}(${name}_bytes, sizeof ${name}_bytes);\n")
endforeach()
file(WRITE ${OUTPUT} "${source}}  // namespace twofold::report_files\n")
