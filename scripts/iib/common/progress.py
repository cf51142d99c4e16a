"""A progress bar with the time left on a terminal, nothing in a pipe."""

import contextlib
import sys
import threading
import time


def clock(seconds):
    minutes, seconds = divmod(int(round(seconds)), 60)
    return f"{minutes}:{seconds:02d}"


class Progress:
    """Predicts later rounds from how long each run took. Several threads may use it."""

    def __init__(self, runs, stream=sys.stderr):
        self.left = [name for name in runs]  # one entry per run to come
        self.total = len(self.left)
        self.took = {}
        self.start = time.monotonic()
        self.stream = stream
        self.shown = stream.isatty()
        self.lock = threading.Lock()

    def seconds_left(self):
        if not self.took:
            return None
        mean = sum(self.took.values()) / len(self.took)
        return sum(self.took.get(name, mean) for name in self.left)

    def begin(self, name):
        with self.lock:
            self._draw(name)

    def end(self, name, seconds):
        with self.lock:
            self.took[name] = seconds
            self.left.remove(name)
            self._draw(name)

    @contextlib.contextmanager
    def run(self, name):
        """Times what is done in the `with` block."""
        start = time.monotonic()
        self.begin(name)
        try:
            yield
        except BaseException:
            self.close()
            raise
        self.end(name, time.monotonic() - start)

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
        """Clears the line; the next begin or end draws the bar again."""
        if self.shown:
            self.stream.write("\r\033[K")
            self.stream.flush()
