"""How far particles are from where a converged reference in double precision has them.

Water is chaotic: beyond some time no two settings agree. That time is measured too, as the time
until which the reference and one of half its substeps stay within one spacing of each other.
"""

import json

import numpy

from iib.common.refusal import Refusal

NAMES = ("reference", "half")


def distances(record, reference, spacing_m):
    """(frames) root mean square distance over the particles, in spacings."""
    frames = min(len(record), len(reference))
    apart = record[:frames].astype(float) - reference[:frames].astype(float)
    return numpy.sqrt((apart**2).sum(axis=2).mean(axis=1)) / spacing_m


def time_within(apart, frame_rate_hz, limit=1.0):
    """Time in s until which the distance stays below the limit; all of it if it always does."""
    beyond = numpy.flatnonzero(~(apart < limit))
    frame = beyond[0] if len(beyond) else len(apart) - 1
    return float(frame / frame_rate_hz)


class Reference:
    """Kept in the folder of the campaign: two records and what they were made with."""

    def __init__(self, folder, runner, seconds, substeps):
        self.folder, self.runner, self.seconds, self.substeps = folder, runner, seconds, substeps

    def path(self, name):
        return self.folder / f"{name}.npy"

    def make(self, program, say):
        """Runs the reference unless the folder has it. say: function called with a line of news."""
        wanted = {"program": program, "seconds": self.seconds, "substeps": self.substeps}
        note = self.folder / "reference.json"
        if note.exists():
            kept = json.loads(note.read_text())
            if all(kept.get(key) == value for key, value in wanted.items()):
                self.kept = kept
                return
        for name, substeps in zip(NAMES, (self.substeps, self.substeps // 2)):
            say(f"reference in double with {substeps} substeps")
            run = self._run(name, substeps)
        settings = run["report"]["settings"]
        kept = {**wanted, "particles": run["report"]["particles"]}
        kept["spacing_m"] = settings["fluid"]["spacing_m"]
        kept["frame_rate_hz"] = settings["solver"]["frame_rate_hz"]
        apart = distances(*(numpy.load(self.path(n)) for n in NAMES), kept["spacing_m"])
        kept["horizon_s"] = time_within(apart, kept["frame_rate_hz"])
        self.path(NAMES[1]).unlink()
        note.write_text(json.dumps(kept, indent=2) + "\n")
        self.kept = kept

    def _run(self, name, substeps):
        point = {"solver.substeps": str(substeps), "precision": "double"}
        campaign = {**self.runner.campaign, "duration_s": self.seconds}
        runner = type(self.runner)(self.runner.program, campaign, timeout_s=3600)
        run = runner.run(point, record=self.path(name))
        if run["status"] != "ok":
            raise Refusal(f"--trajectory: the reference is {run['status']}: {run['message']}")
        return run

    def metrics(self, record_path, report):
        """Metrics of a run whose positions were recorded; none where the particles are others."""
        fluid, solver = report["settings"]["fluid"], report["settings"]["solver"]
        same = (report["particles"], fluid["spacing_m"], solver["frame_rate_hz"]) == tuple(
            self.kept[key] for key in ("particles", "spacing_m", "frame_rate_hz")
        )
        if not same or not record_path.exists():
            return {}
        reference = numpy.load(self.path(NAMES[0]), mmap_mode="r")
        apart = distances(numpy.load(record_path), reference, self.kept["spacing_m"])
        metrics = {}
        for part in (0.25, 0.5, 1.0):
            frame = round(part * (len(reference) - 1))
            if frame < len(apart):
                metrics[f"apart_spacings_at_{frame / self.kept['frame_rate_hz']:.2f}_s"] = float(
                    apart[frame]
                )
        metrics["within_a_spacing_s"] = time_within(apart, self.kept["frame_rate_hz"])
        return metrics
