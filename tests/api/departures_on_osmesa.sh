#!/bin/sh
# The tests of named departures again, on OSMesa where it is installed: each still is one.
set -u
build=${BUILD:-build}
case "$build" in *asan*) exit 0 ;; esac # Mesa under AddressSanitizer reports its own leaks
if ! "$build/bin/fixedgl" info libOSMesa.so.8 >/dev/null 2>&1; then
    echo "OSMesa is not installed: nothing to see"
    exit 0
fi
failed=0
for test in api/departures api/departures_drawn api/departures_pixels api/departures_textures oracle/departures; do
    if ! LD_PRELOAD=libOSMesa.so.8 MESA_SHADER_CACHE_DISABLE=true "$build/tests/$test"; then
        echo "$test fails on OSMesa"
        failed=1
    fi
done
exit $failed
