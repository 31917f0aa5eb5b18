#!/bin/sh
# Runs one step of a long job and says how long it took; what the step prints is shown only where it fails.
# usage: step.sh NAME COMMAND...
set -u
name=$1
shift
log=$(mktemp) || exit 2
trap 'rm -f "$log"' EXIT
start=$(date +%s)
if "$@" >"$log" 2>&1; then
    echo "$name: $(($(date +%s) - start)) s"
else
    status=$?
    tail -n 60 "$log"
    echo "$name: failed after $(($(date +%s) - start)) s"
    exit $status
fi
