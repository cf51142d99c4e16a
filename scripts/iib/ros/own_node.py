"""A simulation node and a master for it, of one's own."""

import os
import subprocess
import tempfile

import rospy

from iib.common.processes import end, free_port
from iib.ros import master
from iib.ros.node import Node, process_of
from iib.ros.program import find_program


class OwnNode:
    """A master and a simulation node on loopback, both ended with the `with` block."""

    name = "/sim"
    start_s = 30.0  # how long the node may take to start

    def __init__(self, scene, **parameters):
        self.parameters = dict(parameters, scene=scene)
        self.children = []
        self.pid = None
        self.node = None
        self.folder = tempfile.TemporaryDirectory()
        self.log = os.path.join(self.folder.name, "log")

    def __enter__(self):
        try:
            self._begin()
        except BaseException:
            self.__exit__()
            raise
        return self

    def _begin(self):
        port = free_port()
        os.environ.pop("ROS_HOSTNAME", None)
        os.environ.update(master.environment(port), ROS_LOG_DIR=self.folder.name)
        self._start(*master.command(port))
        master.await_answer(port)
        rospy.init_node("load", disable_signals=True)
        self._start_node(self.parameters)

    def __exit__(self, *_):
        while self.children:
            end(self.children.pop())
        self.folder.cleanup()

    def restart(self, **parameters):
        """Ends the node and starts it again with these parameters changed."""
        end(self.children.pop())
        self._start_node(parameters)

    def running(self):
        """Whether the node has not ended."""
        return self.children[-1].poll() is None

    def read_log(self):
        """What the node has written to its log."""
        with open(self.log, encoding="utf-8", errors="replace") as log:
            return log.read()

    def _start_node(self, parameters):
        for name, value in parameters.items():
            rospy.set_param(self.name + "/" + name, value)
        self._start(find_program("simulation_node"), "__name:=" + self.name[1:])
        self.node = Node(self.name, self.start_s)
        self.pid = process_of(self.name)

    def _start(self, *command):
        with open(self.log, "a", encoding="utf-8") as log:
            self.children.append(subprocess.Popen(command, stdout=log, stderr=log))
