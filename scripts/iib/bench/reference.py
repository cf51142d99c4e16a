"""A reference run of every micro-benchmark, kept as CSV under the name of its processor."""

import csv
import datetime
import os
import re

from iib.bench.builds import Tree
from iib.bench.series import Series, microbench
from iib.common.machine import commit, processor
from iib.common.paths import ROOT
from iib.common.progress import Progress


def write(folder, runs):
    program = Tree("tree", folder).copy_working_tree().make("microbench").program("microbench")
    found, bar = Series(), Progress(["every micro-benchmark"] * runs)
    for _ in range(runs):
        with bar.run("every micro-benchmark"):
            found.add(microbench(program, "."))
    bar.close()
    name = re.sub(r"[^a-z0-9]+", "_", processor().lower()).strip("_")
    path = ROOT / "bench" / "results" / f"{name}.csv"
    path.parent.mkdir(exist_ok=True)
    with open(path, "w", newline="") as file:
        file.write(
            f"# {processor()}, {os.cpu_count()} processors; commit {commit()}; "
            f"{datetime.date.today()}; {runs} runs; "
            "time: of the processor on one thread, else wall\n"
        )
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["benchmark", "quantity", "unit", "median", "least", "most"])
        for key, values in found.items():
            benchmark, _, quantity = key.partition(" ")
            unit = "B" if quantity.startswith("bytes") else "s"
            numbers = [f"{v:.4g}" for v in (found.median(key), min(values), max(values))]
            writer.writerow([benchmark, quantity or "time", unit, *numbers])
    print(f"wrote {path}")
