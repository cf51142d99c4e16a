"""Tests that start masters and nodes of their own, and end them as rudely as they like."""
import os
import pathlib
import signal
import subprocess
import sys
import time
import unittest

import yaml

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from iib.common.processes import free_port
from iib.ros import master
from iib.ros.program import find_program

SIMULATION_NODE = find_program("simulation_node")
SCENES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "scenes")


class Processes(unittest.TestCase):
    def setUp(self):
        self.port = free_port()
        self.env = dict(master.environment(self.port), ICE_ICE_BABY_SCENES=SCENES)
        self.children = []

    def tearDown(self):
        for child in self.children:
            try:
                os.killpg(child.pid, signal.SIGKILL)  # whoever it has started among them
            except ProcessLookupError:
                pass
            child.communicate()

    def start(self, *command, stdin=None):
        child = subprocess.Popen(
            command,
            env=self.env,
            stdin=stdin,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            start_new_session=True,
        )
        self.children.append(child)
        return child

    def start_master(self):
        started = self.start(*master.command(self.port))
        master.await_answer(self.port)
        return started

    def start_node(self, *parameters):
        return self.start(SIMULATION_NODE, "__name:=sim", *("_" + p for p in parameters))

    def run_tool(self, *command):
        return subprocess.run(
            command,
            env=self.env,
            timeout=20,
            check=False,
            text=True,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
        )

    def state(self, timeout_s=20.0):
        deadline = time.monotonic() + timeout_s
        while time.monotonic() < deadline:
            answer = self.run_tool("rosservice", "call", "/sim/get_state")
            if answer.returncode == 0:
                return yaml.safe_load(answer.stdout)["state"]
            time.sleep(0.2)
        self.fail("get_state does not answer: " + answer.stdout)

    def assert_refused(self, parameters, *words):
        node = self.start_node(*parameters)
        out, _ = node.communicate(timeout=20)
        self.assertEqual(node.returncode, 1, out)
        for word in words:
            self.assertIn(word, out)

    def assert_ends(self, child, sig, within_s):
        start = time.monotonic()
        child.send_signal(sig)
        out, _ = child.communicate(timeout=30)
        self.assertEqual(child.returncode, 0, out)
        self.assertLess(time.monotonic() - start, within_s)
        return out
