#!/usr/bin/python3
"""Changes the temperature of the scene to the argument, in degrees Celsius, within 2 s."""
import sys

import rospy
from ice_ice_baby.srv import SetTemperature

rospy.init_node("set_temperature", anonymous=True)
rospy.wait_for_service("/ice_ice_baby/set_temperature")
set_temperature = rospy.ServiceProxy("/ice_ice_baby/set_temperature", SetTemperature)
answer = set_temperature(temperature=float((sys.argv + ["20"])[1]), ramp_s=2.0)
print(answer.message, flush=True)
sys.exit(0 if answer.success else 1)
