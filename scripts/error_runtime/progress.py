"""A progress bar with the time left on a terminal, nothing in a pipe."""

import sys
import time


def clock(seconds):
    minutes, seconds = divmod(int(round(seconds)), 60)
    return f"{minutes}:{seconds:02d}"


class Progress:
    """Knows how long each point took, so later rounds are foretold well."""

    def __init__(self, runs, stream=sys.stderr):
        self.left = [name for name in runs]  # one entry per run to come
        self.total = len(self.left)
        self.took = {}
        self.start = time.monotonic()
        self.stream = stream
        self.shown = stream.isatty()

    def seconds_left(self):
        if not self.took:
            return None
        mean = sum(self.took.values()) / len(self.took)
        return sum(self.took.get(name, mean) for name in self.left)

    def begin(self, name):
        self._draw(name)

    def end(self, name, seconds):
        self.took[name] = seconds
        self.left.remove(name)
        self._draw(name)

    def _draw(self, name):
        if not self.shown:
            return
        done = self.total - len(self.left)
        filled = 30 * done // max(self.total, 1)
        left = self.seconds_left()
        times = f"{clock(time.monotonic() - self.start)}<{clock(left) if left is not None else '?'}"
        bar = "#" * filled + " " * (30 - filled)
        percent = 100 * done // max(self.total, 1)
        self.stream.write(f"\r\033[K{percent:3d}%|{bar}| {done}/{self.total} [{times}] {name}")
        self.stream.flush()

    def close(self):
        if self.shown:
            self.stream.write("\r\033[K")
            self.stream.flush()
