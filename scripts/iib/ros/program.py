"""Where the program simulation_node is."""

import roslib.packages

from iib.common.refusal import Refusal


def find_simulation_node():
    """As roslaunch finds it; rosrun overlooks a build in the folder `build`."""
    found = roslib.packages.find_node("ice_ice_baby", "simulation_node")
    if not found:
        raise Refusal(
            "no simulation_node found; run scripts/build, then source build/devel/setup.bash"
        )
    return found[0]
