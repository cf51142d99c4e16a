"""What the ROS node costs over run_scene on the same frames, with a subscriber and without."""

import os
import subprocess

from iib.bench.builds import Tree
from iib.bench.series import Series
from iib.common.machine import commit
from iib.common.processes import end, free_port
from iib.common.progress import Progress
from iib.common.refusal import Refusal
from iib.common.run_scene import report_of
from iib.ros import master

SCENE, THREADS = "dam_break", 1
# Spacing in m and frames: 6,400 particles, where 30 clouds a second come, and about 30,000, where a
# cloud is larger and perhaps every frame is sent.
CASES = ((0.05, 600), (0.0299, 120))


def environment(tree, port):
    """What setup.bash of a build makes of the environment, with a master of one's own."""
    command = f"set +u; source {tree.build}/devel/setup.bash >/dev/null && env -0"
    out = subprocess.run(["bash", "-c", command], capture_output=True, text=True, check=True).stdout
    env = dict(line.split("=", 1) for line in out.split("\0") if "=" in line)
    return master.environment(port, env)


class Session:
    """A master and a paused node; both end with `with`."""

    def __init__(self, tree, spacing_m):
        self.tree, self.spacing_m, self.port, self.children = tree, spacing_m, free_port(), []
        self.env = environment(tree, self.port)

    def __enter__(self):
        self.start(*master.command(self.port))
        master.await_answer(self.port)
        self.node = self.start(
            self.tree.program("simulation_node"),
            "__name:=sim",
            f"_scene:={SCENE}",
            "_start_paused:=true",
            f"_threads:={THREADS}",
            "_real_time_factor:=0",
            "_particles_rate_hz:=30",
            f"_overrides/fluid/spacing_m:={self.spacing_m}",
        )
        return self

    def __exit__(self, *_):
        for child in reversed(self.children):
            end(child, patience_s=5.0)

    def start(self, *command):
        child = subprocess.Popen(
            [str(c) for c in command],
            env=self.env,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        self.children.append(child)
        return child

    def processor_s(self):
        """Processor time that the node has used."""
        fields = open(f"/proc/{self.node.pid}/stat").read().rsplit(")", 1)[1].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def run_frames(self, frames, how):
        """Wall time, the node's processor time, and the clouds that came."""
        command = [self.tree.program("time_node"), str(frames), how, "__ns:=/sim"]
        waiting = subprocess.Popen(
            [str(c) for c in command], env=self.env, stdout=subprocess.PIPE, text=True
        )
        out, _ = waiting.communicate(timeout=600)
        if waiting.returncode != 0:
            raise Refusal("the node did not answer")
        wall_s, clouds = out.splitlines()[-1].split()  # roscpp may say something before
        return float(wall_s), self.processor_s(), int(clouds)


def measure(tree, spacing_m, frames):
    overrides = (f"fluid.spacing_m={spacing_m}",)
    bare = report_of(
        tree.program("run_scene"), SCENE, overrides, duration=frames / 60.0, threads=THREADS
    )
    values = {"run_scene": bare["wall_time_s"], "particles": bare["particles"]}
    for how in ("alone", "subscribe"):
        with Session(tree, spacing_m) as session:
            names = (how, how + " processor", how + " clouds")
            values.update(zip(names, session.run_frames(frames, how)))
    return values


def print_costs(folder, runs):
    tree = Tree("ros", folder).copy_working_tree()
    tree.make("run_scene", "simulation_node", "time_node", ros=True)
    names = {case: f"run_scene and the node, spacing {case[0]} m" for case in CASES}
    bar, found = Progress([*names.values()] * runs), {case: Series() for case in CASES}
    for _ in range(runs):
        for case in CASES:
            with bar.run(names[case]):
                found[case].add(measure(tree, *case))
    bar.close()
    print(
        f"{SCENE} as fast as it goes, solver on {THREADS} thread, commit {commit()}, "
        f"medians of {runs} runs in turn"
    )
    for (_, frames), series in found.items():
        print_case(series, frames)
    print("\nTarget: at most 1.10 with a subscriber; nothing that can be measured without.")


def print_case(found, frames):
    base = found.median("run_scene")
    what = f"{found.median('particles'):,.0f} particles, {frames} frames"
    print(
        f"\n{what:<30}"
        f"{'wall s':>9} {'ratio':>7} {'spread':>8} {'processor s':>12} {'clouds':>7}"
    )
    print(f"{'run_scene':<30}{base:>9.3f} {1:>7.3f} {100 * found.spread('run_scene'):>6.1f} %")
    for how, name in (("alone", "node, nobody subscribes"), ("subscribe", "node, a subscriber")):
        wall, processor, clouds = (
            found.median(how + part) for part in ("", " processor", " clouds")
        )
        print(
            f"{name:<30}{wall:>9.3f} {wall / base:>7.3f} {100 * found.spread(how):>6.1f} % "
            f"{processor:>12.3f} {clouds:>7.0f}"
        )
