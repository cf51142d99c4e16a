#!/usr/bin/python3
"""Pictures of cameras that stand still and that follow a frame, against geometry."""
import math
import pathlib
import sys
import time
import unittest

import numpy as np
import rospy
from geometry_msgs.msg import TransformStamped
from sensor_msgs.msg import CameraInfo, Image
from tf2_msgs.msg import TFMessage

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from iib.ros.node import Latest, Node

NOTHING, WATER, ICE, SOLID = range(4)
SPACING = 0.02
FOCAL = 160 / math.tan(math.radians(30))  # of the camera above, in pixels


def depth_of(image):
    return np.frombuffer(image.data, np.float32).reshape(image.height, image.width)


def labels_of(image):
    return np.frombuffer(image.data, np.uint16).reshape(image.height, image.width)


class Cameras(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("cameras_test")
        cls.node = Node()
        cls.tf = rospy.Publisher("/tf", TFMessage, queue_size=10)

    def setUp(self):
        self.node.start("watched")

    def test_depth_from_above(self):
        with Latest("/sim/cameras/above/depth/image_raw", Image) as topic:
            image = topic.wait()
        self.assertEqual((image.encoding, image.width, image.height), ("32FC1", 320, 240))
        self.assertEqual(image.header.frame_id, "ice_ice_baby/scene/above")
        depth = depth_of(image)
        # The water from -0.12 to 0.12 m below the camera, its surface at 0.54 m.
        across = int(0.08 / (2 - 0.54) * FOCAL)
        water = depth[120 - across : 120 + across, 160 - across : 160 + across]
        self.assertAlmostEqual(water.mean(), 2 - 0.54, delta=0.1 * SPACING)
        self.assertLess(np.abs(water - water.mean()).max(), 0.1 * SPACING)
        self.assertAlmostEqual(depth[5, 5], 2.0, delta=1e-3)  # the ground, as tanks are clear
        # The ball: x of the scene is to the right.
        column = 160 + int(round(0.5 / (2 - 0.2) * FOCAL))
        self.assertAlmostEqual(depth[120, column], 2 - 0.2, delta=1e-3)

    def test_labels_from_above(self):
        with Latest("/sim/cameras/above/label/image_raw", Image) as topic:
            image = topic.wait()
            labels = labels_of(image)
            self.assertEqual(image.encoding, "16UC1")
            self.assertEqual(labels[120, 160], WATER)
            self.assertEqual(set(np.unique(labels)), {WATER, SOLID})
            side = 0.24 / (2 - 0.54) * FOCAL
            self.assertAlmostEqual((labels == WATER).sum(), side**2, delta=0.05 * side**2)
            self.assertTrue(self.node.set_temperature(temperature=-9, ramp_s=0, target="").success)
            self.node.run_frames(1)
            labels = labels_of(topic.wait(lambda m: (labels_of(m) == ICE).any(), "ice"))
        self.assertEqual(set(np.unique(labels)), {ICE, SOLID})

    def test_camera_info_places_points(self):
        with Latest("/sim/cameras/above/depth/camera_info", CameraInfo) as topic:
            time.sleep(0.5)
            self.assertEqual(topic.messages, [])  # nobody looks at a picture
            with Latest("/sim/cameras/above/label/image_raw", Image) as picture:
                image, info = picture.wait(), topic.wait()
        self.assertEqual(info.header, image.header)
        self.assertAlmostEqual(info.K[0], FOCAL, places=6)
        self.assertEqual((info.K[2], info.K[5], list(info.D)), (159.5, 119.5, [0.0] * 5))
        rows, columns = np.nonzero(labels_of(image) == WATER)
        x = (columns.mean() - info.K[2]) / info.K[0] * (2 - 0.54)
        y = (rows.mean() - info.K[5]) / info.K[4] * (2 - 0.54)
        self.assertAlmostEqual(x, 0, delta=0.5 * SPACING)
        self.assertAlmostEqual(y, 0, delta=0.5 * SPACING)

    def put_eye(self, distance_m):
        """Before the water, looking along x of the scene: z ahead, x to the right, y down."""
        eye = TransformStamped()
        eye.header.stamp = rospy.Time.now()
        eye.header.frame_id = "ice_ice_baby/scene"
        eye.child_frame_id = "eye_optical"
        eye.transform.translation.x = -0.12 - distance_m
        eye.transform.translation.z = 0.42
        q = eye.transform.rotation
        q.x, q.y, q.z, q.w = -0.5, 0.5, -0.5, 0.5
        self.tf.publish(TFMessage([eye]))

    def test_an_eye_that_moves_while_the_scene_is_paused(self):
        with Latest("/sim/cameras/eye/depth/image_raw", Image) as topic:
            for distance_m in (0.5, 0.3, 1.0):
                eye = rospy.Timer(rospy.Duration(0.02), lambda _, d=distance_m: self.put_eye(d))
                topic.wait(
                    lambda m, d=distance_m: abs(depth_of(m)[120, 160] - d) < 0.2 * SPACING,
                    "the water at %g m" % distance_m,
                )
                eye.shutdown()
        image = topic.messages[-1]
        self.assertEqual(image.header.frame_id, "eye_optical")
        depth = depth_of(image)
        self.assertTrue(np.isnan(depth[0]).all())  # above the horizon
        self.assertFalse(np.isnan(depth[-1]).any())  # the ground


if __name__ == "__main__":
    import rostest

    rostest.rosrun("ice_ice_baby", "cameras", Cameras)
