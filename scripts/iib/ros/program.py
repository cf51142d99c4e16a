"""Where the programs of the package are."""

import roslib.packages

from iib.common.refusal import Refusal


def find_program(name):
    """As roslaunch finds it; rosrun overlooks a build in the folder `build`."""
    found = roslib.packages.find_node("ice_ice_baby", name)
    if not found:
        raise Refusal(f"no {name} found; run scripts/build, then source build/devel/setup.bash")
    return found[0]
