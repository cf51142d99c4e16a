# shellcheck shell=bash
# A simulation seen by rviz on a screen in memory. Needs lib.sh; the caller traps stop_children.

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
    ice_ice_baby demo.launch rviz:=false scene:="$2"
  await 40 "the node (see $1/simulation.log)" rosservice info "$NODE/get_state"
}

# start_view LOG_DIR CONFIG: rviz, until it really receives particles.
start_view() {
  start "$1/rviz.log" rviz -d "$2" __name:=demo_view
  await 60 "rviz (see $1/rviz.log)" bash -c "rostopic info $NODE/particles | grep -q demo_view"
  sleep 5 # the first frames: shaders, docks, the window's final size
}

# call SERVICE YAML: fails unless the node answers with success.
call() {
  local answer
  answer="$(rosservice call "$NODE/$1" "$2")" || die "$1 failed: $answer"
  grep -q 'success: True' <<<"$answer" || die "$1 refused: $answer"
}

# record_screen FILE SIZE SECONDS FPS LOG: the screen as a film, in the background.
record_screen() {
  start "$5" ffmpeg -y -loglevel warning -f x11grab -draw_mouse 0 -framerate "$4" -video_size "$2" \
    -t "$3" -i "$DISPLAY" -c:v libx264 -preset ultrafast -crf 12 "$1"
}

# make_gif FILM GIF WIDTH FPS SPEED [CROP]: SPEED 2 plays twice as fast.
make_gif() {
  local filter="${6:+crop=$6,}setpts=PTS/$5,fps=$4,scale=$3:-1:flags=lanczos"
  quietly ffmpeg -y -loglevel warning -i "$1" -vf \
    "$filter,split[a][b];[a]palettegen=max_colors=96:stats_mode=diff[p];[b][p]paletteuse=dither=bayer:bayer_scale=4:diff_mode=rectangle" \
    "$2"
}
