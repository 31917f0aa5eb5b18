#!/bin/sh
# The same bytes from every build: GCC and Clang, -O0 and -O3, each instruction set of this machine, and the general path; in
# exact mode too. Every picture of the list is drawn with each by the examples of one build, JOBS at once.
# usage: tests/identity.sh [build folder of GCC -O3, which has the examples [build folder of Clang -O3]]
set -eu

# left_out NAME: a pattern of the pictures that it does not draw: -O0 is slow, and these draw their scene sixty times over
left_out() {
    case "$1" in *-O0) echo '^softshadow-\|^dof-' ;; *) echo '^ *#\|^ *$' ;; esac
}

# draw NAME LIBDIR [VARIABLE=VALUE...]: checksums of colour and depth of every picture, in $out/NAME
draw() {
    name=$1
    export LD_LIBRARY_PATH="$2"
    shift 2
    [ $# = 0 ] || export "$@"
    scratch=$out/pictures/$name
    grep -v '^ *#\|^ *$' examples/pictures.txt | grep -v "$(left_out "$name")" | while read -r picture program size events; do
        FIXEDGL_SIZE=$size FIXEDGL_EVENTS=$events FIXEDGL_CAPTURE=$scratch.pam FIXEDGL_CAPTURE_DEPTH=$scratch.depth \
            "$BUILD/examples/$program" >/dev/null
        # the second line of a picture names who drew it, instruction set and all
        echo "$picture $(LC_ALL=C sed 2d "$scratch.pam" | cat - "$scratch.depth" | cksum)"
    done >"$out/$name"
    sed -n 's/^# GL_RENDERER: //p;2q' "$scratch.pam" >"$out/$name.renderer"
}

# The draws, slowest first: NAME LIBDIR [VARIABLE=VALUE...]
list() {
    echo "gcc-O0 $out/build-gcc-O0/lib"
    echo "clang-O0 $out/build-clang-O0/lib"
    echo "general-path $BUILD/lib FIXEDGL_PATH=general"
    echo "gcc-O3 $BUILD/lib"
    echo "clang-O3 $clang/lib"
    echo "exact-gcc-O3 $BUILD/lib FIXEDGL_ACCURACY=exact"
    echo "exact-clang-O3 $clang/lib FIXEDGL_ACCURACY=exact"
    for isa in sse2 avx2 avx512; do
        echo "isa-$isa $BUILD/lib FIXEDGL_ISA=$isa"
        echo "exact-isa-$isa $BUILD/lib FIXEDGL_ISA=$isa FIXEDGL_ACCURACY=exact"
    done
}

compare() { # compare NAME REFERENCE
    grep -v "$(left_out "$1")" "$out/$2" >"$out/expected"
    if ! cmp -s "$out/expected" "$out/$1"; then
        echo "  DIFFERENT   $1: $(diff "$out/expected" "$out/$1" | sed -n 's/^[<>] \([^ ]*\).*/\1/p' | sort -u | tr '\n' ' ')"
        status=1
        return
    fi
    case "$1 $(cat "$out/$1.renderer")" in
    *isa-sse2*AVX* | *isa-avx2*AVX-512*) echo "  NOT DRAWN   $1: FIXEDGL_ISA is not obeyed"; status=1 ;;
    *isa-avx2*AVX2* | *isa-avx512*AVX-512* | *isa-sse2*) same="$same $1" ;;
    *isa-*) echo "  skipped     $1: not on this CPU" ;;
    *) same="$same $1" ;;
    esac
}

if [ "${1:-}" = --draw ]; then
    shift
    draw "$@"
    exit 0
fi

start=$(date +%s)
export BUILD="${1:-build}"
clang=${2:-$BUILD/clang}
jobs=${JOBS:-$(getconf _NPROCESSORS_ONLN 2>/dev/null || echo 2)}
export out="$BUILD/identity"
rm -rf "$out/pictures"
mkdir -p "$out/pictures"
for cc in gcc clang; do
    tests/tools/step.sh "build with $cc -O0" \
        make -s Q=@ -j"$jobs" "$out/build-$cc-O0/lib/libfixedgl.so" CC=$cc OPT=-O0 DEBUG= BUILD="$out/build-$cc-O0"
done
list | xargs -P "$jobs" -L 1 "$0" --draw
status=0
same=""
for name in $(list | cut -d' ' -f1); do
    case "$name" in exact-*) compare "$name" exact-gcc-O3 ;; *) compare "$name" gcc-O3 ;; esac
done
echo "$(wc -l <"$out/gcc-O3") pictures, the same bytes:$same"
echo "identity: $(($(date +%s) - start)) s"
exit $status
