#!/usr/bin/env bash
# The tests under a sanitizer or valgrind, built in build/address and build/thread:
# run.sh address|thread|valgrind|valgrind-long
#   address    address, undefined and float-cast-overflow sanitizers
#   thread     thread sanitizer, with plain threads in place of oneTBB
#   valgrind   memcheck, on the release build, of tests that take less than a third of a second without it;
#              valgrind-long has the others, tagged [long], and takes hours
# Every test program runs whole, in one process; then ctest runs what is no case of theirs: the pinned hashes, the
# program from outside, captures. The thread sanitizer and memcheck draw random states by 1, 2 and 7 threads, make a
# study and the platforms' hashes instead. memcheck leaves out tests tagged [fpu], as it knows no other rounding mode.
# Some tens of minutes each; each prints what it ran and ends with "N passed, M failed".
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
tool=${1:-}
build=build/$tool
source tests/programs.sh
passed=0 failed=0

# build_all FLAGS [CMAKE_ARGUMENT ...]
build_all() {
    local flags=$1
    shift
    cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_COMPILER=clang++ \
        -DCMAKE_CXX_FLAGS="-g1 $flags" -DCMAKE_CXX_FLAGS_DEBUG="" -DTWOFOLD_TESTS=ON "$@" >/dev/null
    cmake --build "$build" -j "$(nproc)" | tail -n 1
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

# check_programs BUILD [TESTS] [COMMAND ...]: all test programs with those tests, each run by the command.
check_programs() {
    local folder=$1 tests=${2:-}
    for program in $(programs_in "$folder"); do check "${@:3}" "$program" ${tests:+"$tests"}; done
}

# check_whole BUILD [COMMAND ...]: random states, a study and the platforms' hashes, each run by the command.
check_whole() {
    local folder=$1
    shift
    check "$@" "$folder/fast_equals_reference" --count "$states" --all-options -o "$build/failures"
    check "$@" "$folder/fast_equals_reference" --count "$states" --levels -o "$build/failures"
    rm -rf "$build/study"
    # One of its cells cannot be drawn on purpose: exit code 1.
    check bash -c '"$@" || [ $? -eq 1 ]' study "$@" \
        "$folder/twofold" study scenes/sphere-lobe.json --study tests/study/tiny_study.json -j 7 -q -o "$build/study"
    check bash -o pipefail -c '"$@" 2 | diff tests/platforms/hashes.txt -' hashes "$@" "$folder/tests/platforms/platform_hashes"
}

case $tool in
    address)
        export ASAN_OPTIONS=detect_leaks=1 UBSAN_OPTIONS=print_stacktrace=1
        build_all "-O1 -fsanitize=address,undefined,float-cast-overflow -fno-sanitize-recover=all"
        check_programs "$build"
        check ctest --test-dir "$build" -j "$(nproc)" --output-on-failure "${besides[@]}"
        ;;
    thread)
        export TSAN_OPTIONS="halt_on_error=1 exitcode=66"
        build_all "-O1 -fsanitize=thread" -DCMAKE_PROJECT_INCLUDE="$PWD/tests/sanitize/plain_threads.cmake"
        check_programs "$build"
        states=1000 check_whole "$build"
        ;;
    valgrind | valgrind-long)
        build=build/valgrind
        memcheck=(valgrind -q --error-exitcode=99 --leak-check=full --show-leak-kinds=definite
            --errors-for-leak-kinds=definite)
        mkdir -p "$build"
        cmake --preset release -DTWOFOLD_TESTS=ON >/dev/null
        cmake --build --preset release -j "$(nproc)" | tail -n 1
        if [ "$tool" = valgrind-long ]; then
            check_programs build/release '[long]~[fpu]~[.]' "${memcheck[@]}"
        else
            check_programs build/release '~[long]~[fpu]~[.]' "${memcheck[@]}"
            states=100 check_whole build/release "${memcheck[@]}"
        fi
        ;;
    *) echo "usage: $0 address|thread|valgrind|valgrind-long" >&2; exit 2 ;;
esac
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
