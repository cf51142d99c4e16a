"""A simulation and the arm of examples/pour in simulated time."""

import os
import subprocess
import sys

import roslib.packages
import rospy
import yaml

from iib.common.paths import ROOT
from iib.common.refusal import Refusal
from iib.ros.own_node import OwnNode

EXAMPLE = ROOT / "examples" / "pour"
LIMIT_S = 600.0  # of wall time for one start


class Bench(OwnNode):
    """Use it in `with`; then pour as often as needed."""

    name = "/ice_ice_baby"
    start_s = 300.0  # the tables of the cups take seconds, on a busy machine minutes

    def __init__(self, scene, threads):
        super().__init__(
            scene,
            threads=threads,
            publish_clock=True,
            real_time_factor=0.0,
            start_paused=True,
            vessels_rate_hz=1000.0,
            wrenches_rate_hz=1000.0,
        )
        self.scene = scene

    def _start_node(self, parameters):
        found = roslib.packages.find_node("robot_state_publisher", "robot_state_publisher")
        if not found:
            raise Refusal("no robot_state_publisher; run scripts/install_dependencies robot")
        rospy.set_param("/use_sim_time", True)
        rospy.set_param("/robot_description", (EXAMPLE / "arm.urdf").read_text())
        rospy.set_param("/robot_state_publisher/publish_frequency", 1000.0)
        rospy.set_param("/arm", yaml.safe_load((EXAMPLE / "arm.yaml").read_text()))
        super()._start_node(parameters)
        self._start(found[0], "__name:=robot_state_publisher")
        self._start(sys.executable, str(EXAMPLE / "trajectory_player.py"))

    def pour(self, start, pour_ml, sense):
        """The result of pour.py, a dictionary of numbers."""
        self.node.pause()
        answer = self.node.load_scene(yaml=start.scene(self.scene))
        if not answer.success:
            raise Refusal(answer.message)
        command = [sys.executable, str(EXAMPLE / "pour.py")]
        command += [f"_pour_ml:={pour_ml}", f"_fill_ml:={start.fill_ml}", f"_sense:={sense}"]
        try:
            done = subprocess.run(
                command, env=os.environ, capture_output=True, text=True, timeout=LIMIT_S
            )
        except subprocess.TimeoutExpired:
            raise Refusal(f"start {start.number} took more than {LIMIT_S:g} s") from None
        if not rospy.has_param("/pour/result"):
            raise Refusal(f"start {start.number}: {done.stderr.strip() or done.stdout.strip()}")
        result = rospy.get_param("/pour/result")
        rospy.delete_param("/pour/result")
        return dict(result, succeeded=done.returncode == 0)
