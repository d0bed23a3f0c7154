#!/usr/bin/env bash
# A real window on a display of its own: it opens, plays on a key, takes a click, takes any size and none, rests without
# work, closes cleanly; it goes on when its graphics device is lost, and keeps unsaved work when its display is.
#
#   tests/window/smoke.sh [BINARY] [WIDTHxHEIGHT]
#
# Pictures of what was seen are left in target/window. Wants Xvfb, xdotool and ImageMagick.
set -euo pipefail
cd "$(dirname "$0")/../.."

binary=${1:-}
size=${2:-1280x720}
seen=target/window
mkdir -p "$seen"

if [ -z "$binary" ]; then
  cargo build --locked --all-features --bin girderbench
  binary=target/debug/girderbench
fi

fail() {
  echo "window: $1" >&2
  exit 1
}

# shellcheck source=tests/window/display.sh
. tests/window/display.sh

# Starts the program and waits for its window.
start() {
  "$binary" >"$seen/output.txt" 2>&1 &
  program=$!
  window=''
  for _ in $(seq 200); do
    kill -0 "$program" 2>/dev/null || fail "the program ended before it had a window: $(cat "$seen/output.txt")"
    window=$(xdotool search --onlyvisible --name Girderbench 2>/dev/null | head -n 1) && [ -n "$window" ] && break
    sleep 0.1
  done
  [ -n "$window" ] || fail "no window within 20 s"
  # No window manager: the window is put into the corner, and given the keyboard.
  xdotool windowmove "$window" 0 0 windowsize "$window" "${size%x*}" "${size#*x}"
  xdotool windowfocus --sync "$window"
  xdotool mousemove 5 5
}
# Waits for the program to end by itself, and keeps its status.
ended() {
  for _ in $(seq 100); do
    kill -0 "$program" 2>/dev/null || break
    sleep 0.1
  done
  kill -0 "$program" 2>/dev/null && fail "$1"
  status=0
  wait "$program" || status=$?
  program=''
}

start

look() { import -window "$window" "$seen/$1.png"; }
# How many pixels differ; `compare` answers 1 when any does.
differ() { { compare -metric AE "$seen/$1.png" "$seen/$2.png" null: 2>&1 || true; } | awk '{ printf "%d", $1 }'; }
# Ticks of processor time that the program has used, all its threads together.
ticks() { awk '{ print $14 + $15 }' "/proc/$program/stat"; }

# Drawn when two looks are the same and not one colour.
settle() {
  look settling
  for _ in $(seq 100); do
    sleep 0.3
    look "$1"
    if [ "$(identify -format '%k' "$seen/$1.png")" -gt 50 ] && [ "$(differ settling "$1")" = 0 ]; then return; fi
    cp "$seen/$1.png" "$seen/settling.png"
  done
  fail "the window does not come to rest ($1)"
}

settle opened

# An idle window does nothing: at most 2 ticks (20 ms) in 2 s, and the idle estimate is over by then.
sleep 2
before=$(ticks)
sleep 2
used=$(($(ticks) - before))
[ "$used" -le 2 ] || fail "an idle window used $used ticks in 2 s"

xdotool key space
for _ in $(seq 20); do
  sleep 1
  look playing
  changed=$(differ opened playing)
  [ "$changed" -le 100 ] || break
done
[ "$changed" -gt 100 ] || fail "Space does not play: $changed pixels differ"
xdotool key space
settle paused

# "Top" in the bar, which is laid out from the left: another picture.
xdotool mousemove 445 12
sleep 0.3
xdotool click 1
# Within one frame the click would be where the mouse is at its end.
sleep 0.5
xdotool mousemove 5 5
settle clicked
changed=$(differ paused clicked)
[ "$changed" -gt 1000 ] || fail "a click on Top does not turn the view: $changed pixels differ"

# As good as no size at all, smaller, larger than most screens, and back: the surface is made anew each time, and drawn
# on to its new edges.
xdotool windowsize "$window" 1 1
sleep 0.5
for other in 800x480 2560x1440 "$size"; do
  xdotool windowsize "$window" "${other%x*}" "${other#*x}"
  settle "resized-$other"
  [ "$(identify -format '%wx%h' "$seen/resized-$other.png")" = "$other" ] || fail "the window is not $other"
done

# Taken from the screen while it plays, as a window that is minimised, and brought back.
xdotool key space
sleep 0.5
xdotool windowunmap --sync "$window"
sleep 0.5
xdotool windowmap --sync "$window"
xdotool windowfocus --sync "$window"
xdotool key space
settle back

# The same while it rests: all of it is there again, though nobody does anything.
xdotool windowunmap --sync "$window"
sleep 0.5
xdotool windowmap --sync "$window"
settle rested
lost=$(differ back rested)
[ "$lost" -le 100 ] || fail "a resting window that comes back has lost $lost pixels"
xdotool windowfocus --sync "$window"

xdotool key ctrl+q
ended "Ctrl+Q does not close the window"
[ "$status" = 0 ] || fail "closed with status $status: $(cat "$seen/output.txt")"

# A test that takes the window's device away, in a window on this display.
name=app::shell::window::tests::a_real_window_goes_on_when_its_device_is_lost
cargo test --quiet --locked --all-features --lib -- --ignored --exact "$name" >"$seen/lost.txt" 2>&1 ||
  fail "a lost device: $(cat "$seen/lost.txt")"
grep -q '1 passed' "$seen/lost.txt" || fail "no test is called $name"

# The display goes while something is unsaved, sooner than it is kept by itself.
start
settle opened
plain=$(xdotool getwindowname "$window")
xdotool key g
for _ in $(seq 100); do
  [ "$(xdotool getwindowname "$window")" = "$plain" ] || break
  sleep 0.1
done
kill -KILL "$server"
wait "$server" 2>/dev/null || true
server=''
ended "the program outlives its display"
[ "$status" != 0 ] || fail "a display that is gone is no success"
grep -q 'unsaved work is kept' "$seen/output.txt" || fail "unsaved work is not spoken of: $(cat "$seen/output.txt")"
kept=$(find "$XDG_STATE_HOME" -name '*.unsaved' | wc -l)
[ "$kept" = 1 ] || fail "$kept files of unsaved work"

echo "window: opened, rested ($used ticks in 2 s), played, took a click and any size, closed ($size);" \
  "outlived its device, kept what was unsaved when its display went"
