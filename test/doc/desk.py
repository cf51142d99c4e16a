"""A fresh home, a private ROS master and a folder in which commands run as a reader pastes them."""

import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

from documents import ROOT
from not_run import WITH_RVIZ

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from iib.common.processes import free_port

COMMAND_S, ANSWER_S, END_S = 120, 90, 30
PROGRAM_S = 1  # how long a program of a document goes on once it is a node
NODE_NAME = re.compile(r"init_node\('(\w+)'|argv, \"(\w+)\"")
LOGS = re.compile("loginfo|ROS_INFO")
FAULT = re.compile(r"Traceback|\[ERROR\]|\[FATAL\]|\bERROR\b|\berror:|[sS]uccess: False|unable to")
PRELUDE = re.compile(r"(source|export|cd) ")


class Failed(AssertionError):
    pass


def require_sound(output, code, expected=0):
    """Fails with the end of the output after another exit code or a message of an error."""
    fault = FAULT.search(output) if expected == 0 else None
    if code != expected or fault:
        why = f"printed {fault[0]!r}" if fault else f"exit code {code} instead of {expected}"
        raise Failed(f"{why}:\n" + "\n".join(output.splitlines()[-25:]))


class Child:
    """A program that runs until told to end; its output is in a file."""

    def __init__(self, command, env, cwd, log):
        self._log = log
        with log.open("w") as file:
            self._process = subprocess.Popen(
                ["bash", "-c", command],
                env=env,
                cwd=cwd,
                stdin=subprocess.DEVNULL,
                stdout=file,
                stderr=subprocess.STDOUT,
                start_new_session=True,
            )

    def output(self):
        return self._log.read_text(errors="replace")

    def code(self):
        return self._process.poll()

    def wait(self, seconds):
        """Whether it ended by itself."""
        deadline = time.monotonic() + seconds
        while self.code() is None and time.monotonic() < deadline:
            time.sleep(0.05)
        return self.code() is not None

    def interrupt(self):
        """Sends Ctrl-C to it and to all that it started. Returns whether it ended in time."""
        if self.code() is None:
            self.signal_group(signal.SIGINT)
        ended = self.wait(END_S)
        self.signal_group(signal.SIGKILL)
        self._process.wait()
        return ended

    def signal_group(self, number):
        try:
            os.killpg(self._process.pid, number)
        except ProcessLookupError:
            pass


class Desk:
    """Runs the steps of one document in order. A launch serves the later steps of its section."""

    def __init__(self, build, prelude):
        self._folder = pathlib.Path(tempfile.mkdtemp(prefix="iib_doc_"))
        self._cwd, self._home = self._folder / "ice_ice_baby", self._folder / "home"
        for folder in (self._cwd, self._home):
            folder.mkdir()
        for path in ROOT.iterdir():
            if not path.name.startswith(("build", "out", ".git")):
                (self._cwd / path.name).symlink_to(path)
        (self._cwd / "build").symlink_to(build)
        self._env = self.bare_environment()
        self._launch = self._key = None
        self._children = 0
        for line in prelude:
            self.prelude(line)

    def bare_environment(self):
        """What a login shell has, without a display and without ROS; its master is private."""
        env = {name: os.environ[name] for name in ("LANG", "LC_ALL", "USER") if name in os.environ}
        path = "/usr/local/bin:/usr/bin:/bin:/usr/sbin:/sbin"
        return {
            **env,
            "PATH": path,
            "HOME": str(self._home),
            "ROS_MASTER_URI": f"http://127.0.0.1:{free_port()}",
            "ROS_IP": "127.0.0.1",
            "PYTHONUNBUFFERED": "1",
        }

    def close(self):
        """Ends what still runs. Fails if the launch did not end as it should."""
        try:
            self.end_launch()
        finally:
            shutil.rmtree(self._folder, ignore_errors=True)

    def prelude(self, line):
        """A command that changes the shell: source, export."""
        script = ["bash", "-c", f"{line} >&2 && env -0"]
        done = subprocess.run(script, env=self._env, cwd=self._cwd, capture_output=True)
        require_sound(done.stderr.decode(), done.returncode)
        pairs = done.stdout.decode().split("\0")
        self._env = dict(pair.split("=", 1) for pair in pairs if "=" in pair)

    def run(self, text, expected=0):
        if PRELUDE.match(text):
            return self.prelude(text)
        if re.match(r"(scripts/fence )?roslaunch ", text):
            return self.launch(text)
        child = self.start(text)
        if not child.wait(COMMAND_S):
            child.interrupt()
            raise Failed(f"did not end within {COMMAND_S} s; stop it or list it in not_run.py")
        return require_sound(child.output(), child.code(), expected)

    def start(self, command):
        self._children += 1
        log = self._folder / f"output_{self._children}"
        return Child(command, self._env, self._cwd, log)

    def launch(self, text):
        """Starts it in place of the last launch, and waits until its node answers or it ends."""
        self.end_launch()
        words = text.split()
        shown = any(file in words for file in WITH_RVIZ)
        self._launch = self.start(text + (" rviz:=false" if shown else ""))
        self._key = text
        fenced, node = words[0] == "scripts/fence", "replay.launch" not in words
        deadline = time.monotonic() + ANSWER_S
        while time.monotonic() < deadline:
            output = self._launch.output()
            if self._launch.code() is not None:
                require_sound(output, self._launch.code())
                if node:
                    raise Failed("ended by itself:\n" + output[-2000:])
                return
            # A node behind a fence answers nobody outside.
            if "process[ice_ice_baby" in output if fenced else node and self.answers():
                time.sleep(2.0 if fenced or "record:=true" in words else 0.0)
                return
            time.sleep(0.2)
        self.end_launch()
        raise Failed(f"no answer within {ANSWER_S} s")

    def answers(self):
        call = ["rosservice", "call", "/ice_ice_baby/get_state"]
        return subprocess.run(call, env=self._env, capture_output=True, check=False).returncode == 0

    def serve(self, text):
        """Starts that launch unless it runs already."""
        if self._key != text or self._launch is None or self._launch.code() is not None:
            self.launch(text)

    def end_launch(self):
        launch, self._launch, self._key = self._launch, None, None
        if launch is None:
            return
        ended = launch.interrupt()
        if not ended:
            raise Failed("the launch did not end after Ctrl-C:\n" + launch.output()[-2000:])
        require_sound(launch.output(), launch.code())

    def write(self, name, text):
        (self._cwd / name).write_text(text)

    def run_python(self, text):
        self.write("program.py", text)
        self.run_program("python3 program.py", text)

    def run_cpp(self, text):
        self.write("program.cpp", text)
        flags = "$(pkg-config --cflags --libs roscpp sensor_msgs)"
        self.run(f"g++ -std=c++17 -o program program.cpp {flags}")
        self.run_program("./program", text)

    def is_node(self, name):
        ping = ["rosnode", "ping", "-c", "1", "/" + name]
        return subprocess.run(ping, env=self._env, capture_output=True, check=False).returncode == 0

    def run_program(self, command, text):
        """It has to become a node, to print what it logs, and to go on until Ctrl-C."""
        node = next(filter(None, NODE_NAME.search(text).groups()))
        child = self.start(command)
        deadline = time.monotonic() + ANSWER_S
        while not (self.is_node(node) and (child.output() or not LOGS.search(text))):
            if child.code() is not None or time.monotonic() > deadline:
                break
        if child.wait(PROGRAM_S):
            raise Failed("ended by itself:\n" + child.output()[-2000:])
        logged, ended = child.output(), child.interrupt()
        if not ended:
            raise Failed("did not end after Ctrl-C")
        require_sound(child.output(), child.code())
        if LOGS.search(text) and not logged:
            raise Failed(f"logged nothing within {ANSWER_S} s")
