#!/usr/bin/env bash
# How soon a real window answers: drags a slider of a scene step by step and lets it play, on a display of its own, and tells what
# the program's event log says (docs/cost.md).
#
#   tests/window/responsiveness.sh [BINARY] [SCENE] [WIDTHxHEIGHT]
#
# Wants Xvfb and xdotool. The log is left in target/window/events.csv.
set -euo pipefail
cd "$(dirname "$0")/../.."

binary=${1:-target/release/girderbench}
scene=${2:-skew45-abutment}
size=${3:-1280x720}
width=${size%x*}
log=target/window/events.csv
mkdir -p target/window

# shellcheck source=tests/window/display.sh
. tests/window/display.sh

GIRDERBENCH_EVENT_LOG=$log "$binary" open "$scene" >/dev/null 2>&1 &
program=$!
window=''
for _ in $(seq 300); do
  window=$(xdotool search --onlyvisible --name Girderbench 2>/dev/null | head -n 1) && [ -n "$window" ] && break
  sleep 0.1
done
[ -n "$window" ] || { echo "no window within 30 s" >&2; exit 1; }
xdotool windowmove "$window" 0 0 windowsize "$window" "$width" "${size#*x}"
xdotool windowfocus --sync "$window"
sleep 5

# The slider of the skew stands at the top of the panel at the right: 40 steps of a pixel, 10 a second.
x=$((width - 159))
xdotool mousemove "$x" 86 mousedown 1
for step in $(seq 40); do
  xdotool mousemove $((x + step)) 86
  sleep 0.1
done
xdotool mouseup 1
sleep 5

# Processor time of ten seconds of playing, in ticks of 1/100 s.
ticks() { awk '{ print $14 + $15 }' "/proc/$program/stat"; }
xdotool mousemove $((width / 2)) 200 click 1 key Escape key space
sleep 2
before=$(ticks) frames=$(wc -l <"$log")
sleep 10
after=$(ticks)
# A drag is one step to undo; then nothing is unsaved that the program would ask about.
xdotool key space
sleep 3
xdotool key ctrl+z
sleep 5
xdotool key ctrl+q
for _ in $(seq 200); do
  kill -0 "$program" 2>/dev/null || break
  sleep 0.1
done
kill -0 "$program" 2>/dev/null && kill "$program" 2>/dev/null
program=''
echo "$scene at $size: playing, $(((after - before) / 10)) % of a core"
awk -F, -v skip="$frames" '
  /^#/ || NR == 1 { next }
  { part["layout"] = $3; part["tessellate"] = $4; part["paint"] = $5; all++ }
  NR > skip { shown++; for (name in part) sum[name] += part[name] }
  END {
    for (name in sum) printf "  %s %.1f ms a frame while playing\n", name, sum[name] / shown
    printf "  %d frames from there on, %d in all\n", shown, all
  }' "$log"
grep '^#' "$log" || echo "the log was not closed"
