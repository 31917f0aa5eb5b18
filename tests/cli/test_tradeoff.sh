#!/bin/sh
# fixedgl tradeoff: a small run writes its table and files, wrong arguments are refused, OSMesa may be absent.
set -u
build=${BUILD:-build}
out=$build/tests/tradeoff
failed=0
rm -rf "$out"
mkdir -p "$build/tests"
tradeoff() { "$build/bin/fixedgl" tradeoff --vertices 64 --out "$out" "$@" 2>&1; }
expect() { # expect TEXT OUTPUT-OF ARGUMENT...
    text=$1
    shift
    tradeoff "$@" >"$out.txt"
    if ! grep -q -e "$text" "$out.txt"; then
        echo "fixedgl tradeoff $*: no line has: $text"
        sed 's/^/    /' "$out.txt"
        failed=1
    fi
}
contains() { # contains FILE TEXT
    if ! grep -q -e "$2" "$out/$1"; then
        echo "$1 does not have: $2"
        failed=1
    fi
}
expect '^distance 1e-30 .* max .* 99.9% .* mean .* bytes .* NaN .* ns$' --only 'distance 1e-30'
expect '^  categories wrong by more than 1/255 somewhere: .*compatible 0, exact 0$' --only 'distance 1e-30'
expect 'plain float 1,' --only 'distance 1e-30'
contains tradeoff.csv '^"distance 1e-30",exact,'
contains index.html '<svg'
expect '^  pixels of wrong coverage: .*compatible 0, exact 0$' --only slivers
contains tradeoff.csv '^"slivers",compatible,'
expect 'exact  *max .* at the worst of 65 points' --only shininess
contains sweeps.csv '^"shininess",exact,128,'
expect 'index.html' --only 'nothing extreme'
contains index.html '<img src="sphere-0-exact.png"'
[ -s "$out/sphere-0-truth.png" ] || { echo 'no picture of the truth'; failed=1; }
expect '^OSMesa is left out: ' --osmesa libNoSuchLibrary.so --only 'distance 0'
expect 'somewhere:  *plain float' --osmesa libNoSuchLibrary.so --only 'distance 0'
expect "^fixedgl: tradeoff: there is no 'no such category'" --only 'no such category'
expect "^fixedgl: tradeoff: --vertices cannot be '0'" --vertices 0
expect "^fixedgl: tradeoff: --seed cannot be 'x'" --seed x
expect "^fixedgl: tradeoff: what is 'x'" x
exit $failed
