#!/usr/bin/python3
"""Simulated time on /clock, other nodes that follow it, and two clocks at once."""
import pathlib
import sys
import time
import unittest

import rosgraph
import rospy
from rosgraph_msgs.msg import Clock

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from iib.ros.node import Latest, Node


def seconds(message):
    return message.clock.to_sec()


class ClockTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node('clock_test')
        cls.giver, cls.follower = Node('/giver'), Node('/follower')

    def test_1_clock_is_simulated_time(self):
        self.giver.start()
        with Latest('/clock', Clock) as clocks:
            start = seconds(clocks.wait(what='a clock while paused'))
            time.sleep(0.3)
            self.assertEqual({seconds(m) for m in clocks.messages}, {start})
            self.giver.run_frames(30)
            clocks.wait(lambda m: abs(seconds(m) - start - 0.5) < 1e-6, 'half a second')
            self.giver.reset(scene='', preset='')
            self.giver.when(lambda s: s.frame == 0, 'the start')
            self.giver.run_frames(6)
            clocks.wait(lambda m: abs(seconds(m) - start - 0.6) < 1e-6, 'time that runs on')
            times = [seconds(m) for m in clocks.messages]
        self.assertEqual(times, sorted(times))
        self.assertAlmostEqual(self.giver.state().header.stamp.to_sec(), start + 0.6, places=5)

    def test_2_at_most_100_a_second(self):
        self.giver.start()
        self.giver.resume()
        with Latest('/clock', Clock) as clocks:
            time.sleep(2.0)
            count = len(clocks.messages)
        self.giver.pause()
        self.assertTrue(20 < count <= 205, count)

    def test_3_a_node_on_ros_time_runs_by_that_clock(self):
        self.giver.start()
        self.follower.resume()
        time.sleep(0.5)
        frame = self.follower.state().frame
        time.sleep(0.5)
        self.assertLessEqual(self.follower.state().frame, frame + 1)  # the clock stands still
        self.giver.resume()
        self.follower.when(lambda s: s.frame > frame + 20, 'frames with the clock')
        self.giver.pause()

    def test_4_a_second_clock_stays_silent(self):
        second = Node('/second')
        status = second.diagnostic('clock', lambda s: s.level == 2)
        self.assertIn('/giver publishes /clock already', status.message)
        publishers = dict(rosgraph.Master('/clock_test').getSystemState()[0])['/clock']
        self.assertEqual(publishers, ['/giver'])
        self.assertEqual(self.giver.diagnostic('clock', lambda s: True).level, 0)


if __name__ == '__main__':
    import rostest
    rostest.rosrun('ice_ice_baby', 'clock', ClockTest)
