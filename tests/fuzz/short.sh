#!/bin/sh
# A short comparison of random command streams with OSMesa, always the same ones: part of make test.
set -eu
BUILD=${BUILD:-build}
program=$BUILD/tests/fuzz/fuzz_diff
if ! "$BUILD/bin/fixedgl" info "${OSMESA:-libOSMesa.so.8}" >/dev/null 2>&1; then
    echo "skipped: there is no libOSMesa.so.8 to compare with"
    exit 0
fi
[ -x "$program" ] || { echo "$program is not built"; exit 1; }
exec "$program" --seed 1 --count 50 --seconds 90 --show 3 --tries 100 "$BUILD/lib/libfixedgl.so" "${OSMESA:-libOSMesa.so.8}"
