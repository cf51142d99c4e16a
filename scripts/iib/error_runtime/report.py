"""Measures the studies of the report and writes doc/error_vs_runtime.md with its pictures."""

import json
import pathlib

from iib.common.paths import ROOT
from iib.error_runtime.campaign import measure, of_program, say
from iib.error_runtime.document import document
from iib.error_runtime.peers import read_peers
from iib.error_runtime.points import axes_of, table
from iib.common.refusal import Refusal
from iib.common.run_scene import find_run_scene
from iib.error_runtime.store import Store
from iib.error_runtime.studies import PEERS_STUDY, STUDIES, campaign_of


class Result:
    """What a study's folder holds of the latest build."""

    def __init__(self, study, folder):
        store = Store(folder)
        runs = store.runs()
        if not runs:
            raise Refusal(f"{folder} holds no finished runs; leave --no-run out to measure")
        self.study = study
        self.constants = store.campaign()
        self.runs = of_program(runs, runs[-1]["program"])
        self.rows = table(self.runs)
        self.axes = axes_of(self.runs)
        note = folder / "reference.json"
        self.reference = json.loads(note.read_text()) if note.exists() else None


def measure_all(args, folder, command):
    program = find_run_scene(args.run_scene)
    for study in STUDIES:
        say(f"{study.name}: {study.shows}")
        measure(campaign_of(study, folder, program, args.repeats), program, command, args.fresh)


def make_report(args, command):
    from iib.error_runtime.plots import draw
    from iib.error_runtime.sizes_picture import draw_sizes

    folder = args.out or ROOT / "out" / "error_vs_runtime" / "report"
    peers = read_peers(args.peers) if args.peers else []
    if not args.no_run:
        measure_all(args, folder, command)
    results = [Result(study, folder / study.name) for study in STUDIES]
    pictures = pathlib.Path(args.doc) / "images"
    for result in results:
        study = result.study
        if study.sizes:
            draw_sizes(pictures / study.picture_name, result.rows, f"{study.scene}: {study.shows}")
        elif study.picture:
            beside = peers if study.name == PEERS_STUDY else []
            prefix = f"error_vs_runtime_{study.name}_"
            draw(pictures, result.rows, result.axes, beside, study.scene, prefix)
    path = pathlib.Path(args.doc) / "error_vs_runtime.md"
    path.write_text(document(results, peers))
    took = sum(run["seconds"] for result in results for run in result.runs)
    print(f"wrote {path} and its pictures; its runs took {took / 60:.1f} min")
    return 0
