"""Other programs: run one to its end, end one that runs."""

import random
import signal
import socket
import subprocess

from iib.common.refusal import Refusal

SHOWN_LINES = 30  # of the output of a program that failed


def run(command, **options):
    """Standard output of a program; a Refusal with the end of what it printed if it fails.

    options: as of subprocess.run; stderr=subprocess.STDOUT joins both outputs.
    """
    words = [str(word) for word in command]
    options = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True, **options}
    done = subprocess.run(words, **options)
    if done.returncode != 0:
        printed = (done.stdout or "") + (done.stderr or "")
        shown = "\n".join(printed.splitlines()[-SHOWN_LINES:])
        raise Refusal(f"failed: {' '.join(words)}\n{shown}".rstrip())
    return done.stdout


def end(child, patience_s=20.0):
    """As Ctrl-C does; kills what does not end in time."""
    child.send_signal(signal.SIGINT)
    try:
        child.wait(timeout=patience_s)
    except subprocess.TimeoutExpired:
        child.kill()
        child.wait()


def free_port():
    """A port of loopback that is free and below those that Linux gives to outgoing connections."""
    for _ in range(100):
        port = random.randrange(10000, 30000)
        with socket.socket() as probe:
            try:
                probe.bind(("127.0.0.1", port))
                return port
            except OSError:
                pass  # taken
    raise OSError("found no free port of 127.0.0.1 between 10000 and 30000")
