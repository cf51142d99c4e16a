# shellcheck shell=bash
# What the scripts share. Source it; it runs nothing by itself.
# shellcheck disable=SC2034  # the variables are for those who source this

# A failure inside $(...) is a failure.
shopt -s inherit_errexit

ROOT="$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)"
NODE=/ice_ice_baby
CHILDREN=()

# ROS on Debian is built for the system's python3; another one first on PATH lacks its modules.
export PATH="/usr/bin:$PATH"

# With ccache, every copy of this tree takes what another one has compiled, wherever it is: options that name a folder
# do not count, the files that they name do.
export CCACHE_BASEDIR="$ROOT" CCACHE_NOHASHDIR=true
export CCACHE_IGNOREOPTIONS="-fmacro-prefix-map=* -fsanitize-ignorelist=*"
export CCACHE_EXTRAFILES="$ROOT/cmake/ubsan_ignored.txt:$ROOT/cmake/tsan_ignored.txt"

say() { printf '\033[1;36m==>\033[0m %s\n' "$*"; }

die() {
  printf '\033[1;31merror:\033[0m %s\n' "$*" >&2
  exit 1
}

# Prints the comment block at the head of a script as its help.
show_help() { sed -n '2,/^$/{s/^# \{0,1\}//p}' "$1"; }

# On a terminal: the last line of a growing log, once a second, as long as this script runs.
follow_log() {
  local line
  while kill -0 $$ 2>/dev/null && sleep 1; do
    line="$(tail -c 400 "$1" 2>/dev/null | tr '\r' '\n' | tail -n 1 | tr -cd '[:print:]')"
    if [[ -n "$line" ]]; then printf '\r\033[K    %.72s' "$line"; fi # else sudo may be asking for a password
  done
}

# Runs a command and shows how far it is, if this is a terminal; its output is shown only if it fails.
quietly() {
  local log watcher="" failed=false
  log="$(mktemp)"
  if [[ -t 1 ]]; then
    follow_log "$log" &
    watcher=$!
  fi
  "$@" >"$log" 2>&1 || failed=true
  if [[ -n "$watcher" ]]; then
    kill "$watcher" 2>/dev/null || true
    wait "$watcher" 2>/dev/null || true
    printf '\r\033[K'
  fi
  if $failed; then
    tail -n 60 "$log" >&2
    rm -f "$log"
    die "failed: $*"
  fi
  rm -f "$log"
}

as_root() {
  if [[ $EUID -eq 0 ]]; then
    "$@"
  else
    command -v sudo >/dev/null || die "needs root or sudo: $*"
    sudo "$@"
  fi
}

# use_build DIR: what setup.bash of a build adds to the environment.
use_build() {
  [[ -f "$1/devel/setup.bash" ]] || die "$1 holds no build; run scripts/build"
  set +u
  # shellcheck disable=SC1091
  source "$1/devel/setup.bash"
  set -u
}

# build_preset NAME TARGET...: configures and builds a preset of CMakePresets.json in build/NAME.
build_preset() {
  local preset="$1" launcher=()
  shift
  if command -v ccache >/dev/null; then launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache); fi
  say "Building preset $preset"
  cd "$ROOT" || return
  quietly cmake --preset "$preset" ${launcher[@]+"${launcher[@]}"}
  quietly cmake --build --preset "$preset" --parallel "$(nproc)" --target "$@"
}

# ROS finds its own servers by this name.
require_localhost() {
  getent hosts localhost >/dev/null || die "localhost does not resolve; add '127.0.0.1 localhost' to /etc/hosts"
}

# A port at which nobody listens, below those that Linux gives to outgoing connections: nobody takes it meanwhile.
free_port() {
  local port
  for _ in $(seq 100); do
    port=$((10000 + RANDOM % 20000))
    if ! (exec 3<>"/dev/tcp/127.0.0.1/$port") 2>/dev/null; then
      echo "$port"
      return
    fi
  done
  die "found no free port"
}

# A ROS master of one's own that no other machine reaches.
use_private_master() {
  export ROS_IP=127.0.0.1
  unset ROS_HOSTNAME
  ROS_MASTER_URI="http://127.0.0.1:$(free_port)"
  export ROS_MASTER_URI
}

# start LOG COMMAND...: runs in the background until stop_children.
start() {
  local log="$1"
  shift
  "$@" >"$log" 2>&1 </dev/null &
  CHILDREN+=($!)
}

# Ends what start began, the latest first. Call it from a trap on EXIT.
stop_children() {
  local i pid
  for ((i = ${#CHILDREN[@]} - 1; i >= 0; --i)); do
    pid="${CHILDREN[i]}"
    kill -TERM "$pid" 2>/dev/null || continue
    for _ in $(seq 50); do
      kill -0 "$pid" 2>/dev/null || break
      sleep 0.1
    done
    kill -KILL "$pid" 2>/dev/null || true
    wait "$pid" 2>/dev/null || true
  done
  CHILDREN=()
}

# await SECONDS WHAT COMMAND...: waits until the command succeeds.
await() {
  local deadline=$((SECONDS + $1)) what="$2"
  shift 2
  until "$@" >/dev/null 2>&1; do
    [[ $SECONDS -lt $deadline ]] || die "waited in vain for $what"
    sleep 0.3
  done
}
