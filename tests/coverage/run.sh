#!/usr/bin/env bash
# Which lines the tests run: builds in build/coverage without optimisation, runs ctest (its arguments can be
# given) and prints the share of lines of each folder, then those that nothing ran. Some tens of minutes.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
build=build/coverage
cmake -S . -B $build -G Ninja -DCMAKE_BUILD_TYPE=Debug -DTWOFOLD_TESTS=ON -DTWOFOLD_BENCH=OFF \
    -DCMAKE_CXX_FLAGS="-O0 --coverage -fprofile-update=atomic" >/dev/null
cmake --build $build | tail -n 1
find $build -name '*.gcda' -delete
ctest --test-dir $build -j "$(nproc)" "$@" | tail -n 20 || echo "some tests failed: their lines count all the same"
tests/coverage/lines.py $build
