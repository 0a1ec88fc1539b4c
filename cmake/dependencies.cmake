# Debian 12 packages; docs/dependencies.md says what each is for.
find_package(glm REQUIRED)
find_package(fmt REQUIRED)
find_package(TBB REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(OpenSSL REQUIRED COMPONENTS Crypto)

# By pkg-config: Debian 12's CMake export of OpenImageIO needs files of OpenCV and of Python's Imath, which
# its package does not depend on.
find_package(PkgConfig REQUIRED)
pkg_check_modules(OpenImageIO REQUIRED IMPORTED_TARGET OpenImageIO>=2.4)
pkg_check_modules(hwy REQUIRED libhwy>=1.0.3)
