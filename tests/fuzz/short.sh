#!/bin/sh
# A short comparison of random command streams with OSMesa, always the same ones: part of make test.
set -eu
BUILD=${BUILD:-build}
program=$BUILD/tests/fuzz/fuzz_diff
if ! ldconfig -p 2>/dev/null | grep -q 'libOSMesa\.so\.8' && ! [ -e "${OSMESA:-/nonexistent}" ]; then
    echo "skipped: there is no libOSMesa.so.8 to compare with"
    exit 0
fi
[ -x "$program" ] || { echo "$program is not built"; exit 1; }
exec "$program" --seed 1 --count 50 --seconds 18 --show 3 --tries 100 "$BUILD/lib/libfixedgl.so" "${OSMESA:-libOSMesa.so.8}"
