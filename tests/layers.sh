#!/bin/sh
# The layers of the design as a check on includes: each folder of src/ may include only itself and those before it.
set -eu
order="base state framebuffer texture vertex fragment raster pipeline api osmesa"
status=0
allowed=""
for layer in $order; do
    allowed="$allowed $layer"
    [ "$layer" = texture ] && deny="framebuffer" || deny=""
    [ "$layer" = fragment ] && deny="vertex"
    [ "$layer" = raster ] && deny="vertex"
    for f in src/"$layer"/*.[ch] src/"$layer"/*.def; do
        [ -e "$f" ] || continue
        for used in $(sed -n 's|^#include "\([a-z]*\)/.*|\1|p' "$f" | sort -u); do
            ok=no
            for a in $allowed; do
                [ "$used" = "$a" ] && ok=yes
            done
            [ "$used" = "$deny" ] && ok=no
            [ "$used" = GL ] && ok=yes
            if [ $ok = no ]; then
                echo "$f includes $used/, which is not below $layer"
                status=1
            fi
        done
    done
done
for f in src/glut/*.[ch] src/oracle/*.[ch] src/cli/*.[ch] src/dropin/*.c; do # public headers and their own
    for used in $(sed -n 's|^#include "\(.*\)"|\1|p' "$f"); do
        own=$(dirname "$f")
        case "$used" in GL/*|fixedgl.h) continue ;; esac
        if [ ! -e "$own/$used" ] && [ ! -e "src/$used" -o "$(dirname "src/$used")" != "$own" ]; then
            echo "$f includes $used"
            status=1
        fi
    done
done
exit $status
