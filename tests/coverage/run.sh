#!/usr/bin/env bash
# Which lines the tests run: run.sh [LIBRARY ...]. Builds without optimisation in build/coverage, runs all of
# ctest, or only test_LIBRARY of each library named, and prints the share of lines of each folder, then those
# that nothing ran. All of it takes some tens of minutes.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
build=build/coverage
libraries=("$@")
cmake -S . -B $build -G Ninja -DCMAKE_BUILD_TYPE=Debug -DTWOFOLD_TESTS=ON \
    -DCMAKE_CXX_FLAGS="-O0 --coverage -fprofile-update=atomic" >/dev/null
cmake --build $build -j "$(nproc)" ${libraries[0]:+--target "${libraries[@]/#/test_}"} | tail -n 1
find $build -name '*.gcda' -delete
if [ ${#libraries[@]} -eq 0 ]; then
    ctest --test-dir $build -j "$(nproc)" | tail -n 20 || echo "tests failed; their lines count all the same"
else
    for library in "${libraries[@]}"; do $build/tests/test_"$library" | tail -n 3; done
fi
tests/coverage/lines.py $build "${libraries[@]}"
