#!/usr/bin/python3
"""Prints how many particles there are and how cold the coldest one is."""
import rospy
from sensor_msgs.msg import PointCloud2
from sensor_msgs.point_cloud2 import read_points


def print_coldest(cloud):
    coldest = min(celsius for (celsius,) in read_points(cloud, ["temperature"]))
    print("%d particles, coldest %.1f degrees Celsius" % (cloud.width, coldest), flush=True)


rospy.init_node("print_particles", anonymous=True)
rospy.Subscriber("/ice_ice_baby/particles", PointCloud2, print_coldest, queue_size=1)
rospy.spin()
