#!/usr/bin/python3
"""Starts the scene of the argument, without one the scene that is running."""
import sys

import rospy
from ice_ice_baby.srv import Reset

rospy.init_node("reset_scene", anonymous=True)
rospy.wait_for_service("/ice_ice_baby/reset")
answer = rospy.ServiceProxy("/ice_ice_baby/reset", Reset)(scene=(sys.argv + [""])[1])
print(answer.message, flush=True)
sys.exit(0 if answer.success else 1)
