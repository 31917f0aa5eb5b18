#!/bin/sh
# A short comparison of random command streams with OSMesa, always the same ones, after the scripts of differences that were found and
# mended: part of make test.
set -eu
BUILD=${BUILD:-build}
program=$BUILD/tests/fuzz/fuzz_diff
if ! "$BUILD/bin/fixedgl" info "${OSMESA:-libOSMesa.so.8}" >/dev/null 2>&1; then
    echo "skipped: there is no libOSMesa.so.8 to compare with"
    exit 0
fi
[ -x "$program" ] || { echo "$program is not built"; exit 1; }
set -- "$BUILD/lib/libfixedgl.so" "${OSMESA:-libOSMesa.so.8}"
status=0
for script in "$(dirname "$0")"/scripts/*.txt; do
    printf '%s: ' "$script"
    "$program" --script "$script" "$@" || status=1
done
"$program" --seed 1 --count 50 --seconds 90 --show 3 --tries 100 "$@" || status=1
exit $status
