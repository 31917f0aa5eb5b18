#!/bin/sh
# The same bytes from every build: GCC and Clang, -O0 and -O3, each instruction set of this machine, and the general path.
# Every picture of the list is drawn by each; the first build is what the others are compared with.
# usage: tests/identity.sh [build folder that has the examples]
set -eu
BUILD=${1:-build}
jobs=$(getconf _NPROCESSORS_ONLN 2>/dev/null || echo 2)
out=$BUILD/identity
rm -rf "$out/pictures"
mkdir -p "$out/pictures"

# draw LIBDIR NAME: checksums of colour and depth of every picture, in $out/NAME
draw() {
    : >"$out/$2"
    grep -v '^ *\(#\|$\)' examples/pictures.txt | while read -r name program size events; do
        LD_LIBRARY_PATH=$1 FIXEDGL_SIZE=$size FIXEDGL_EVENTS=$events FIXEDGL_CAPTURE=$out/pictures/p.pam \
            FIXEDGL_CAPTURE_DEPTH=$out/pictures/p.depth "$BUILD/examples/$program" >/dev/null
        # the second line of a picture names who drew it, instruction set and all
        echo "$name $(LC_ALL=C sed 2d "$out/pictures/p.pam" | cat - "$out/pictures/p.depth" | cksum)" >>"$out/$2"
    done
}

compare() { # compare NAME
    if cmp -s "$out/reference" "$out/$1"; then
        echo "  same bytes  $1"
    else
        echo "  DIFFERENT   $1: $(diff "$out/reference" "$out/$1" | sed -n 's/^> \([^ ]*\).*/\1/p' | tr '\n' ' ')"
        return 1
    fi
}

status=0
draw "$BUILD/lib" reference
echo "$(wc -l <"$out/reference") pictures, the reference is $BUILD/lib"
for isa in base sse2 avx2 avx512; do
    FIXEDGL_ISA=$isa draw "$BUILD/lib" "isa-$isa"
    compare "isa-$isa" || status=1
done
FIXEDGL_PATH=general draw "$BUILD/lib" general-path
compare general-path || status=1
for cc in gcc clang; do
    for opt in -O0 -O3; do
        name=$cc$opt
        make -s -j"$jobs" libs CC=$cc OPT=$opt BUILD="$out/build-$name" >"$out/$name.log" 2>&1 || { cat "$out/$name.log"; exit 1; }
        draw "$out/build-$name/lib" "$name"
        compare "$name" || status=1
    done
done
exit $status
