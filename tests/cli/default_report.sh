#!/usr/bin/env bash
# The report of a real run opens in Chromium. usage: default_report.sh TWOFOLD SCENES_DIR REPORT_PAGE_SH
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$1" run "$2/gold-suzanne.json" -o "$work" -q -D image.width=160 -D image.height=120 -D environment.cells=512 \
    -D factorization.map_size=16 -D factorization.samples=12000 >/dev/null
"$3" "$work/report.html"
