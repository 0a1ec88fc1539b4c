#!/bin/sh
# Draws the captures that TWOFOLD_EVIDENCE names; without it the test is skipped, and says so.
# usage: run.sh EVIDENCE_PROGRAM
if [ -z "${TWOFOLD_EVIDENCE:-}" ]; then
    echo "SKIPPED: TWOFOLD_EVIDENCE does not name a pack of captures; NOTHING was compared with silicon"
    exit 77
fi
exec "$1" "$TWOFOLD_EVIDENCE"
