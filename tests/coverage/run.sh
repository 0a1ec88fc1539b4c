#!/usr/bin/env bash
# Which lines the tests run: run.sh [LIBRARY ...]. Builds without optimisation in build/coverage, runs all tests,
# or only test_LIBRARY of each library named, and prints the share of lines of each folder, then those that
# nothing ran. All of it takes hours, because tests tagged [long] take them without optimisation.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
build=build/coverage
libraries=("$@")
cmake -S . -B $build -G Ninja -DCMAKE_BUILD_TYPE=Debug -DTWOFOLD_TESTS=ON \
    -DCMAKE_CXX_FLAGS="-O0 --coverage -fprofile-update=atomic" >/dev/null
cmake --build $build -j "$(nproc)" ${libraries[0]:+--target "${libraries[@]/#/test_}"} | tail -n 1
find $build -name '*.gcda' -delete
failed() { echo "tests failed; their lines count all the same"; }
source tests/programs.sh
programs=("${libraries[@]/#/$build/tests/test_}")
[ ${#libraries[@]} -gt 0 ] || mapfile -t programs < <(programs_in $build)
for program in "${programs[@]}"; do "$program" | tail -n 3 || failed; done
[ ${#libraries[@]} -gt 0 ] ||
    ctest --test-dir $build -j "$(nproc)" "${besides[@]}" | tail -n 5 || failed
tests/coverage/lines.py $build "${libraries[@]}"
