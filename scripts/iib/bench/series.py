"""Measured values by name, several runs of each: medians and spreads."""

import json
import re
import statistics

from iib.common.processes import run

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

    On one thread the processor's time counts, which others on the machine disturb less; wall time
    is beside it as "NAME wall".
    """
    out = run(
        [
            program,
            f"--benchmark_filter={pattern}",
            f"--benchmark_min_time={min_time_s}",
            "--benchmark_format=json",
        ]
    )
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


def text(name, value):
    """A value with its unit."""
    if "bytes" in name:
        return f"{value:.0f} B"
    for unit, scale in (("s", 1.0), ("ms", 1e3), ("us", 1e6)):
        if value * scale >= 1.0:
            return f"{value * scale:.3g} {unit}"
    return f"{value * 1e9:.3g} ns"
