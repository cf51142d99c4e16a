#!/usr/bin/python3
"""What rviz draws of the surface, on a screen in memory: blue water, then white ice."""
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import unittest

import matplotlib.image
import rospy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from iib.ros.node import Node, wait_until

CONFIG = pathlib.Path(__file__).resolve().parents[2] / "config/rviz/ice_ice_baby.rviz"

SIZE = (800, 600)


class Screen:
    """A display in memory with rviz, which shows nothing but the picture."""

    def __init__(self, folder):
        self._picture = folder / "picture.png"
        read, write = os.pipe()
        screen = "%dx%dx24" % SIZE
        self._display = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", screen, "-nolisten", "tcp"],
            pass_fds=[write],
            stderr=subprocess.DEVNULL,
        )
        os.close(write)
        with os.fdopen(read) as number:
            self._env = dict(os.environ, DISPLAY=":" + number.readline().strip())
        self._env.update(LIBGL_ALWAYS_SOFTWARE="1", QT_X11_NO_MITSHM="1", QT_QPA_PLATFORM="xcb")
        self._rviz = subprocess.Popen(
            ["rviz", "--fullscreen", "-d", str(CONFIG)],
            env=self._env,
        )

    def picture(self):
        """Red, green and blue of each pixel, 0 to 1."""
        subprocess.run(
            ["import", "-window", "root", "PNG24:" + str(self._picture)],
            env=self._env,
            check=True,
            timeout=20,
        )
        return matplotlib.image.imread(str(self._picture))[:, :, :3]

    def close(self):
        for process in (self._rviz, self._display):
            process.send_signal(signal.SIGKILL)
            process.wait()


def share(pixels):
    return pixels.mean()


def blue(picture):
    red, green, blue_part = picture[..., 0], picture[..., 1], picture[..., 2]
    return share((blue_part > 0.45) & (blue_part > 1.8 * red) & (blue_part > 1.15 * green))


def white(picture):
    """Ice is brighter than everything in the view but the panel, which is grey."""
    red, blue_part = picture[..., 0], picture[..., 2]
    return share((red > 0.6) & (blue_part > red + 0.01))


class SurfaceInRviz(unittest.TestCase):
    def test_water_is_blue_and_ice_is_white(self):
        rospy.init_node("surface_picture_test")
        node = Node("/ice_ice_baby")
        node.start("block")
        with tempfile.TemporaryDirectory() as folder:
            screen = Screen(pathlib.Path(folder))
            try:
                wait_until(lambda: blue(screen.picture()) > 0.03, "water in the picture", 60)
                self.assertTrue(node.set_temperature(temperature=-10, ramp_s=0, target="").success)
                before = white(screen.picture())
                node.run_frames(1)
                wait_until(
                    lambda: white(screen.picture()) > before + 0.02, "ice in the picture", 30
                )
                self.assertLess(blue(screen.picture()), 0.01)
            finally:
                screen.close()


if __name__ == "__main__":
    import rostest

    rostest.rosrun("ice_ice_baby", "surface_picture", SurfaceInRviz)
