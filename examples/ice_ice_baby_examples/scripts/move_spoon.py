#!/usr/bin/python3
"""Moves the tf frame spoon in a circle; the sphere of scenes/stirred.yaml follows it."""
import math

import rospy
import tf2_ros
from geometry_msgs.msg import TransformStamped


def pose(time):
    spoon = TransformStamped()
    spoon.header.stamp = time
    spoon.header.frame_id, spoon.child_frame_id = "world", "spoon"
    angle = 4 * time.to_sec()
    spoon.transform.translation.x = 0.12 * math.cos(angle)
    spoon.transform.translation.y = 0.12 * math.sin(angle)
    spoon.transform.translation.z = 0.2
    spoon.transform.rotation.w = 1
    return spoon


def main():
    rospy.init_node("move_spoon")
    broadcaster, rate = tf2_ros.TransformBroadcaster(), rospy.Rate(50)
    while not rospy.is_shutdown():
        broadcaster.sendTransform(pose(rospy.Time.now()))
        rate.sleep()


if __name__ == "__main__":
    try:
        main()
    except rospy.ROSException:  # Ctrl-C
        pass
