#!/usr/bin/env bash
# The tests under a sanitizer or valgrind, built in build/address and so on: run.sh address|thread|valgrind
#   address    address, undefined and float-cast-overflow sanitizers: all of ctest but what loads them itself
#   thread     thread sanitizer, with plain threads in place of oneTBB: rasterizer, factoriser, study's parts
#   valgrind   memcheck on a debug build: the unit tests whose work is small
# The first run builds for some minutes; each prints what it ran and ends with "N passed, M failed".
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
tool=${1:-}
build=build/$tool
passed=0 failed=0

configure() {
    cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Debug -DTWOFOLD_TESTS=ON "$@" >/dev/null
}

# check PROGRAM ARGUMENTS...: runs it, and shows the end of what it says if it fails.
check() {
    local started=$SECONDS code=0
    "$@" >"$build/output" 2>&1 || code=$?
    echo "== exit $code after $((SECONDS - started)) s: ${*//$build\//}"
    if [ $code -eq 0 ]; then passed=$((passed + 1)); return; fi
    failed=$((failed + 1))
    tail -n 40 "$build/output"
}

case $tool in
    address)
        export ASAN_OPTIONS=detect_leaks=1 UBSAN_OPTIONS=print_stacktrace=1
        configure -DCMAKE_CXX_FLAGS="-O1 -g1 -fsanitize=address,undefined,float-cast-overflow -fno-sanitize-recover=all"
        cmake --build "$build" -j "$(nproc)" | tail -n 1
        check ctest --test-dir "$build" -j "$(nproc)" --output-on-failure
        ;;
    thread)
        export TSAN_OPTIONS="halt_on_error=1 exitcode=66"
        configure -DCMAKE_CXX_FLAGS="-O1 -g1 -fsanitize=thread" \
            -DCMAKE_PROJECT_INCLUDE="$PWD/tests/sanitize/plain_threads.cmake"
        cmake --build "$build" -j "$(nproc)" --target test_raster test_factor fast_equals_reference twofold | tail -n 1
        check "$build/tests/test_raster"
        check "$build/tests/test_factor" "*same bits*"
        check "$build/fast_equals_reference" --count 1000 --all-options -o "$build/failures"
        check "$build/twofold" study scenes/sphere-lobe.json --study tests/study/tiny_study.json -j 7 -q -o "$build/study"
        ;;
    valgrind)
        configure -DCMAKE_CXX_FLAGS="-O1 -g1"
        cmake --build "$build" -j "$(nproc)" --target test_texunit test_raster test_factor | tail -n 1
        memcheck=(valgrind -q --error-exitcode=99 --leak-check=full --errors-for-leak-kinds=definite)
        check "${memcheck[@]}" "$build/tests/test_texunit" '[file],[image],[dxt],[border],[combiner]'
        check "${memcheck[@]}" "$build/tests/test_raster" '~[slow]'
        check "${memcheck[@]}" "$build/tests/test_factor" '[brdf],[environment],[parametrization],[qmr]'
        ;;
    *) echo "usage: $0 address|thread|valgrind" >&2; exit 2 ;;
esac
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
