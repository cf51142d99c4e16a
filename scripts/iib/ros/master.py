"""A ROS master of one's own, on loopback, started from outside of ROS."""

import os
import socket
import time


def command(port):
    return ("rosmaster", "--core", "-p", str(port))


def environment(port, base=os.environ):
    """The variables with which programs find that master, and no other machine finds them."""
    own = {**base, "ROS_MASTER_URI": f"http://127.0.0.1:{port}", "ROS_IP": "127.0.0.1"}
    own.pop("ROS_HOSTNAME", None)
    return own


def await_answer(port, timeout_s=20.0):
    deadline = time.monotonic() + timeout_s
    while time.monotonic() < deadline:
        with socket.socket() as probe:
            if probe.connect_ex(("127.0.0.1", port)) == 0:
                return
        time.sleep(0.05)
    raise TimeoutError(f"no ROS master answered at port {port} within {timeout_s:g} s")
