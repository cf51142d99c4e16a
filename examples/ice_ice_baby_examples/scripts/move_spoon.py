#!/usr/bin/python3
"""Moves the tf frame spoon in a circle; the sphere of scenes/stirred.yaml follows it."""
import math

import rospy
import tf2_ros
from geometry_msgs.msg import TransformStamped


def move_spoon(event):
    spoon = TransformStamped()
    spoon.header.stamp = event.current_real
    spoon.header.frame_id, spoon.child_frame_id = "world", "spoon"
    angle = 4 * event.current_real.to_sec()
    spoon.transform.translation.x = 0.12 * math.cos(angle)
    spoon.transform.translation.y = 0.12 * math.sin(angle)
    spoon.transform.translation.z = 0.2
    spoon.transform.rotation.w = 1
    broadcaster.sendTransform(spoon)


rospy.init_node("move_spoon")
broadcaster = tf2_ros.TransformBroadcaster()
rospy.Timer(rospy.Duration(0.02), move_spoon)
rospy.spin()
