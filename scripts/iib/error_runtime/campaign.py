"""Runs the points of a campaign one at a time and keeps its tables up to date."""

import dataclasses
import pathlib
import sys

from iib.common import machine
from iib.error_runtime.grid import identity
from iib.error_runtime.points import table
from iib.common.progress import Progress
from iib.error_runtime.runner import Runner, pending
from iib.error_runtime.store import Store


@dataclasses.dataclass
class Campaign:
    """What to measure. scene: name or path; fixed: list of key=value that hold for every point."""

    scene: str
    out: pathlib.Path
    axes: dict
    points: list
    duration_s: float = None
    fixed: tuple = ()
    repeats: int = 3
    timeout_s: float = 600
    trajectory_s: float = 0
    trajectory_substeps: int = 64

    def constants(self):
        return {"scene": self.scene, "duration_s": self.duration_s, "set": list(self.fixed)}


def say(text):
    print(f"error_vs_runtime: {text}", file=sys.stderr)


def of_program(runs, program):
    """Runs of this build; earlier builds stay in runs.jsonl and out of the tables."""
    return [run for run in runs if run.get("program") == program]


def measure(campaign, program, command, fresh=False):
    """Runs what is missing. Returns the finished runs; on Ctrl-C the tables are written first."""
    store = Store(campaign.out)
    runner = Runner(program, campaign.constants(), campaign.timeout_s)
    runner.check(campaign.axes)
    with store.held(campaign.constants(), fresh):
        return measure_into(store, campaign, runner, program, command)


def measure_into(store, campaign, runner, program, command):
    about = machine.about(program, command)
    runs = of_program(store.runs(), about["program"])
    others = len(store.runs()) - len(runs)
    if others:
        say(f"{others} runs in {campaign.out} are of another build of run_scene and left aside")
    reference = None
    if campaign.trajectory_s > 0:
        from iib.error_runtime.trajectory import Reference  # needs numpy, which only this does

        reference = Reference(
            store.folder, runner, campaign.trajectory_s, campaign.trajectory_substeps
        )
        reference.make(about["program"], say)
        about["reference"] = reference.kept
    try:
        run_pending(campaign, store, runner, reference, runs, about)
    finally:
        if runs:
            store.write_tables(table(runs), about)
    return runs


def run_pending(campaign, store, runner, reference, runs, about):
    """Appends each finished run to the store and to `runs`, and rewrites the tables after it."""
    todo = pending(campaign.points, campaign.repeats, runs)
    bar = Progress([identity(point) for point in todo])
    failed = set()
    try:
        for point in todo:
            name = identity(point)
            bar.begin(name)
            if name in failed:
                bar.end(name, 0.0)
                continue
            run = run_once(store, runner, reference, point)
            run.update(program=about["program"], commit=about["commit"], date=machine.now())
            store.append(run)
            runs.append(run)
            store.write_tables(table(runs), about)
            if run["status"] != "ok":
                failed.add(name)
            bar.end(name, run["seconds"])
    finally:
        bar.close()


def run_once(store, runner, reference, point):
    if reference is None:
        return runner.run(point)
    record = store.folder / "record.npy"
    try:
        run = runner.run(point, record=record)
        if "report" in run:
            run["metrics"] = reference.metrics(record, run["report"])
        return run
    finally:
        record.unlink(missing_ok=True)
