# A display of its own for a script that is sourced into: DISPLAY, an empty XDG_STATE_HOME, and an end of the server and of
# $program with the script. Wants Xvfb.

# A free display: the first whose socket is not there.
number=70
while [ -e "/tmp/.X11-unix/X$number" ] || [ -e "/tmp/.X$number-lock" ]; do number=$((number + 1)); done
export DISPLAY=":$number"
unset WAYLAND_DISPLAY
# Unsaved work and recent files go where nobody else's are.
XDG_STATE_HOME=$(mktemp -d)
export XDG_STATE_HOME
server='' program=''
finish() {
  rm -rf "$XDG_STATE_HOME"
  [ -z "$program" ] || kill "$program" 2>/dev/null || true
  [ -z "$server" ] || kill "$server" 2>/dev/null || true
}
trap finish EXIT

# Large enough for the largest size that is tried.
Xvfb "$DISPLAY" -noreset -screen 0 2560x1440x24 >/dev/null 2>&1 &
server=$!
for _ in $(seq 100); do
  [ -e "/tmp/.X11-unix/X$number" ] && break
  sleep 0.1
done
[ -e "/tmp/.X11-unix/X$number" ] || { echo "window: Xvfb did not come up" >&2; exit 1; }
