"""A running simulation node seen from outside: services, latest messages, waiting, memory."""

import sys
import time
import xmlrpc.client

import rosgraph
import rospy
from diagnostic_msgs.msg import DiagnosticArray
from std_srvs.srv import Trigger

try:
    from ice_ice_baby.srv import (
        Attach,
        HeatRegion,
        GetState,
        Load,
        LoadScene,
        Reset,
        Save,
        SetGravity,
        SetHeatRegion,
        SetSource,
        SetTemperature,
        Step,
    )
except ModuleNotFoundError:
    sys.exit("no messages of ice_ice_baby; run scripts/build, then source build/devel/setup.bash")

TYPES = {
    "attach": Attach,
    "get_state": GetState,
    "heat_region": HeatRegion,
    "load": Load,
    "load_scene": LoadScene,
    "reset": Reset,
    "save": Save,
    "set_gravity": SetGravity,
    "set_heat_region": SetHeatRegion,
    "set_source": SetSource,
    "set_temperature": SetTemperature,
    "step": Step,
    "pause": Trigger,
    "resume": Trigger,
}


def wait_until(condition, what, timeout_s=20.0):
    """The first true value of condition(), asked every 20 ms of wall time."""
    deadline = time.monotonic() + timeout_s
    while time.monotonic() < deadline:
        value = condition()
        if value:
            return value
        time.sleep(0.02)
    raise AssertionError("waited in vain for " + what)


class Latest:
    """Keeps every message of a topic while used in `with`, which begins once it is connected to
    who publishes the topic already."""

    def __init__(self, topic, message_type):
        self.messages = []
        self._subscriber = rospy.Subscriber(topic, message_type, self.messages.append)

    def __enter__(self):
        name = self._subscriber.resolved_name
        if name in (topic for topic, _ in rospy.get_published_topics()):
            wait_until(self._subscriber.get_num_connections, "a connection to " + name)
        return self

    def __exit__(self, *_):
        self._subscriber.unregister()

    def wait(self, condition=lambda message: True, what="a message", timeout_s=20.0):
        """The latest message, once it fulfils the condition."""

        def check():
            return self.messages and condition(self.messages[-1]) and self.messages[-1]

        return wait_until(check, what + " on " + self._subscriber.name, timeout_s)


class Node:
    """Services of a simulation node, by their private names: node.step(frames=3)."""

    def __init__(self, name="/sim", timeout_s=30.0):
        self.name = name
        for service, kind in TYPES.items():
            rospy.wait_for_service(name + "/" + service, timeout=timeout_s)
            setattr(self, service, rospy.ServiceProxy(name + "/" + service, kind))

    def state(self):
        return self.get_state().state

    def when(self, condition, what, timeout_s=20.0):
        """The state, once it fulfils the condition."""

        def check():
            state = self.state()
            return state if condition(state) else None

        return wait_until(check, what, timeout_s)

    def start(self, scene="small"):
        """Pauses at the start of a scene."""
        assert self.pause().success
        answer = self.reset(scene=scene, preset="")
        assert answer.success, answer.message
        return self.when(
            lambda s: s.frame == 0 and s.paused and s.scene == scene, "the start of " + scene
        )

    def run_frames(self, count):
        """Steps while paused; returns the state after the last frame."""
        frame = self.state().frame
        assert self.step(frames=count).success
        return self.when(lambda s: s.frame == frame + count, "%d frames" % count, 60.0)

    def hash(self):
        """Of the state in which the paused scene stands."""
        return self.when(lambda s: s.state_hash, "a hash, so a pause").state_hash

    def diagnostic(self, name, condition, timeout_s=10.0):
        """The status of that name, once it fulfils the condition."""

        def find(message):
            full = self.name[1:] + ": " + name
            return [s for s in message.status if s.name == full and condition(s)]

        with Latest("/diagnostics", DiagnosticArray) as diagnostics:
            # Not only the latest message: another node's may always follow close behind.
            def check():
                return next((s for m in diagnostics.messages for s in find(m)), None)

            return wait_until(check, "the diagnostic " + name, timeout_s)


def memory_mb(pid):
    """Resident memory of a process."""
    with open("/proc/%d/status" % pid, encoding="ascii") as status:
        line = next(line for line in status if line.startswith("VmRSS"))
    return int(line.split()[1]) / 1024.0


def process_of(node):
    """Process id of a node on this machine."""
    api = xmlrpc.client.ServerProxy(rosgraph.Master("/process_of").lookupNode(node))
    return api.getPid("/process_of")[2]
