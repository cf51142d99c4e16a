#!/usr/bin/python3
"""The node as a process: refused parameters, prompt shutdown, loss and restart of the master."""
import re
import signal
import subprocess
import sys
import time

from processes import SIMULATION_NODE, Processes

# Keeps its connections open, so it reaches the node without a master.
CALLER = """
import rospy
from ice_ice_baby.srv import GetState, Reset
resets = [rospy.ServiceProxy('/sim/reset', Reset, persistent=True) for _ in range(3)]
state = rospy.ServiceProxy('/sim/get_state', GetState, persistent=True)
state()
for reset in resets:
    reset(scene='small')
print('connected', flush=True)
input()
print([reset(scene='followed').success for reset in resets], state().success)
"""


class Process(Processes):
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
        self.assert_refused(['scene:=small', 'checkpoint_folder:=here'], '~checkpoint_folder',
                            'absolute path')
        self.run_tool('rosparam', 'delete', '/sim')
        self.run_tool('rosparam', 'set', '/sim/overrides/spheres', str(list(range(5000))))
        self.assert_refused(['scene:=small'], 'spheres')
        self.run_tool('rosparam', 'delete', '/sim')
        self.run_tool('rosparam', 'set', '/sim', '[1, 2]')
        self.assert_refused([], '[1, 2]', 'rosparam delete')
        self.run_tool('rosparam', 'delete', '/sim')
        self.assert_refused(['overrides/solver/substep:=4', 'scene:=small'],
                            'unknown key solver.substep', 'did you mean solver.substeps')

    def test_lists_its_parameters_without_a_master(self):
        table = self.run_tool(SIMULATION_NODE, '--parameters')
        self.assertEqual(table.returncode, 0)
        self.assertTrue(re.search(r'`real_time_factor` \| 1 \| 0 to 1000', table.stdout))
        unknown = self.run_tool(SIMULATION_NODE, '--parametres')
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
        node = self.start(SIMULATION_NODE)  # waits to register
        time.sleep(1.5)
        self.assertIn('Failed to contact master', self.assert_ends(node, signal.SIGTERM, 3.0))

    def test_ends_though_the_master_does_not_answer(self):
        master = self.start_master()
        for sig in (signal.SIGINT, signal.SIGTERM):
            node = self.start_node('scene:=small', 'threads:=1')
            self.state()
            master.send_signal(signal.SIGSTOP)
            out = self.assert_ends(node, sig, 8.0)
            self.assertIn('The ROS master does not answer', out)
            master.send_signal(signal.SIGCONT)

    def test_the_first_of_two_nodes_of_one_name_says_why_it_ends(self):
        self.start_master()
        first = self.start_node('scene:=small', 'threads:=1')
        self.state()
        second = self.start_node('scene:=small', 'threads:=1')
        out, _ = first.communicate(timeout=20)
        self.assertEqual(first.returncode, 1, out)
        self.assertIn('Another node has registered as /sim', out)
        self.assertIn('__name:=', out)
        self.assertEqual(self.state()['scene'], 'small')  # the second serves
        self.run_tool('rosnode', 'kill', '/sim')
        out, _ = second.communicate(timeout=20)
        self.assertEqual(second.returncode, 0, out)
        self.assertIn('Asked to shut down', out)

    def test_resets_to_followers_wait_for_no_master(self):
        master = self.start_master()
        node = self.start_node('scene:=small', 'threads:=1')
        self.state()
        caller = self.start(sys.executable, '-c', CALLER, stdin=subprocess.PIPE)
        said = ''
        while 'connected' not in said:
            line = caller.stdout.readline()
            self.assertTrue(line, said)
            said += line
        master.terminate()
        master.communicate(timeout=20)
        out, _ = caller.communicate('\n', timeout=20)
        self.assertIn('[True, True, True] True', out)
        self.start_master()
        self.assertEqual(self.state()['scene'], 'followed')
        deadline = time.monotonic() + 20
        while '/sim' not in self.run_tool('rostopic', 'info', '/tf').stdout.partition('Subscribers')[2]:
            self.assertLess(time.monotonic(), deadline, 'nobody listens to /tf')
        self.assert_ends(node, signal.SIGINT, 3.0)

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
