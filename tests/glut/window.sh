#!/bin/sh
# The windowed path: a screenshot of a real window, under Xvfb, equals the headless picture byte for byte; a
# headless run loads neither GLFW nor X; a program without a display says so and ends well.
set -eu
BUILD=${BUILD:-build}
work=$(mktemp -d)
server=""
program=""
cleanup() {
    [ -z "$program" ] || kill "$program" 2>/dev/null || true
    [ -z "$server" ] || kill "$server" 2>/dev/null || true
    rm -rf "$work"
}
trap cleanup EXIT
unset DISPLAY WAYLAND_DISPLAY FIXEDGL_CAPTURE FIXEDGL_CAPTURE_DEPTH FIXEDGL_EVENTS FIXEDGL_FRAMES \
    FIXEDGL_HEADLESS FIXEDGL_SIZE

fail() {
    echo "$*" >&2
    exit 1
}

# Runs COMMAND until it succeeds, for ten seconds at most.
retry() {
    tries=0
    until "$@"; do
        tries=$((tries + 1))
        [ $tries -lt 50 ] || return 1
        sleep 0.2
    done
}

start_server() {
    command -v Xvfb >/dev/null || fail "Xvfb is not installed (Debian: xvfb)"
    command -v import >/dev/null || fail "import is not installed (Debian: imagemagick)"
    Xvfb -displayfd 3 -screen 0 1024x768x24 -nolisten tcp 3>"$work/display" 2>"$work/Xvfb.log" &
    server=$!
    retry test -s "$work/display" || fail "Xvfb does not start: $(cat "$work/Xvfb.log")"
    DISPLAY=:$(cat "$work/display")
}

# With no window manager the window is at the top left corner, without a frame.
screenshot_equals() { # screenshot_equals WIDTHxHEIGHT PICTURE.rgb
    DISPLAY=$DISPLAY timeout 10 import -silent -window root -crop "$1+0+0" +repage -depth 8 "rgb:$work/window.rgb" \
        2>"$work/import.log" && cmp -s "$work/window.rgb" "$2"
}

check_window() { # check_window EXAMPLE
    FIXEDGL_CAPTURE="$work/headless.png" "$BUILD/examples/$1"
    size=$(identify -format '%wx%h' "$work/headless.png")
    convert "$work/headless.png" -depth 8 "rgb:$work/headless.rgb"
    DISPLAY=$DISPLAY "$BUILD/examples/$1" 2>"$work/program.log" &
    program=$!
    if ! retry screenshot_equals "$size" "$work/headless.rgb"; then
        cat "$work/program.log" "$work/import.log" >&2
        [ ! -e "$work/window.rgb" ] ||
            echo "bytes that differ: $(cmp -l "$work/window.rgb" "$work/headless.rgb" | wc -l)" >&2
        fail "$1: the window does not show the headless picture"
    fi
    kill "$program"
    wait "$program" 2>/dev/null || true
    program=""
    echo "$1: window and headless picture are equal"
}

loaded=$(LD_DEBUG=files FIXEDGL_FRAMES=1 "$BUILD/examples/light" 2>&1 | grep -E 'needed by|calling init' || true)
[ -n "$loaded" ] || fail "LD_DEBUG told nothing about the libraries loaded"
if echo "$loaded" | grep -E 'libglfw|libX11|libxcb|libwayland'; then
    fail "a headless run loads a window system's libraries"
fi

message=$("$BUILD/examples/light" 2>&1) || fail "without a display, light fails"
case $message in
*FIXEDGL_CAPTURE*) ;;
*) fail "without a display, light does not say what to set: $message" ;;
esac

start_server
check_window light   # single buffered
check_window teapots
check_window planet  # double buffered
