#!/bin/sh
# fixedgl plan: what it says of the examples, whose scenes are known.
set -u
build=${BUILD:-build}
plan() { "$build/bin/fixedgl" plan "$@" 2>&1; }
failed=0
expect() { # expect TEXT OUTPUT-OF ARGUMENT...
    text=$1
    shift
    if ! plan "$@" | grep -q -e "$text"; then
        echo "fixedgl plan $*: no line has: $text"
        plan "$@" | sed 's/^/    /'
        failed=1
    fi
}
light=$build/examples/light
expect '^48 draws with 1 plan' "$light"
expect '^  lighting    1 light, object space, infinite viewer$' "$light"
expect 'GL_LIGHT0 directional, highlight$' "$light"
expect 'GL_LIGHT0  *vector to it (directional); attenuation (directional); spot (cutoff 180); half vector' "$light"
expect '7 lights  *disabled' "$light"
expect 'fog  *GL_FOG is off' "$light"
expect '^    clip and window coordinates  *[0-9.]*$' "$light"
expect '^        highlight  *-*[0-9.]*$' "$light"
expect '^  ns per pixel  *[0-9.]*$' "$light"
expect 'GL_LIGHT1  *all: every product of its colours and the material' "$build/examples/scene" --events 'key 3'
expect 'two-sided' "$build/examples/two-sided"
expect '^      back faces  *-*[0-9.]*$' "$build/examples/two-sided"
expect 'positional, attenuated, spot' "$build/examples/spot-attenuation"
expect '^        attenuation  *-*[0-9.]*$' "$build/examples/spot-attenuation"
expect 'lighting  *GL_LIGHTING is off' "$build/examples/smooth"
expect '^96 draws' "$light" --events 'key +'
expect '^fixedgl: plan: which program' --frames 1
expect '^fixedgl: plan: --frames cannot be .0.' "$light" --frames 0
expect '^fixedgl: plan: cannot start no-such-program' no-such-program
expect '^fixedgl: plan: .* drew nothing with FixedGL' /bin/true

# the lights that add nothing cost nothing: their terms are not in the plan
if plan "$light" | grep -q 'GL_LIGHT1'; then
    echo "a disabled light is in the plan"
    failed=1
fi
exit $failed
