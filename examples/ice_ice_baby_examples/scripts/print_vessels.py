#!/usr/bin/python3
"""Prints how much water each vessel holds and how high it stands."""
import rospy
from ice_ice_baby.msg import Vessels


def print_vessels(message):
    for v in message.vessels:
        print("%s: %.3f l, level %.3f m" % (v.name, 1000 * v.water_m3, v.level_m), flush=True)


rospy.init_node("print_vessels", anonymous=True)
rospy.Subscriber("/ice_ice_baby/vessels", Vessels, print_vessels, queue_size=1)
rospy.spin()
