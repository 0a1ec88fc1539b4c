# shellcheck shell=bash
# Sourced by libm.sh and fused.sh: builds the four libraries that all results come from.

core_libraries=(texunit raster factor scenes)

# build_core COMPILER BUILD_DIR SOURCE_DIR FLAGS: quiet unless it fails. FLAGS come last in every compiler
# call, after those of the build type and of the targets, so that they win.
build_core() {
    local log precompiled=
    log=$(mktemp) || return 2
    # Not for the self-tests' libraries of one empty source, and not for g++ without optimisation, where
    # cmake/precompiled.cmake says why.
    if [ ! -e "$3/factor/empty.cpp" ] && [[ $4 != -O0* || $1 == *clang* ]]; then
        precompiled=$3/cmake/precompiled.cmake
    fi
    if ! { cmake -S "$3" -B "$2" -DCMAKE_CXX_COMPILER="$1" -DTWOFOLD_TESTS=OFF -DTWOFOLD_BENCH=OFF \
               ${precompiled:+-DCMAKE_PROJECT_INCLUDE="$precompiled"} \
               -DCMAKE_CXX_COMPILE_OBJECT="<CMAKE_CXX_COMPILER> <DEFINES> <INCLUDES> <FLAGS> $4 -o <OBJECT> -c <SOURCE>" &&
           cmake --build "$2" --target "${core_libraries[@]}" --parallel "${JOBS:-2}"; } >"$log" 2>&1; then
        cat "$log" >&2
        rm -f "$log"
        return 2
    fi
    rm -f "$log"
}

# archives BUILD_DIR: the four libraries, with image_file, which lies in texunit.
archives() {
    local library
    for library in "${core_libraries[@]}"; do ls "$1/$library"/*.a; done
}
