"""Runs run_scene for one point, and tells what became of it."""

import json
import pathlib
import signal
import subprocess
import tempfile
import time

from .grid import PROGRAM_OPTIONS, identity
from .refusal import Refusal

# What run_scene's exit codes mean.
STATUS = {0: "ok", 1: "refused", 2: "unstable"}

# Of a report, what the tables are made of.
KEPT = """particles springs simulated_time_s wall_time_s frames steps kinetic_energy_j
max_speed_m_s rms_speed_m_s residual_speed_m_s escaped speed_limited non_finite state_hash threads
precision preset error settings""".split()


class Runner:
    """program: path of run_scene; campaign: scene, duration_s (None: the scene's) and set (a list)."""

    def __init__(self, program, campaign, timeout_s=600):
        self.program = str(program)
        self.campaign = campaign
        self.timeout_s = timeout_s

    def command(self, point, *more):
        words = [self.program, self.campaign["scene"]]
        if self.campaign.get("duration_s") is not None:
            words += ["--duration", str(self.campaign["duration_s"])]
        for text in self.campaign.get("set", []):
            words += ["--set", text]
        for key, value in point.items():
            words += [f"--{key}", value] if key in PROGRAM_OPTIONS else ["--set", f"{key}={value}"]
        return words + [str(word) for word in more]

    def run(self, point, *more):
        """One run: a dict with point, status, message, seconds and, where there is one, report."""
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "report.json"
            start = time.monotonic()
            status, message = self._finish(self.command(point, "--report", path, *more))
            run = {"point": point, "status": status, "message": message}
            run["seconds"] = round(time.monotonic() - start, 3)
            if path.exists() and path.stat().st_size > 0:
                report = json.loads(path.read_text())
                run["report"] = {key: report[key] for key in KEPT if key in report}
            return run

    def _finish(self, command):
        """Status and message of a command that is given its time."""
        try:
            done = subprocess.run(command, capture_output=True, text=True, timeout=self.timeout_s)
        except subprocess.TimeoutExpired:
            return "stopped", f"took longer than --timeout {self.timeout_s:g} s"
        lines = done.stderr.strip().splitlines()
        if done.returncode < 0:
            return "crashed", f"ended by {signal.Signals(-done.returncode).name}"
        message = lines[-1] if lines and done.returncode != 0 else ""
        return STATUS.get(done.returncode, "crashed"), message

    def refusal_of(self, point):
        """run_scene's message if it refuses the point, else "". Simulates nothing."""
        trial = Runner(self.program, {**self.campaign, "duration_s": 0}, self.timeout_s)
        run = trial.run(point)
        return run["message"].removeprefix("run_scene: ") if run["status"] == "refused" else ""

    def check(self, axes):
        """Refuses a scene that does not run, and an axis of which no value does: a typing mistake.

        A value that is refused beside others that are not is a finding and stays in the tables.
        """
        message = self.refusal_of({})
        if message:
            raise Refusal(message)
        for key, values in axes.items():
            messages = [self.refusal_of({key: value}) for value in values]
            if all(messages):
                raise Refusal(messages[0])


def pending(points, repeats, runs):
    """Runs still to do, round by round, so that a slow minute of the machine hits every point.

    What failed once fails again, for runs repeat bit by bit, and is not asked again.
    """
    done, settled = {}, set()
    for run in runs:
        name = identity(run["point"])
        done[name] = done.get(name, 0) + 1
        if run["status"] != "ok":
            settled.add(name)
    todo = []
    for repeat in range(repeats):
        for point in points:
            name = identity(point)
            if done.get(name, 0) <= repeat and name not in settled:
                todo.append(point)
    return todo
