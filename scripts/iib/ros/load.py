"""What loads a node: clients that call without rest, subscribers that never read."""

import random
import socket
import struct
import threading
import time
import xmlrpc.client

import rosgraph
import rospy
from geometry_msgs.msg import Vector3


class SilentSubscriber:
    """Subscribes to a topic as roscpp and rospy do, and never reads a byte of it."""

    def __init__(self, node, topic, kind):
        master = rosgraph.Master("/silent_subscriber")
        api = xmlrpc.client.ServerProxy(master.lookupNode(node))
        _, _, (protocol, host, port) = api.requestTopic("/silent_subscriber", topic, [["TCPROS"]])
        assert protocol == "TCPROS", protocol
        self.socket = socket.create_connection((host, port), timeout=10)
        fields = [
            "callerid=/silent_subscriber",
            "topic=" + topic,
            "type=" + kind._type,
            "md5sum=" + kind._md5sum,
        ]
        header = b"".join(struct.pack("<I", len(f)) + f.encode() for f in fields)
        self.socket.sendall(struct.pack("<I", len(header)) + header)

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
        self.threads = [
            threading.Thread(target=self._run, args=(random.Random(seed + k),))
            for k in range(count)
        ]

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
