"""What the robot sees of the water and feels of its weight."""
import math

import rospy
from geometry_msgs.msg import WrenchStamped
from ice_ice_baby.msg import Vessels

GRAVITY_M_S2, G_PER_KG = 9.81, 1000.0


class Senses:
    """Volumes and weights of the water in vessels, by name."""

    def __init__(self, simulation, names):
        self.vessels, self.weight_g = {}, dict.fromkeys(names, 0.0)
        rospy.Subscriber(simulation + "vessels", Vessels, self._see, tcp_nodelay=True)
        for name in names:
            rospy.Subscriber(simulation + "wrenches/" + name, WrenchStamped, self._feel, name)

    def _see(self, message):
        self.vessels = {vessel.name: vessel for vessel in message.vessels}

    def _feel(self, message, name):
        f = message.wrench.force
        newest_g = math.sqrt(f.x * f.x + f.y * f.y + f.z * f.z) / GRAVITY_M_S2 * G_PER_KG
        self.weight_g[name] += 0.1 * (newest_g - self.weight_g[name])  # mean over ten messages

    def ml(self, name):
        """Water and ice in a vessel, as liquid water."""
        return 1e6 * (self.vessels[name].water_m3 + 0.917 * self.vessels[name].ice_m3)

    def particles(self):
        """In all vessels together."""
        return sum(vessel.particles for vessel in self.vessels.values())
