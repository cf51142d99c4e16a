#!/usr/bin/python3
"""Fills the cup of an arm at a tap, carries it to a glass and pours ~pour_ml of it into the glass.

~sense is what it pours by: vessels, the volume in the cup, or wrist, the weight that the arm feels.
Prints the result and leaves it in ~result. Exit code: 0 poured within 2 %, nothing spilled, 1 not.
"""
import math
import sys
import time

import rospy
import tf2_ros
from arm import Arm
from ice_ice_baby.srv import GetState, SetSource
from senses import Senses
from std_srvs.srv import Trigger

SIMULATION = "/ice_ice_baby/"
UNDER_TAP_M, LIFTED_M = (0.39, 0.114), (0.39, 0.13)  # lip from the base of the arm: forward, up
INSIDE_M, ABOVE_M = 0.02, 0.15  # lip that pours: from the axis and the floor of the glass
BEFORE_M, DIPPED_RAD = (-0.07, 0.08), 0.45  # lip of the upright cup from there; tilt of arrival
RADIUS_M, DEPTH_M = 0.04, 0.11  # of the cup
RATE_HZ, FIRST_ML_S, MOST_ML_S, LAST_ML_S = 30, 8.0, 40.0, 3.0
RAD_PER_ML = 0.003  # tilt that pours out a millilitre, about
BACK_RAD_S = 1.0  # speed of tilting back


def call(service, kind, **request):
    rospy.wait_for_service(SIMULATION + service)
    return rospy.ServiceProxy(SIMULATION + service, kind)(**request)


class Pourer:
    def __init__(self):
        self.arm, self.senses = Arm("/arm/command"), Senses(SIMULATION, ("cup", "glass"))
        self.sense = rospy.get_param("~sense", "vessels")
        self.tf = tf2_ros.Buffer()
        self.listener = tf2_ros.TransformListener(self.tf)

    def content_ml(self):
        vessels = self.sense == "vessels"
        return self.senses.ml("cup") if vessels else self.senses.weight_g["cup"]

    def fill(self, fill_ml):
        self.arm.move(UNDER_TAP_M, 0.0, 2.0)
        call("set_source", SetSource, name="tap", open=True)
        while self.senses.ml("cup") < fill_ml:
            rospy.sleep(1.0 / RATE_HZ)
        call("set_source", SetSource, name="tap", open=False)
        rospy.sleep(1.0)
        self.arm.move(LIFTED_M, 0.0, 1.0)

    def lip(self, tilt):
        """Where the lip is: it comes down to the glass while the cup begins to tilt."""
        rest = 0.5 + 0.5 * math.cos(math.pi * min(tilt / DIPPED_RAD, 1.0))
        return [pours + rest * before for pours, before in zip(self.pours_m, BEFORE_M)]

    def carry(self):
        glass = self.tf.lookup_transform("arm_base", "ice_ice_baby/scene/glass", rospy.Time())
        at = glass.transform.translation
        self.arm.turn = math.atan2(at.y, at.x)
        self.pours_m = math.hypot(at.x, at.y) - INSIDE_M, at.z + ABOVE_M
        self.arm.move(self.lip(0.0), 0.0, 2.5)
        rospy.sleep(1.5)  # until the water is calm, as its weight is measured

    def pour(self, pour_ml):
        begin_ml, poured_ml, flow_ml_s = self.content_ml(), 0.0, 0.0
        level_m = 1e-6 * begin_ml / (math.pi * RADIUS_M**2)
        tilt = math.atan((DEPTH_M - level_m) / RADIUS_M) - 0.1  # just before water reaches the lip
        self.arm.move(self.lip(tilt), tilt, 1.5)
        while pour_ml - poured_ml > 0.5 + 0.1 * flow_ml_s:  # what flows while the cup tilts back
            wanted_ml_s = min(FIRST_ML_S + 0.7 * max(poured_ml, 0.0), MOST_ML_S)
            wanted_ml_s = min(wanted_ml_s, LAST_ML_S + 0.8 * (pour_ml - poured_ml))
            tilt_rad_s = RAD_PER_ML * (2.5 * wanted_ml_s - 1.5 * flow_ml_s)
            tilt_rad_s = min(max(tilt_rad_s, -0.3), 0.3)
            tilt += tilt_rad_s / RATE_HZ
            self.arm.move(self.lip(tilt), tilt, 1.0 / RATE_HZ, tilt_rad_s)
            before_ml, poured_ml = poured_ml, begin_ml - self.content_ml()
            flow_ml_s += 0.15 * (RATE_HZ * (poured_ml - before_ml) - flow_ml_s)
        while tilt > 0.02:
            tilt_rad_s = -min(BACK_RAD_S, 3.0 * tilt)  # a jolt at the end would throw water out
            tilt += tilt_rad_s / RATE_HZ
            self.arm.move(self.lip(tilt), tilt, 1.0 / RATE_HZ, tilt_rad_s)
        self.arm.move(self.lip(0.0), 0.0, 0.5)
        rospy.sleep(1.5)


def main():
    rospy.init_node("pour")
    pour_ml, fill_ml = rospy.get_param("~pour_ml", 200.0), rospy.get_param("~fill_ml", 300.0)
    if not 0 < pour_ml + 40 <= fill_ml <= 400:  # fuller, it would spill; emptier, tilt too far
        sys.exit("~fill_ml is %g; it must be from ~pour_ml + 40 to 400" % fill_ml)
    pourer = Pourer()
    senses = pourer.senses
    if pourer.sense not in ("vessels", "wrist"):
        sys.exit("~sense is %s; it must be vessels or wrist" % pourer.sense)
    while not (pourer.arm.listens() or rospy.is_shutdown()):
        time.sleep(0.1)
    call("set_source", SetSource, name="tap", open=False)
    begin_s = time.monotonic()
    call("resume", Trigger)
    while not senses.vessels:
        rospy.sleep(1.0 / RATE_HZ)
    pourer.fill(fill_ml)
    pourer.carry()
    full_g = senses.weight_g["cup"]
    pourer.pour(pour_ml)
    state = call("get_state", GetState).state
    result = {
        "poured_ml": senses.ml("glass"),
        "error_percent": 100 * (senses.ml("glass") / pour_ml - 1),
        "spilled_particles": state.particles + state.spilled - senses.particles(),
        "wrist_g": senses.weight_g["cup"] - full_g,
        "scale_g": senses.weight_g["glass"],
        "simulated_s": state.time_s,
        "real_time_factor": state.time_s / (time.monotonic() - begin_s),
    }
    rospy.set_param("~result", result)
    print("\n".join("%s: %.2f" % item for item in result.items()), flush=True)
    return 0 if abs(result["error_percent"]) <= 2 and result["spilled_particles"] == 0 else 1


if __name__ == "__main__":
    try:
        sys.exit(main())
    except (rospy.ROSException, rospy.ServiceException):
        if not rospy.is_shutdown():  # Ctrl-C
            raise
