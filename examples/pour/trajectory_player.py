#!/usr/bin/python3
"""The arm: moves its joints along the latest trajectory on ~command and sends /joint_states.

Like the joint_trajectory_controller of ros_control, it starts from where the joints are, and
between two points their positions are cubic polynomials of time. The parameter ~start has the
joints with their first positions.
"""
import rospy
from sensor_msgs.msg import JointState
from trajectory_msgs.msg import JointTrajectory


def cubic(begin, end, duration_s, t):
    """Position and velocity at t between two (position, velocity)."""
    s = t / duration_s
    (p, v), (q, w) = begin, end
    v, w = v * duration_s, w * duration_s
    a, b = 2 * (p - q) + v + w, 3 * (q - p) - 2 * v - w
    return p + s * (v + s * (b + s * a)), (v + s * (2 * b + s * 3 * a)) / duration_s


class Arm:
    def __init__(self, start):
        self.names = list(start)
        self.path = [(rospy.Time.now(), [(position, 0.0) for position in start.values()])]
        self.sent = None
        self.joints = rospy.Publisher("joint_states", JointState, queue_size=10, tcp_nodelay=True)
        rospy.Subscriber("~command", JointTrajectory, self.take, tcp_nodelay=True)

    def take(self, trajectory):
        """Replaces what is left of the trajectory before."""
        now = rospy.Time.now()
        order = [trajectory.joint_names.index(name) for name in self.names]
        path = [(now, self.at(now))]
        for point in trajectory.points:
            speeds = point.velocities or [0.0] * len(order)
            states = [(point.positions[k], speeds[k]) for k in order]
            path.append((now + point.time_from_start, states))
        self.path = path

    def at(self, now):
        """(position, velocity) of each joint."""
        path = self.path
        for (begin, before), (end, after) in zip(path, path[1:]):
            if now < end:
                span = ((end - begin).to_sec(), max(0.0, (now - begin).to_sec()))
                return [cubic(b, a, *span) for b, a in zip(before, after)]
        return [(position, 0.0) for position, _ in path[-1][1]]

    def send(self):
        now = rospy.Time.now()
        if now == self.sent:
            return
        self.sent = now
        message = JointState(name=self.names)
        message.header.stamp = now
        message.position, message.velocity = zip(*self.at(now))
        self.joints.publish(message)


def main():
    rospy.init_node("arm")
    arm, rate = Arm(rospy.get_param("~start")), rospy.Rate(100)
    while not rospy.is_shutdown():
        arm.send()
        rate.sleep()


if __name__ == "__main__":
    try:
        main()
    except rospy.ROSException:  # Ctrl-C
        pass
