#!/bin/sh
# Opens a report in headless Chromium and asks the page itself whether everything worked:
# no script error, nothing on the console, every picture decoded.
# usage: report_page.sh REPORT.html
set -eu

fail() {
    echo "report_page: $1" >&2
    exit 1
}

[ $# -eq 1 ] || fail "usage: report_page.sh REPORT.html"
[ -f "$1" ] || fail "no such file: $1"
chromium=$(command -v chromium || command -v chromium-browser) ||
    fail "chromium is missing; on Debian: apt-get install chromium"
report=$(realpath "$1")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

timeout 120 "$chromium" --headless --no-sandbox --disable-gpu --disable-quic --no-first-run \
    --disable-background-networking --disable-component-update --disable-sync \
    --user-data-dir="$scratch/profile" --enable-logging=stderr --v=0 \
    --virtual-time-budget=10000 --dump-dom "file://$report" \
    >"$scratch/dom.html" 2>"$scratch/log" || { cat "$scratch/log" >&2; fail "chromium failed"; }

if grep ':CONSOLE' "$scratch/log" >&2; then fail "the page wrote to the console"; fi

# The page's own count, from the attributes of its root element.
root=$(grep -o '<html[^>]*>' "$scratch/dom.html" | head -n 1)
attribute() { printf '%s\n' "$root" | sed -n "s/.*data-$1=\"\([^\"]*\)\".*/\1/p"; }
images=$(attribute images)
# Only elements: the data and the script, which come later in the file, hold no "<img ".
elements=$(grep -o '<img ' "$scratch/dom.html" | wc -l)

[ "$(attribute errors)" = 0 ] || fail "script errors: '$(attribute errors)'"
[ "$(attribute ready)" = 1 ] || fail "the page did not get ready: $root"
[ "${images:-0}" -gt 0 ] || fail "no picture was decoded"
[ "$images" -eq "$elements" ] || fail "$images of $elements pictures were decoded"
echo "report_page: $images pictures, no errors"
