"""Runs run_scene for one point, and tells what became of it."""

import json
import pathlib
import tempfile
import time

from iib.common import run_scene
from iib.common.refusal import Refusal
from iib.error_runtime.grid import PROGRAM_OPTIONS, identity

# Of a report, what the tables are made of.
KEPT = """particles springs simulated_time_s wall_time_s frames steps kinetic_energy_j
max_speed_m_s rms_speed_m_s residual_speed_m_s escaped speed_limited non_finite state_hash threads
precision preset error settings""".split()


class Runner:
    """program: path of run_scene; campaign: scene, duration_s (None: the scene's), set (list)."""

    def __init__(self, program, campaign, timeout_s=600):
        self.program = str(program)
        self.campaign = campaign
        self.timeout_s = timeout_s

    def command(self, point, **outputs):
        options = {key: value for key, value in point.items() if key in PROGRAM_OPTIONS}
        keys = [f"{key}={value}" for key, value in point.items() if key not in PROGRAM_OPTIONS]
        scene, fixed = self.campaign["scene"], self.campaign.get("set", [])
        options["duration"] = self.campaign.get("duration_s")
        return [self.program, *run_scene.words(scene, [*fixed, *keys], **options, **outputs)]

    def run(self, point, **outputs):
        """One run: a dict with point, status, message, seconds and, where there is one, report."""
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "report.json"
            start = time.monotonic()
            status, message = run_scene.finish(
                self.command(point, report=path, **outputs), self.timeout_s
            )
            run = {"point": point, "status": status, "message": message}
            run["seconds"] = round(time.monotonic() - start, 3)
            if path.exists() and path.stat().st_size > 0:
                report = json.loads(path.read_text())
                run["report"] = {key: report[key] for key in KEPT if key in report}
            return run

    def refusal_of(self, point):
        """run_scene's message if it refuses the point, else "". Simulates nothing."""
        trial = Runner(self.program, {**self.campaign, "duration_s": 0}, self.timeout_s)
        run = trial.run(point)
        return run["message"] if run["status"] == "refused" else ""

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
