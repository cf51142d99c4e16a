# shellcheck shell=bash
# A simulation seen by rviz on a screen in memory. Needs lib.sh; the caller traps stop_children.
# shellcheck disable=SC2034  # some variables are for those who source this

# open_screen SIZE LOG_DIR: a display in memory, as DISPLAY, drawn on by software.
open_screen() {
  local number_file="$2/display"
  : >"$number_file"
  start "$2/xvfb.log" bash -c \
    "exec Xvfb -displayfd 3 -screen 0 $1x24 -nolisten tcp 3>'$number_file'"
  await 20 "a screen" test -s "$number_file"
  DISPLAY=":$(<"$number_file")"
  export DISPLAY LIBGL_ALWAYS_SOFTWARE=1 QT_X11_NO_MITSHM=1
}

# start_simulation LOG_DIR SCENE: master and node, paused until it is seen.
start_simulation() {
  use_private_master
  start "$1/simulation.log" roslaunch -p "${ROS_MASTER_URI##*:}" \
    ice_ice_baby demo.launch rviz:=false paused:=true scene:="$2"
  SIMULATION=$!
  await 40 "the node (see $1/simulation.log)" rosservice type "$NODE/get_state"
}

# start_view LOG_DIR SIZE [CONFIG]: rviz, until it really receives the surface. It draws few frames a second, so
# that drawing by software leaves the processor to the simulation.
start_view() {
  sed -e 's/Frame Rate: .*/Frame Rate: 10/' -e "s/^  Width: .*/  Width: ${2%x*}/" \
    -e "s/^  Height: .*/  Height: ${2#*x}/" "${3:-$ROOT/config/rviz/ice_ice_baby.rviz}" >"$1/view.rviz"
  start "$1/rviz.log" rviz -d "$1/view.rviz" __name:=demo_view
  await 60 "rviz (see $1/rviz.log)" bash -c "rostopic info $NODE/surface | grep -q demo_view"
  sleep 5 # the first frames: shaders, docks, the window's final size
}

# call SERVICE YAML: fails unless the node answers with success.
call() {
  local answer
  answer="$(rosservice call "$NODE/$1" "$2")" || die "$1 failed: $answer"
  grep -q 'success: True' <<<"$answer" || die "$1 refused: $answer"
}

# follow_time LOG_DIR: keeps simulated_s up to date.
follow_time() { start "$1/time.csv" rostopic echo -p "$NODE/state/time_s"; }

# simulated_s LOG_DIR: simulated time in whole seconds.
simulated_s() {
  local line
  line="$(tail -n 1 "$1/time.csv" | cut -d, -f2)"
  [[ "$line" =~ ^[0-9] ]] && echo "${line%%.*}" || echo 0
}

# await_simulated LOG_DIR SECONDS: until so much time is simulated; slower than 1/40 is an error.
await_simulated() {
  local deadline=$((SECONDS + 60 + 40 * $2))
  while [[ "$(simulated_s "$1")" -lt "$2" ]]; do
    kill -0 "$SIMULATION" 2>/dev/null || die "the node ended; see $1/simulation.log"
    [[ $SECONDS -lt $deadline ]] || die "the simulation is too slow; see $1/simulation.log"
    sleep 0.5
  done
}

# start_film FILE SIZE LOG: films the screen in the background until stop_film.
start_film() {
  FILM_BEGAN=$SECONDS
  start "$3" ffmpeg -y -loglevel warning -f x11grab -draw_mouse 0 -framerate 10 -video_size "$2" \
    -i "$DISPLAY" -c:v libx264 -preset ultrafast -crf 12 "$1"
  FILM=$!
}

# stop_film: FILM_SECONDS tells its length.
stop_film() {
  FILM_SECONDS=$((SECONDS - FILM_BEGAN))
  kill -TERM "$FILM"
  wait "$FILM" || true # its status after a signal says nothing about the film
}

# make_gif FILM GIF WIDTH SECONDS [CROP]: a GIF that runs SECONDS, however long the film took.
make_gif() {
  local filter="${5:+crop=$5,}setpts=PTS*$4/$FILM_SECONDS,fps=10,scale=$3:-1:flags=lanczos"
  filter+=",split[a][b];[a]palettegen=max_colors=160:stats_mode=diff[p]"
  filter+=";[b][p]paletteuse=dither=bayer:bayer_scale=4:diff_mode=rectangle"
  quietly ffmpeg -y -loglevel warning -i "$1" -vf "$filter" "$2"
}
