"""A node of one's own, and what loads it: clients that call without rest, subscribers that never read."""
import os
import random
import signal
import socket
import struct
import subprocess
import tempfile
import threading
import time
import xmlrpc.client

import rosgraph
import rospy
from geometry_msgs.msg import Vector3

from harness import Node  # of test/ros


class SilentSubscriber:
    """Subscribes to a topic as roscpp and rospy do, and never reads a byte of it."""

    def __init__(self, node, topic, kind):
        master = rosgraph.Master('/silent_subscriber')
        api = xmlrpc.client.ServerProxy(master.lookupNode(node))
        _, _, (protocol, host, port) = api.requestTopic('/silent_subscriber', topic, [['TCPROS']])
        assert protocol == 'TCPROS', protocol
        self.socket = socket.create_connection((host, port), timeout=10)
        fields = ['callerid=/silent_subscriber', 'topic=' + topic, 'type=' + kind._type,
                  'md5sum=' + kind._md5sum]
        header = b''.join(struct.pack('<I', len(f)) + f.encode() for f in fields)
        self.socket.sendall(struct.pack('<I', len(header)) + header)

    def close(self):
        self.socket.close()


class Clients:
    """Threads that call services of a node, each at once again after the answer and a pause.

    roscpp itself loses a call in some ten thousand (ros/ros_comm issue 1976), so a client asks once
    more; only what is lost twice has failed.
    """

    def __init__(self, node, count, pause_s=0.0, seed=0):
        self.node = node
        self.pause_s = pause_s
        self.lock = threading.Lock()
        self.answered, self.lost, self.refused, self.failures = 0, 0, [], []
        self.stop = threading.Event()
        self.threads = [threading.Thread(target=self._run, args=(random.Random(seed + k),))
                        for k in range(count)]

    def __enter__(self):
        for thread in self.threads:
            thread.start()
        return self

    def __exit__(self, *_):
        self.stop.set()
        for thread in self.threads:
            thread.join()

    def _run(self, chance):
        while not self.stop.is_set():
            try:
                answer = self._answer(chance)
            except rospy.ServiceException as error:
                with self.lock:
                    self.failures.append(str(error))
                continue
            with self.lock:
                self.answered += 1
                if not answer.success:
                    self.refused.append(answer.message)
            time.sleep(self.pause_s)

    def _answer(self, chance):
        try:
            return self._call(chance)
        except rospy.ServiceException:
            with self.lock:
                self.lost += 1
            return self._call(chance)

    def _call(self, chance):
        """One harmless request; none of them changes how the scene runs."""
        call = chance.randrange(4)
        if call == 0:
            return self.node.set_temperature(temperature=20.0, ramp_s=0.0)
        if call == 1:
            return self.node.set_gravity(gravity=Vector3(0.0, 0.0, -9.81))
        if call == 2:
            return self.node.resume()
        return self.node.get_state()


class OwnNode:
    """A master and a simulation node on loopback, both ended with the `with` block."""

    name = '/sim'

    def __init__(self, scene, **parameters):
        self.parameters = dict(parameters, scene=scene)
        self.children = []
        self.pid = None
        self.node = None
        self.folder = tempfile.TemporaryDirectory()
        self.log = os.path.join(self.folder.name, 'log')

    def __enter__(self):
        with socket.socket() as probe:
            probe.bind(('127.0.0.1', 0))
            port = probe.getsockname()[1]
        os.environ.update(ROS_MASTER_URI='http://127.0.0.1:%d' % port, ROS_IP='127.0.0.1',
                          ROS_LOG_DIR=self.folder.name)
        os.environ.pop('ROS_HOSTNAME', None)
        self._start('rosmaster', '--core', '-p', str(port))
        while not rosgraph.is_master_online():
            time.sleep(0.1)
        rospy.init_node('load', disable_signals=True)
        self._start_node(self.parameters)
        return self

    def __exit__(self, *_):
        while self.children:
            self._end(self.children.pop())
        self.folder.cleanup()

    def restart(self, **parameters):
        """Ends the node and starts it again with these parameters changed."""
        self._end(self.children.pop())
        self._start_node(parameters)

    def running(self):
        """Whether the node has not ended."""
        return self.children[-1].poll() is None

    def told(self):
        """What the node has written to its log."""
        with open(self.log, encoding='utf-8', errors='replace') as log:
            return log.read()

    def _start_node(self, parameters):
        for name, value in parameters.items():
            rospy.set_param(self.name + '/' + name, value)
        self._start('rosrun', 'ice_ice_baby', 'simulation_node', '__name:=' + self.name[1:])
        self.node = Node(self.name)
        self.pid = process_of(self.name)

    @staticmethod
    def _end(child):
        child.send_signal(signal.SIGINT)
        try:
            child.wait(timeout=20)
        except subprocess.TimeoutExpired:  # a master may wait for connections that nobody ends
            child.kill()
            child.wait()

    def _start(self, *command):
        with open(self.log, 'a', encoding='utf-8') as log:
            self.children.append(subprocess.Popen(command, stdout=log, stderr=log))


def memory_mb(pid):
    """Resident memory of a process."""
    with open('/proc/%d/status' % pid, encoding='ascii') as status:
        line = next(line for line in status if line.startswith('VmRSS'))
    return int(line.split()[1]) / 1024.0


def process_of(node):
    """Process id of a node on this machine."""
    api = xmlrpc.client.ServerProxy(rosgraph.Master('/ros_load').lookupNode(node))
    return api.getPid('/ros_load')[2]
