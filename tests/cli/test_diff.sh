#!/bin/sh
# `fixedgl diff` from outside: exit codes, what it counts, what it says. Usage: test_diff.sh [PATH/TO/fixedgl]
# Programs and reference are stand-ins, so neither FixedGL nor Mesa is needed; a C compiler is ($CC, cc).
fixedgl=$(realpath "${1:-${BUILD:-build}/bin/fixedgl}") || exit 2
here=$(dirname "$(realpath "$0")")
work=$(mktemp -d) || exit 2
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 2
failures=0
checks=0

check() { # description, then a command that must succeed
    description=$1
    shift
    checks=$((checks + 1))
    "$@" && return
    failures=$((failures + 1))
    echo "FAILED: $description"
    sed 's/^/    | /' output
}

# Runs fixedgl with the arguments after the first, which is the exit code it must return.
run() {
    expected=$1
    shift
    "$fixedgl" "$@" >output 2>&1
    code=$?
    check "exit code $expected, not $code, from: $*" [ "$code" = "$expected" ]
}

diff_pictures() { # expected exit code, options
    expected_code=$1
    shift
    run "$expected_code" diff --pictures list --examples programs --departures departures --output report \
        --osmesa ./fake-osmesa.so --reference osmesa --timeout 20 "$@"
}

says() { check "says '$1'" grep -qF -- "$1" output; }
says_not() { check "does not say '$1'" sh -c '! grep -qF -- "$1" output' sh "$1"; }

# A table row with these numbers: picture, differ, by 1, by 2-8, more, coverage, depth.
row() {
    check "row: $*" awk -v want="$*" '{ row = $1; for (i = 3; i <= NF; i++) row = row " " $i; if (row == want) found = 1 }
        END { exit !found }' output
}

setup() {
    mkdir programs
    for name in same one five alpha depth coverage size crash crash-reference cheat static mute hang silent status bits16 \
        events clean grown short long short-depth flat; do
        ln -s "$here/fake_program" programs/$name
    done
    cat >fake.c <<'END'
typedef struct context *OSMesaContext;
static int one;
OSMesaContext OSMesaCreateContextExt(unsigned f, int d, int s, int a, OSMesaContext share)
{
    (void)f, (void)d, (void)s, (void)a, (void)share;
    return (OSMesaContext)&one;
}
unsigned char OSMesaMakeCurrent(OSMesaContext c, void *b, unsigned t, int w, int h)
{
    (void)c, (void)b, (void)t, (void)w, (void)h;
    return 1;
}
void OSMesaDestroyContext(OSMesaContext c) { (void)c; }
const char *glGetString(unsigned name)
{
    return name == 0x1F00 ? "fake vendor" : name == 0x1F01 ? "fake reference" : name == 0x1F02 ? "4.5 Fake" : "GL_A GL_B";
}
END
    ${CC:-cc} -shared -fPIC -o fake-osmesa.so fake.c || exit 2
    : >departures
}

test_command_line() {
    run 2
    check "one line" [ "$(wc -l <output)" = 1 ]
    run 2 nonsense
    says "there is no subcommand 'nonsense'"
    check "one line" [ "$(wc -l <output)" = 1 ]
    run 0 --help
    says "  diff "
    run 0 --version
    says "fixedgl "
    run 0 diff --help
    says "--record"
    run 2 diff --nonsense
    run 2 diff --jobs 0
    run 2 diff --timeout x
    run 2 diff --reference mesa
    says "--reference cannot be 'mesa'"
    run 2 diff --pictures
    run 2 diff --record goldens same
    run 0 info ./fake-osmesa.so
    says "GL_RENDERER: fake reference"
    says "extension: GL_B"
    run 2 info ./no-such-library.so
    run 0 info
}

test_lists() {
    rm -f list
    diff_pictures 2
    says "list: No such file or directory"
    for line in 'same same' 'same same 4' 'same same 0x2' 'same same 4x99999' '../x same 4x2' '.x same 4x2' \
        'same same 4x2;' '# nothing'; do
        echo "$line" >list
        diff_pictures 2
        check "nothing is drawn for '$line'" [ ! -e report ]
    done
    printf 'same same 4x2\n\n  # comment\nsame one 4x2\n' >list
    diff_pictures 2
    says "list:4: picture 'same' is listed twice"
    echo 'same same 4x2' >list
    diff_pictures 2 other
    says "there is no picture 'other'"
    diff_pictures 2 --osmesa ./no-such-library.so
    says "no-such-library.so"
    printf 'same same 4x2\none one 4x2\n' >list
    diff_pictures 0 same
    says_not "one  "
    rm list # programs by path need none
    diff_pictures 1 programs/same programs/one
    row same 0 0 0 0 0 0
    row one 1 1 0 0 0 0
    diff_pictures 0 --events 'click left 100 200; key a; wait 2' programs/events
    diff_pictures 2 programs/same one
    says "'one' is no path"
    diff_pictures 2 programs/same ./programs/same
    says "listed twice"
    diff_pictures 2 --events 'key a' same
}

test_counts() {
    cat >list <<'END'
# name program size events
same same 4x2
events events 4x2   click left 100 200; key a; wait 2
clean clean 4x2
flat flat 4x2
grown grown 6x2
END
    FIXEDGL_PATH=general FIXEDGL_EVENTS='key q' FIXEDGL_FRAMES=7 GALLIUM_DRIVER=softpipe diff_pictures 0
    row same 0 0 0 0 0 0
    row flat 0 0 0 0 - -
    check "the size that was drawn" grep -q '^grown  *7x2 ' output
    says "5 pictures: 5 identical, 0 by named departures, 0 differ, 0 failed"
    says "reference: fake reference, 4.5 Fake"
    printf '%s\n' 'one one 4x2' 'five five 4x2' 'alpha alpha 4x2' 'depth depth 4x2' 'coverage coverage 4x2' \
        'same same 4x2' >list
    for jobs in 1 2 9; do
        diff_pictures 1 --jobs $jobs
        row one 1 1 0 0 0 0
        row five 1 0 1 0 0 0
        row alpha 1 0 0 1 0 0
        row depth 1 0 0 0 0 1
        row coverage 1 0 0 1 1 1
        row same 0 0 0 0 0 0
        says "6 pictures: 1 identical, 0 by named departures, 5 differ, 0 failed"
    done
    says "first: x 0, row 0 from the top (window y 1): FixedGL 100 100 100 255 depth 1193046, reference 100 101 100 255 depth 1193046"
    says "FixedGL 100 100 100 255 depth 1193046, reference 0 0 0 0 depth 16777215"
}

test_failures() {
    for name in size crash crash-reference cheat static mute hang silent status short long short-depth absent; do
        echo "$name $name 4x2"
    done >list
    diff_pictures 1 --timeout 0.5
    says "13 pictures: 0 identical, 0 by named departures, 0 differ, 13 failed"
    says "FixedGL drew 4x2, the reference 5x2"
    says "FAILED: FixedGL: crashed: signal 11"
    says "FAILED: reference: crashed: signal 11"
    says "both pictures were drawn by fake reference"
    says "reference: drawn by fake ours, not by fake reference"
    says "reference: its picture does not say which GL_RENDERER drew it"
    says "FixedGL: did not end within 0.5 s and was killed"
    says "FixedGL: wrote no picture: no <display> & no"
    says "FixedGL: exited with status 3: cannot open display"
    says "short.fixedgl.pam is not a whole PAM picture"
    says "long.fixedgl.pam is not a whole PAM picture"
    says "short-depth.fixedgl.depth is not a whole depth buffer"
    says "FixedGL: cannot start programs/absent"
    check "the report escapes text" grep -q 'no &lt;display&gt; &amp; no &quot;picture' report/index.html
    # Files left by an earlier run, even by one that was killed, are not taken for pictures.
    echo 'x same 4x2' >list
    diff_pictures 0
    mkdir report/scratch
    for side in fixedgl reference; do
        FIXEDGL_SIZE=4x2 FIXEDGL_CAPTURE=report/scratch/x.$side.pam \
            FIXEDGL_CAPTURE_DEPTH=report/scratch/x.$side.depth programs/same
    done
    echo 'x silent 4x2' >list
    diff_pictures 1
    check "no picture of an earlier run in the report" [ ! -e report/x.fixedgl.png ]
}

test_departures() {
    printf '%s\n' 'one one 4x2' 'same same 4x2' >list
    echo 'one rounding 1 OSMesa rounds the other way' >departures
    diff_pictures 0
    says "named departure: rounding"
    says "2 pictures: 1 identical, 1 by named departures, 0 differ, 0 failed"
    diff_pictures 0 same
    echo 'one rounding 2 OSMesa rounds the other way' >departures
    diff_pictures 1
    says "its departures (rounding) account for exactly 2 pixels, but 1 differ"
    printf '%s\n' 'one rounding 1 reason' 'one cone 1 reason' >departures
    diff_pictures 1
    says "its departures (rounding, cone) account for exactly 2 pixels, but 1 differ"
    printf '%s\n' 'one rounding 1 reason' 'same rounding 1 reason' >departures
    diff_pictures 1
    says "its departures (rounding) account for exactly 1 pixels, but 0 differ"
    for line in 'other rounding 1 reason' 'one rounding 1' 'one rounding 0 reason' 'one rounding -1 reason' \
        'one rounding'; do
        echo "$line" >departures
        diff_pictures 2
        says "departures:1: "
    done
    : >departures
    diff_pictures 1
}

# Pictures that the reference cannot draw.
test_undrawn() {
    printf '%s\n' 'same same 4x2' 'crash-reference crash-reference 4x2' >list
    echo 'crash-reference indexes undrawn the reference has no such mode' >departures
    diff_pictures 0
    says "2 pictures: 1 identical, 0 by named departures, 0 differ, 0 failed, 1 not drawn by the reference"
    says "not drawn by the reference: indexes"
    check "drawn all the same" [ -e report/crash-reference.fixedgl.png ]
    check "the report counts it" grep -q '1 not drawn by the reference' report/index.html
    echo 'same indexes undrawn the reference has no such mode' >departures
    diff_pictures 1
    says "the reference draws it, but departures says that it cannot"
    printf '%s\n' 'crash crash 4x2' >list
    echo 'crash indexes undrawn the reference has no such mode' >departures
    diff_pictures 1
    says "FAILED: FixedGL: crashed: signal 11"
    for line in 'crash indexes undrawn' 'crash indexes undrawable reason' 'crash indexes 1x reason'; do
        echo "$line" >departures
        diff_pictures 2
        says "departures:1: "
    done
    for pixels in 1 undrawn; do
        printf '%s\n' "crash a $pixels reason" 'crash b undrawn reason' >departures
        diff_pictures 2
        says "departures:2: "
    done
    : >departures
}

test_goldens() {
    printf '%s\n' 'same same 4x2' 'flat flat 4x2' 'five five 4x2 key a' >list
    diff_pictures 0 --record goldens
    check "RGBA PNG" [ -s goldens/same.png ]
    check "depth PNG" [ -s goldens/same.depth.png ]
    check "no depth PNG without depth" [ ! -e goldens/flat.depth.png ]
    for fact in 'GL_RENDERER: fake reference' 'GL_VERSION: 4.5 Fake' 'CPU FMA: yes' \
        'MESA_SHADER_CACHE_DISABLE: true' 'picture: five five 4x2 key a'; do
        check "GOLDENS.txt has '$fact'" grep -qxF "$fact" goldens/GOLDENS.txt
    done
    cp -r goldens again
    diff_pictures 0 --record again
    check "recording again changes no byte" diff -r goldens again
    echo 'same indexes undrawn the reference has no such mode' >departures
    diff_pictures 0 --record fewer
    says "2 goldens in fewer"
    check "no golden of what is not drawn" [ ! -e fewer/same.png ]
    diff_pictures 0 --reference goldens --goldens fewer same
    says "1 not drawn by the reference"
    : >departures
    # The goldens hold what the reference drew, not what FixedGL draws.
    with_goldens="--reference goldens --goldens goldens"
    diff_pictures 1 $with_goldens
    row same 0 0 0 0 0 0
    row flat 0 0 0 0 - -
    row five 1 0 1 0 0 0
    says "reference 95 100 100 255 depth 1193046"
    diff_pictures 0 $with_goldens same flat
    diff_pictures 0 --reference auto --osmesa ./no-such-library.so --goldens goldens same
    says "comparing with goldens: "
    says "reference: goldens in goldens, recorded from fake reference, 4.5 Fake"
    echo 'same cheat 4x2' >list
    sed 's/same same/same cheat/' goldens/GOLDENS.txt >kept && mv kept goldens/GOLDENS.txt
    diff_pictures 1 $with_goldens
    says "both pictures were drawn by fake reference"
    echo 'same same 4x2' >list
    sed 's/same cheat/same same/' goldens/GOLDENS.txt >kept && mv kept goldens/GOLDENS.txt
    diff_pictures 2 --reference goldens --goldens no-such-folder
    mv goldens/same.depth.png kept
    diff_pictures 1 $with_goldens same
    says "FixedGL has 24 bits of depth, the reference 0"
    mv kept goldens/same.depth.png
    mv goldens/same.png kept
    diff_pictures 1 $with_goldens same
    says "FAILED: golden missing: goldens/same.png"
    head -c 60 kept >goldens/same.png
    diff_pictures 1 $with_goldens same
    says "FAILED: goldens/same.png"
    mv kept goldens/same.png
    printf '%s\n' 'same same 4x2 key b' 'flat flat 4x2' 'new same 4x2' >list
    diff_pictures 1 $with_goldens
    says 'golden out of date: recorded for `same same 4x2`'
    says "golden missing: goldens/GOLDENS.txt does not name it"
    printf '%s\n' 'bits16 bits16 4x2' 'status status 4x2' 'static static 4x2' >list
    diff_pictures 1 --record partial
    says "goldens hold 24 bits of depth, not 16"
    says "exited with status 3"
    says "drawn by fake ours"
    check "no golden of what the reference did not draw" [ ! -e partial/static.png ]
    check "no GOLDENS.txt after a failure" [ ! -e partial/GOLDENS.txt ]
}

test_report() {
    printf '%s\n' 'same same 4x2' 'one one 4x2' 'alpha alpha 4x2' 'crash crash 4x2' 'flat flat 4x2' >list
    diff_pictures 1
    page=report/index.html
    check "worst first" [ "$(grep -o 'id="[a-z]*"' $page | tr -d '\n')" = 'id="crash"id="alpha"id="one"id="same"id="flat"' ]
    check "no network, no absolute path" sh -c "! grep -qE 'https?:|(src|href)=\"/' $page"
    check "all pictures it shows exist" sh -c "cd report && ls $(grep -oE '(src|href)="[^"]*"' $page |
        sed 's/.*="//; s/"//' | sort -u | tr '\n' ' ') >/dev/null"
    check "difference picture" [ -s report/one.difference.png ]
    check "no difference picture of equal ones" [ ! -e report/same.difference.png ]
    check "nothing left behind" [ ! -e report/scratch ]
    check "first pixel" grep -q 'reference 100 101 100 255 depth 1193046' $page
}

setup
test_command_line
test_lists
if ! "$fixedgl" info | grep -q 'FMA *yes'; then
    echo "this CPU has no FMA: goldens must not be recorded"
    diff_pictures 2 --record goldens
else
    test_goldens
fi
test_counts
test_failures
test_departures
test_undrawn
test_report
echo "test_diff.sh: $checks checks, $failures failed"
[ $failures = 0 ]
