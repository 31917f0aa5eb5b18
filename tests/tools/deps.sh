#!/bin/sh
# Installs the Debian packages that building, comparing and testing need and that are missing. Quiet when there is nothing to do.
# Where there is no apt-get, or no right to use it, prints the command instead.
# usage: deps.sh [PACKAGE...]    the packages given are wanted besides
set -eu
packages="gcc make clang libc6-dev libpng-dev libglu1-mesa-dev libglfw3-dev libosmesa6 libcmocka-dev
          xvfb imagemagick libgl1-mesa-dri libclang-rt-14-dev $*"
missing=""
if command -v dpkg-query >/dev/null 2>&1; then
    for p in $packages; do
        dpkg-query -W -f='${Status}' "$p" 2>/dev/null | grep -q 'ok installed' || missing="$missing $p"
    done
    [ -n "$missing" ] || exit 0
    echo "missing packages:$missing"
    if command -v apt-get >/dev/null 2>&1 && [ "$(id -u)" = 0 ]; then
        export DEBIAN_FRONTEND=noninteractive
        apt-get update -qq >/dev/null
        # shellcheck disable=SC2086
        apt-get install -y -qq --no-install-recommends $missing >/dev/null
        exit 0
    fi
    echo "install them with: apt-get install --no-install-recommends$missing"
    exit 1
fi
echo "not a Debian system; install the equivalents of:" $packages
