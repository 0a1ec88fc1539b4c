# Debian 12 packages; docs/dependencies.md says what each is for.
find_package(glm REQUIRED)
find_package(fmt REQUIRED)
find_package(TBB REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(OpenImageIO 2.4 CONFIG REQUIRED)
find_package(tinyobjloader REQUIRED)

# Debian 12 exports OpenImageIO with the include directory of an OpenCV that it does not depend on.
foreach(property INTERFACE_INCLUDE_DIRECTORIES INTERFACE_SYSTEM_INCLUDE_DIRECTORIES)
  get_target_property(directories OpenImageIO::OpenImageIO ${property})
  if(directories)
    list(FILTER directories EXCLUDE REGEX "opencv4$")
    set_target_properties(OpenImageIO::OpenImageIO PROPERTIES ${property} "${directories}")
  endif()
endforeach()
