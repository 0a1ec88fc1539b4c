#!/bin/sh
# Stands in for a cluster's submission: starts the job script on its own and prints a job number.
# usage: submit.sh JOBSCRIPT
echo "$1" >>"${TWOFOLD_SUBMITTED:?}"
sh "$1" >/dev/null 2>&1 &
echo $!
