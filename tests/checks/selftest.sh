#!/bin/bash
# Shows that each check finds what it is for: a small copy of the tree passes, and fails once a violation is
# planted in it.
# usage: selftest.sh banned|layers|libm|fused [COMPILER]
set -u
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
check=$1
compiler=${2:-c++}
work=$(mktemp -d) || exit 2
trap 'rm -rf "$work"' EXIT
failures=0

# The build files of the tree with one empty source for each library: what the checks see is then only what
# is planted, and building takes seconds.
fresh_copy() {
    rm -rf "$work/copy"
    mkdir "$work/copy"
    cp -R "$root/CMakeLists.txt" "$root/cmake" "$work/copy"
    local folder
    for folder in texunit raster factor scenes study cli; do
        mkdir "$work/copy/$folder"
        cp "$root/$folder/CMakeLists.txt" "$work/copy/$folder"
        echo "namespace {}" >"$work/copy/$folder/empty.cpp"
    done
    echo "int main() {}" >"$work/copy/cli/main.cpp"
    echo "namespace {}" | tee "$work/copy/texunit/image_file.cpp" >"$work/copy/texunit/atomic_file.cpp"
}

run_check() {
    case $check in
        banned) "$here/banned.sh" "$work/copy" ;;
        layers) cmake -DROOT="$work/copy" -P "$here/layers.cmake" ;;
        libm | fused) "$here/$check.sh" "$compiler" "$work/build" "$work/copy" ;;
    esac >"$work/output" 2>&1
}

# expect STATUS WHAT: the check's exit status, where 1 stands for a violation found.
expect() {
    run_check
    local status=$?
    if [ "$status" -ne "$1" ]; then
        echo "$check: exit $status instead of $1 for $2"
        cat "$work/output"
        failures=$((failures + 1))
    fi
}

# plant FILE TEXT STATUS: adds the text to an otherwise clean copy and expects the status.
plant() {
    mkdir -p "$(dirname "$work/copy/$1")"
    echo "$2" >"$work/copy/$1"
    expect "$3" "$1: $2"
    rm "$work/copy/$1"
}

check_banned() {
    local line
    while IFS= read -r line; do plant raster/planted.cpp "$line" 1; done <"$here/planted_banned.txt"
    while IFS= read -r line; do plant factor/planted.hpp "$line" 0; done <"$here/planted_allowed.txt"
    plant scenes/planted.hpp "double x = std::exp(1.0);" 1
    plant texunit/planted.cpp "double x = std::exp(1.0);" 1
    plant study/planted.cpp "double x = std::exp(1.0);" 0
}

check_layers() {
    plant texunit/planted.cpp '#include "raster/pass.hpp"' 1
    plant texunit/planted.hpp '#include "factor/brdf.hpp"' 1
    plant raster/planted.cpp '#include "factor/brdf.hpp"' 1
    plant raster/planted.cpp '  #  include <factor/brdf.hpp>' 1
    plant factor/planted.cpp '#include "raster/pass.hpp"' 1
    plant factor/planted.cpp '#include "../raster/pass.hpp"' 1
    plant factor/inner/planted.cpp '#include "scenes/scene.hpp"' 1
    plant scenes/planted.cpp '#include "study/sweep.hpp"' 1
    plant study/planted.cpp '#include "cli/options.hpp"' 1
    plant raster/planted.cpp '#include <OpenImageIO/imageio.h>' 1
    plant scenes/planted.cpp '#include "factor/brdf.hpp"' 0
    plant study/planted.cpp '#include "scenes/scene.hpp"' 0
    plant raster/planted.cpp '#include "texunit/texture.hpp"' 0
    plant cli/planted.cpp '#include "study/sweep.hpp"' 0
}

check_libm() {
    plant texunit/empty.cpp '#include <cmath>
double planted(double x) { return std::sqrt(x) + std::floor(x) + std::fabs(x); }' 0
    plant texunit/empty.cpp '#include <cmath>
double planted() { return std::exp(1.0); }' 1
    echo "namespace {}" >"$work/copy/texunit/empty.cpp"
    plant raster/empty.cpp '#include <cmath>
float planted(float x) { using std::round; return round(x); }' 1
    echo "namespace {}" >"$work/copy/raster/empty.cpp"
    plant scenes/empty.cpp '#include <cmath>
using namespace std;
double planted(double x, double y) { return fmin(x, y); }' 1
    plant scenes/empty.cpp 'extern "C" double cos(double);
double planted(double x) { return ::cos(x); }' 1
}

check_fused() {
    local sum='double planted(double a, double b, double c) { return a * b + c; }'
    plant factor/empty.cpp "$sum" 0
    plant factor/empty.cpp 'double planted(double a, double b, double c) { return __builtin_fma(a, b, c); }' 1
    sed -i 's/-ffp-contract=off/-ffp-contract=fast/' "$work/copy/cmake/exactness.cmake"
    plant factor/empty.cpp "$sum" 1
}

fresh_copy
expect 0 "a clean copy"
"check_$check"
[ $failures -eq 0 ]
