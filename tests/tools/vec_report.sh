#!/bin/sh
# Lists the loops of the kernels that a compiler did not vectorise: file, line, how many instances, the loop itself.
# Loops that merely hold loops are left out. Expected: only the general kernels, which take their flags at run time (one
# instance each), and the loops over a handful of planes, faces or lights that choose kernels.
# usage: tests/tools/vec_report.sh [compiler...]; default: gcc clang, for AVX2 where the machine is x86-64
set -u
cd "$(dirname "$0")/../.." || exit 1
common='-std=c11 -O3 -ffp-contract=off -fno-math-errno -fno-trapping-math -Iinclude -Isrc'

report() { # report COMPILER FILE: "path:line" of each loop that was missed
    case "$("$1" -dumpmachine)" in
    x86_64*) isa='-DFGL_ISA=avx2 -mavx2 -mfma -mtune=skylake' ;;
    *) isa='-DFGL_ISA=base' ;;
    esac
    case "$("$1" --version)" in
    *clang*) "$1" $common $isa -Rpass-missed=loop-vectorize -c "$2" -o /dev/null 2>&1 | grep 'remark: loop not vectorized' ;;
    *) "$1" $common $isa -fopt-info-vec-missed -c "$2" -o /dev/null 2>&1 | grep "couldn't vectorize loop" ;;
    esac | sed 's|^\./||; s|^\([^:]*:[0-9]*\):.*|\1|'
}

for compiler in ${*:-gcc clang}; do
    command -v "$compiler" >/dev/null || continue
    for kernels in src/*/kernels.c; do
        echo "$compiler, $kernels:"
        report "$compiler" "$kernels" | sort | uniq -c | while read -r count place; do
            file=${place%:*}
            line=${place##*:}
            if ! sed -n "$((line + 1)),$((line + 2))p" "$file" | grep -q 'for ('; then
                printf '  %-40s %3d  %s\n' "$place" "$count" "$(sed -n "${line}s/^ *//p" "$file")"
            fi
        done
    done
done
