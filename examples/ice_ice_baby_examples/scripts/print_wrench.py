#!/usr/bin/python3
"""Prints the weight that presses on the bowl of scenes/stirred.yaml."""
import rospy
from geometry_msgs.msg import WrenchStamped


def print_wrench(message):
    print("bowl: %.2f N downwards" % -message.wrench.force.z, flush=True)


rospy.init_node("print_wrench", anonymous=True)
rospy.Subscriber("/ice_ice_baby/wrenches/bowl", WrenchStamped, print_wrench, queue_size=1)
rospy.spin()
