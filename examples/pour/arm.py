"""The arm of arm.urdf: joint positions that place the lip of its cup, and trajectories to them."""

import math

import rospy
from trajectory_msgs.msg import JointTrajectory, JointTrajectoryPoint

JOINTS = ["turn", "shoulder", "elbow", "wrist"]
SHOULDER_M = 0.25  # above the base
UPPER_ARM_M, FOREARM_M = 0.3, 0.26
LIP_M = (0.15, 0.064)  # from the wrist to the inner edge of the rim, forward and up


class Arm:
    """Commands a joint_trajectory_controller."""

    def __init__(self, topic):
        self.turn = 0.0  # about the axis of the base, rad
        self.command = rospy.Publisher(topic, JointTrajectory, queue_size=10, tcp_nodelay=True)

    def listens(self):
        return self.command.get_num_connections() > 0

    def move(self, lip_m, tilt, seconds, tilt_rad_s=0.0):
        """Sends the arm there and waits until it should have arrived, with this speed."""
        here, after = (joints_of(self.turn, lip_m, t) for t in (tilt, tilt + 0.01 * tilt_rad_s))
        point = JointTrajectoryPoint(positions=here, time_from_start=rospy.Duration(seconds))
        point.velocities = [(b - a) / 0.01 for a, b in zip(here, after)]
        self.command.publish(JointTrajectory(joint_names=JOINTS, points=[point]))
        rospy.sleep(seconds)


def joints_of(turn, lip_m, tilt):
    """Radians for the lip at (distance from the axis of the base, height above it) of lip_m.

    tilt: 0 holds the cup upright, pi/2 pours it out away from the base. Raises ValueError if the
    arm cannot reach.
    """
    c, s = math.cos(tilt), math.sin(tilt)
    forward = lip_m[0] - c * LIP_M[0] - s * LIP_M[1]
    up = lip_m[1] + s * LIP_M[0] - c * LIP_M[1] - SHOULDER_M
    reach_m = math.hypot(forward, up)
    if not UPPER_ARM_M - FOREARM_M < reach_m < UPPER_ARM_M + FOREARM_M:
        raise ValueError(
            "the wrist would be %.3f m from the shoulder; the arm reaches %.2f to %.2f m"
            % (reach_m, UPPER_ARM_M - FOREARM_M, UPPER_ARM_M + FOREARM_M)
        )
    line = math.atan2(up, forward)
    upper = line + corner(UPPER_ARM_M, reach_m, FOREARM_M)
    fore = line - corner(FOREARM_M, reach_m, UPPER_ARM_M)
    return [turn, -upper, upper - fore, fore + tilt]


def corner(a, b, opposite):
    """Angle between the sides a and b of a triangle."""
    return math.acos((a * a + b * b - opposite * opposite) / (2 * a * b))
