#!/usr/bin/python3
"""The node as a process: refusals at the start, prompt ends, a master that goes and comes back."""
import os
import re
import signal
import socket
import subprocess
import time
import unittest

import yaml

SCENES = os.path.join(os.path.dirname(os.path.abspath(__file__)), 'scenes')


def free_port():
    with socket.socket() as probe:
        probe.bind(('127.0.0.1', 0))
        return probe.getsockname()[1]


class Process(unittest.TestCase):
    def setUp(self):
        self.port = free_port()
        self.env = dict(os.environ, ROS_MASTER_URI='http://127.0.0.1:%d' % self.port,
                        ROS_IP='127.0.0.1', ICE_ICE_BABY_SCENES=SCENES)
        self.children = []

    def tearDown(self):
        for child in self.children:
            if child.poll() is None:
                child.kill()
            child.communicate()

    def start(self, *command):
        child = subprocess.Popen(command, env=self.env, stdout=subprocess.PIPE,
                                 stderr=subprocess.STDOUT, text=True)
        self.children.append(child)
        return child

    def start_master(self):
        master = self.start('rosmaster', '--core', '-p', str(self.port))
        deadline = time.monotonic() + 20
        while time.monotonic() < deadline:
            with socket.socket() as probe:
                if probe.connect_ex(('127.0.0.1', self.port)) == 0:
                    return master
            time.sleep(0.05)
        self.fail('no master')

    def start_node(self, *parameters):
        return self.start('rosrun', 'ice_ice_baby', 'simulation_node', '__name:=sim',
                          *('_' + p for p in parameters))

    def run_tool(self, *command):
        return subprocess.run(command, env=self.env, timeout=20, check=False, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)

    def state(self, timeout_s=20.0):
        deadline = time.monotonic() + timeout_s
        while time.monotonic() < deadline:
            answer = self.run_tool('rosservice', 'call', '/sim/get_state')
            if answer.returncode == 0:
                return yaml.safe_load(answer.stdout)['state']
            time.sleep(0.2)
        self.fail('get_state does not answer: ' + answer.stdout)

    def assert_refused(self, parameters, *words):
        node = self.start_node(*parameters)
        out, _ = node.communicate(timeout=20)
        self.assertEqual(node.returncode, 1, out)
        for word in words:
            self.assertIn(word, out)

    def assert_ends(self, child, sig, within_s):
        start = time.monotonic()
        child.send_signal(sig)
        out, _ = child.communicate(timeout=30)
        self.assertEqual(child.returncode, 0, out)
        self.assertLess(time.monotonic() - start, within_s)
        return out

    def test_refuses_bad_parameters(self):
        self.start_master()
        self.assert_refused(['scene:=smal'], 'no scene "smal"', 'did you mean small')
        self.assert_refused(['threads:=-3'], '~threads', '-3', '[0, 1024]')
        self.run_tool('rosparam', 'delete', '/sim')
        self.assert_refused(['speling:=1'], 'unknown parameter ~speling')
        self.run_tool('rosparam', 'delete', '/sim')
        self.assert_refused(['overrides/solver/substeps:=-1', 'scene:=small'], 'solver.substeps',
                            '[0, 1000]')
        self.run_tool('rosparam', 'delete', '/sim')
        self.assert_refused(['overrides/solver/substep:=4', 'scene:=small'],
                            'unknown key solver.substep', 'did you mean solver.substeps')

    def test_lists_its_parameters_without_a_master(self):
        table = self.run_tool('rosrun', 'ice_ice_baby', 'simulation_node', '--parameters')
        self.assertEqual(table.returncode, 0)
        self.assertTrue(re.search(r'`real_time_factor` \| 1 \| 0 to 1000', table.stdout))
        unknown = self.run_tool('rosrun', 'ice_ice_baby', 'simulation_node', '--parametres')
        self.assertEqual(unknown.returncode, 1)
        self.assertIn('--parametres', unknown.stdout)

    def test_ends_promptly(self):
        self.start_master()
        for sig in (signal.SIGINT, signal.SIGTERM):
            node = self.start_node('scene:=small', 'threads:=1')
            self.assertEqual(self.state()['scene'], 'small')
            self.assert_ends(node, sig, 3.0)

    def test_ends_promptly_while_a_frame_takes_long(self):
        self.start_master()
        node = self.start_node('scene:=slow', 'overrides/solver/substeps:=200')
        self.state()
        time.sleep(1.0)
        self.assert_ends(node, signal.SIGINT, 4.0)

    def test_ends_promptly_without_a_master(self):
        node = self.start_node('scene:=small')  # waits to set its parameter
        time.sleep(1.5)
        self.assertIsNone(node.poll())
        self.assertIn('Failed to contact master', self.assert_ends(node, signal.SIGINT, 3.0))
        node = self.start('rosrun', 'ice_ice_baby', 'simulation_node')  # waits to register
        time.sleep(1.5)
        self.assertIn('Failed to contact master', self.assert_ends(node, signal.SIGTERM, 3.0))

    def test_survives_a_restart_of_the_master(self):
        master = self.start_master()
        node = self.start_node('scene:=small', 'threads:=1')
        frame = self.state()['frame']
        master.terminate()
        master.communicate(timeout=20)
        time.sleep(3.0)
        self.assertIsNone(node.poll())
        self.start_master()
        state = self.state()
        self.assertGreater(state['frame'], frame + 60)  # it went on meanwhile
        for topic in ('/sim/particles', '/sim/state', '/diagnostics'):
            heard = self.run_tool('timeout', '15', 'rostopic', 'echo', '-n1', '--noarr', topic)
            self.assertEqual(heard.returncode, 0, heard.stdout)
        self.assertIn('/tf_static', self.run_tool('rostopic', 'list').stdout)
        answer = self.run_tool('rosservice', 'call', '/sim/set_temperature', 'temperature: -5')
        self.assertIn('True', answer.stdout)
        self.assertEqual(self.run_tool('rosnode', 'ping', '-c1', '/sim').returncode, 0)
        self.assert_ends(node, signal.SIGINT, 3.0)


if __name__ == '__main__':
    import rostest
    rostest.rosrun('ice_ice_baby', 'process', Process)
