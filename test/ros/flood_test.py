#!/usr/bin/python3
"""Fifty clients and ten subscribers that never read: frames go on, queues stay bounded."""
import pathlib
import sys
import unittest

import rospy
from ice_ice_baby.msg import State
from sensor_msgs.msg import PointCloud2

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from iib.ros.load import Clients, SilentSubscriber
from iib.ros.node import Latest, Node, memory_mb, process_of

CLIENTS, SUBSCRIBERS, FRAMES = 50, 10, 200


class Flood(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node('flood_test')
        cls.node = Node()

    def test_frames_go_on_and_every_call_is_answered(self):
        self.node.resume()
        start = self.node.when(lambda s: s.frame > 5, 'frames')
        with Latest('/sim/state', State) as states:
            with Clients(self.node, CLIENTS) as clients:
                end = self.node.when(lambda s: s.frame > start.frame + FRAMES, 'frames', 60.0)
                states.wait(lambda s: s.frame > start.frame + FRAMES // 2, 'states')
            frames = [s.frame for s in states.messages]
        self.assertEqual(clients.failures, [])
        self.assertEqual(set(clients.refused) - {self.full()}, set())
        self.assertGreater(clients.answered, CLIENTS)
        self.assertLessEqual(clients.lost, 1 + clients.answered // 1000)
        self.assertEqual(frames, sorted(frames))
        self.assertEqual(end.particles, start.particles)
        # No frame was lost: each that ran has moved time by its own length.
        self.assertAlmostEqual(end.time_s, end.frame / 60.0, places=6)
        self.assertTrue(self.node.pause().success)
        self.node.when(lambda s: s.paused, 'the pause')

    @staticmethod
    def full():
        return '1000 commands wait for the frame under way to end; try again later'

    def test_subscribers_that_never_read_cost_no_memory(self):
        process = process_of('/sim')
        self.node.start()
        silent = [SilentSubscriber('/sim', '/sim/particles', PointCloud2)
                  for _ in range(SUBSCRIBERS)]
        self.node.when(lambda s: s.topics[0].subscribers >= SUBSCRIBERS, 'the subscribers')
        with Latest('/sim/particles', PointCloud2) as clouds:
            before = memory_mb(process)
            sent = self.node.state().topics[0]
            self.node.resume()
            self.node.when(lambda s: s.topics[0].messages > sent.messages + FRAMES, 'clouds', 60.0)
            now = self.node.pause() and self.node.state().topics[0]
            # Each of them has missed more than all its buffers may hold.
            self.assertGreater(len(clouds.messages), FRAMES // 2)
        size = (now.bytes - sent.bytes) / (now.messages - sent.messages)
        in_queues = 3 * SUBSCRIBERS * size / 2**20
        self.assertLess(memory_mb(process) - before, in_queues + 20.0)
        for subscriber in silent:
            subscriber.close()
        self.node.when(lambda s: s.topics[0].subscribers <= 1, 'their end')


if __name__ == '__main__':
    import rostest
    rostest.rosrun('ice_ice_baby', 'flood', Flood)
