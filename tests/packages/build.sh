#!/bin/sh
# Puts the programs of Debian packages where `fixedgl diff` looks for them, as links, scripts or compiled from the package's
# source: C demos of GLE tubing, and the redbook's and other examples in Haskell of the GLUT package there.
# usage: build.sh DIRECTORY LIBRARIES
set -eu
dir=$1 lib=$(cd "$2" && pwd)
mkdir -p "$dir"
dir=$(cd "$dir" && pwd)

script() { # script NAME COMMAND...
    name=$1
    shift
    printf '#!/bin/sh\nexec %s\n' "$*" >"$dir/$name"
    chmod +x "$dir/$name"
}

awk 'BEGIN { for (i = 0; i < 200; i++) print sin(i / 10) * 5 }' >"$dir/trend.txt"
printf 'pnt p1 0 0 0\npnt p2 1 0 0\npnt p3 1 1 0\nline l1 p1 p2\nplot p all\nplus l all\n' >"$dir/cgx.fbd"
script billard-gl /usr/games/billard-gl
script trend /usr/bin/trend "$dir/trend.txt" 200
script cgx /usr/bin/cgx -b "$dir/cgx.fbd"
for p in planets tessellation glxgears; do
    script "perl-$p" perl -I /usr/share/doc/libopengl-perl/examples "/usr/share/doc/libopengl-perl/examples/$p.pl"
done

# Sources of each program as the package's makefile has them.
examples=/usr/share/doc/gle-doc/examples
mkdir -p "$dir/gle"
cp -r $examples/. "$dir/gle"
gunzip -f "$dir"/gle/*.gz 2>/dev/null || true
sed -n 's/^\([a-z0-9]*\)_SOURCES *= */\1 /p' "$dir/gle/Makefile.examples" | while read -r name sources; do
    [ -e "$dir/gle-$name" ] && continue
    echo "  gle-$name"
    (cd "$dir/gle" && ${CC:-cc} -w -I"$OLDPWD/include" $sources -o "$dir/gle-$name" -L"$lib" -lfixedglut -lfixedgl \
        -l:libgle.so.3 -lGLU -lm -Wl,-rpath,"$lib")
done

examples=/usr/share/doc/libghc-glut-doc/examples
mkdir -p "$dir/hs"
for f in "$examples"/RedBook4/*.hs* "$examples"/BOGLGP/*/*.hs* "$examples"/Misc/Gears.hs* "$examples"/Misc/ExtractContours.hs*; do
    name=$(basename "${f%.gz}" .hs)
    case "$f" in *BOGLGP*) name=$(basename "$(dirname "$f")")-$name ;; esac
    [ -e "$dir/hs-$name" ] || [ "$name" = ReadImage ] && continue
    echo "  hs-$name"
    mkdir -p "$dir/hs/$name"
    cp -r "$examples/RedBook4/." "$dir/hs/$name"
    gunzip -rf "$dir/hs/$name" 2>/dev/null || true
    (zcat -f "$f") >"$dir/hs/$name/$name.hs"
    (cd "$dir/hs/$name" && ghc -O0 -v0 -main-is Main "$name.hs" -o program)
    script "hs-$name" "sh -c 'cd $dir/hs/$name && exec ./program'"
done
