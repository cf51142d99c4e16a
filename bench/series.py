"""Measured values by name, several runs of each: medians, spreads, progress."""

import json
import re
import statistics
import subprocess
import sys
import tempfile
import time


PER_EACH = ("per_particle", "per_pair", "per_particle_substep")


class Series(dict):
    """Name of a quantity -> its value in each run."""

    def add(self, values):
        for name, value in values.items():
            self.setdefault(name, []).append(value)

    def median(self, name):
        return statistics.median(self[name])

    def spread(self, name):
        """Half of what lies between the least and the most, over the median."""
        values = self[name]
        middle = statistics.median(values)
        return (max(values) - min(values)) / 2 / middle if middle else 0.0


def differ(a, b):
    """Whether every value of one run lies on one side of every value of the other."""
    return max(a) < min(b) or max(b) < min(a)


def microbench(program, pattern, min_time_s=0.1):
    """One run of the micro-benchmarks. Seconds, but for what is named bytes.

    On one thread the processor's time counts, which others on the machine disturb less; wall time is
    beside it as "NAME wall".
    """
    out = output([program, f"--benchmark_filter={pattern}", f"--benchmark_min_time={min_time_s}",
                  "--benchmark_format=json"])
    values = {}
    for b in json.loads(out)["benchmarks"] if out.strip() else []:
        name = re.sub(r"/(real_time|iterations:\d+)", "", b["name"])
        unit = {"ms": 1e-3, "us": 1e-6, "ns": 1e-9}[b["time_unit"]]
        own = b["cpu_time"] / b["real_time"] if "threads:1" in name else 1.0
        values[name] = own * b["real_time"] * unit
        values[f"{name} wall"] = b["real_time"] * unit
        for key, value in b.items():
            if key in PER_EACH or key.startswith("stage_"):
                values[f"{name} {key}"] = own * value
            elif key.startswith("bytes_"):
                values[f"{name} {key}"] = value
    return values


def run_scene(program, scene, duration_s, threads, overrides=()):
    """Report of a run."""
    with tempfile.NamedTemporaryFile(suffix=".json") as report:
        command = [program, scene, "--duration", duration_s, "--threads", threads]
        for override in overrides:
            command += ["--set", override]
        output([*command, "--report", report.name])
        return json.load(open(report.name))


def output(command):
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{done.stderr.strip()}\nfailed: {' '.join(map(str, command))}")
    return done.stdout


class Progress:
    """How far and how long yet, on one line of a terminal; nothing elsewhere."""

    def __init__(self, total):
        self.total, self.done, self.start = total, 0, time.monotonic()

    def step(self, what):
        if sys.stderr.isatty():
            left = ""
            if self.done:
                left_s = (time.monotonic() - self.start) / self.done * (self.total - self.done)
                left = f", {left_s:.0f} s left"
            print(f"\r\033[K{self.done}/{self.total} {what}{left}", end="", file=sys.stderr, flush=True)
        self.done += 1

    def end(self):
        if sys.stderr.isatty():
            print("\r\033[K", end="", file=sys.stderr, flush=True)


def text(name, value):
    """A value with its unit."""
    if "bytes" in name:
        return f"{value:.0f} B"
    for unit, scale in (("s", 1.0), ("ms", 1e3), ("us", 1e6)):
        if value * scale >= 1.0:
            return f"{value * scale:.3g} {unit}"
    return f"{value * 1e9:.3g} ns"
