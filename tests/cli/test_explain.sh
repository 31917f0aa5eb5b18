#!/bin/sh
# The command line of fixedgl explain: forms, frames, and one clear line for each mistake.
set -u
build=${BUILD:-build}
light=$build/examples/light
failed=0
expect() { # expect STATUS TEXT ARGUMENT...
    status=$1
    text=$2
    shift 2
    output=$("$build/bin/fixedgl" explain "$@" 2>&1)
    got=$?
    if [ $got -ne "$status" ] || ! echo "$output" | grep -q -e "$text"; then
        echo "fixedgl explain $*: status $got, expected $status with: $text"
        echo "$output" | sed 's/^/    /'
        failed=1
    fi
}
expect 0 '^Made by draw 4, glDrawElements 1 of GL_TRIANGLE_STRIP: triangle 77, front$' "$light" --pixel 210,280
expect 0 '^  = the pixel                254 139 107 255$' "$light" --pixel 210,280
expect 0 '^Vertices *vertex 2: number 79$' "$light" --pixel 210,280 --vertex 2
expect 0 '^{"pixel":\[210,280\],"size":\[500,500\],"color":\[254,139,107,255\]' "$light" --pixel 210,280 --json
expect 0 'Nothing was drawn here. It is glClear' "$light" --pixel 3,3
expect 0 '^Pixel 3, 3 of 64 x 32' "$light" --pixel 3,3 --size 64x32
expect 0 'drawn  ' "$build/examples/planet" --pixel 250,250 --frame 3 --events 'key d'
expect 0 '^  = the pixel                118$' "$build/examples/fogindex" --pixel 100,100
expect 2 '^fixedgl: explain: pixel 600,3 is outside of the picture, 500 x 500 pixels$' "$light" --pixel 600,3
expect 2 '^fixedgl: explain: which pixel?' "$light"
expect 2 '^fixedgl: explain: which program?' --pixel 1,1
expect 2 '^fixedgl: explain: --pixel cannot be .1;1.$' "$light" --pixel '1;1'
expect 2 '^fixedgl: explain: --vertex cannot be .3.$' "$light" --pixel 1,1 --vertex 3
expect 2 'not an option' "$light" --pixel 1,1 --colour
expect 2 '^fixedgl: explain: cannot start no-such-program' no-such-program --pixel 1,1
expect 2 '^fixedgl: explain: .* drew nothing with FixedGL$' /bin/true --pixel 1,1
if [ "$(echo "$output" | wc -l)" -ne 1 ]; then
    echo "a mistake takes more than one line"
    failed=1
fi
exit $failed
