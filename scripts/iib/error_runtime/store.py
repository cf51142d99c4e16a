"""The folder of one campaign: finished runs, and the tables made of them.

campaign.json  scene, duration and what else holds for every point: a folder keeps one campaign
runs.jsonl     one line per finished run, appended at once, so a stop loses only the run under way
points.csv     one line per point: medians and spread over its runs
points.json    the same with processor, commit, date and command
"""

import contextlib
import csv
import fcntl
import io
import json
import os
import pathlib

from iib.common.files import write_atomically
from iib.common.refusal import Refusal


class Store:
    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.runs_file = self.folder / "runs.jsonl"

    @contextlib.contextmanager
    def held(self, campaign, fresh=False):
        """Makes the folder or continues in it, and keeps others out meanwhile.

        campaign: dict that must be the same as before.
        """
        with self._lock() as lock:
            try:
                fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except OSError:
                raise Refusal(
                    f"--out {self.folder} is in use by another error_vs_runtime; wait for it, or "
                    "name another folder"
                )
            if fresh:
                self.runs_file.unlink(missing_ok=True)
                (self.folder / "campaign.json").unlink(missing_ok=True)
            self._hold_to(campaign)
            yield

    def _lock(self):
        try:
            self.folder.mkdir(parents=True, exist_ok=True)
            return open(self.folder / "lock", "w")
        except OSError as error:
            raise Refusal(
                f"--out {self.folder} cannot be written: {error.strerror}; name another folder"
            )

    def _hold_to(self, campaign):
        path = self.folder / "campaign.json"
        if not path.exists():
            write_atomically(path, json.dumps(campaign, indent=2) + "\n")
            return
        before = json.loads(path.read_text())
        for key in sorted({*before, *campaign}):
            if before.get(key) != campaign.get(key):
                raise Refusal(
                    f"--out {self.folder} holds results with {key} = {before.get(key)}, not "
                    f"{campaign.get(key)}; name another folder, or --fresh to begin anew"
                )

    def campaign(self):
        try:
            return json.loads((self.folder / "campaign.json").read_text())
        except (OSError, ValueError):
            raise Refusal(f"{self.folder} holds no results of error_vs_runtime; run it there first")

    def runs(self):
        """Finished runs; half a line, left by a kill while it was written, is no run."""
        if not self.runs_file.exists():
            return []
        runs = []
        for line in self.runs_file.read_text().splitlines():
            try:
                runs.append(json.loads(line))
            except ValueError:
                continue
        return runs

    def append(self, run):
        text = self.runs_file.read_text() if self.runs_file.exists() else ""
        half_a_line = text != "" and not text.endswith("\n")
        with self.runs_file.open("a") as file:
            file.write(("\n" if half_a_line else "") + json.dumps(run) + "\n")
            file.flush()
            os.fsync(file.fileno())

    def write_tables(self, rows, about):
        """points.csv and points.json. rows: list of dicts; about: dict of processor and so on."""
        columns = list(dict.fromkeys(name for row in rows for name in row))
        text = io.StringIO()
        writer = csv.DictWriter(text, columns, restval="", lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
        write_atomically(self.folder / "points.csv", text.getvalue())
        document = {**about, "campaign": self.campaign(), "points": rows}
        write_atomically(self.folder / "points.json", json.dumps(document, indent=2) + "\n")
