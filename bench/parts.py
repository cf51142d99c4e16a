"""What each optional part costs a scene that has it, and that one without it does not pay."""

from builds import Tree, commit_name
from instructions import FRAMES, count
from series import Progress, run_scene

# The water of dam_break at rest and without gravity, so that every part meets the same water.
SCENE = ("gravity_m_s2=[0, 0, 0]",)
BARE = (*SCENE, "containers=[]", "solver.viscosity_1_s=0")
TANK = (*SCENE, "fluid.boundary_density=false", "solver.viscosity_1_s=0")
WALLS = (*SCENE, "solver.viscosity_1_s=0")
ICE = ("springs.sleep_speed_m_s=0",)

HEATED = (*SCENE, "containers=[]", "thermal.enabled=true", "thermal.air_heat_transfer_w_m2k=0")
BLOCK = "blocks=[{{min_m: [-0.4, -0.4, 0], max_m: [0.4, 0.4, 0.8], celsius: {}}}]"

# Name, scene without it, scene with it, stages that it brings.
PARTS = (
    ("viscosity", BARE, (*SCENE, "containers=[]"), ("viscosity",)),
    ("colliders: a tank", BARE, TANK, ("collide",)),
    ("density of walls", TANK, WALLS, ()),
    ("springs, freezing", BARE, (*BARE, "temperature.initial_c=2"), ("make_springs", "correct_springs")),
    ("springs, frozen", BARE, (*BARE, *ICE, "temperature.initial_c=-10"), ("make_springs", "correct_springs")),
    ("heat of water", (*SCENE, "containers=[]"), HEATED, ("heat", "phases")),
    ("rigid ice, one body", (*HEATED, BLOCK.format(5)), (*HEATED, BLOCK.format(-5)), ("ice_contacts", "ice_bodies")),
    ("steam", (*HEATED, BLOCK.format(5)), (*HEATED, BLOCK.format(200)), ()),
)


class Cost:
    """Instructions and bytes per particle of a scene, and its stages."""

    def __init__(self, tree, overrides):
        report = run_scene(tree.program("run_scene"), "dam_break", FRAMES / 60.0, 1, overrides)
        substeps = report["steps"]
        self.instructions = count(tree, "dam_break", overrides) / report["particles"] / substeps
        self.stages = {stage["name"]: stage for stage in report["stages"]}
        self.bytes = sum(stage["bytes"] for stage in report["stages"]) / report["particles"]


def print_parts(folder):
    tree = Tree("tree", folder).copy_working_tree().make("run_scene")
    known, progress = {}, Progress(len({o for part in PARTS for o in part[1:3]}))

    def cost(overrides):
        if overrides not in known:
            progress.step("callgrind")
            known[overrides] = Cost(tree, overrides)
        return known[overrides]

    rows = [row(*part, cost) for part in PARTS]
    bare = cost(BARE)
    progress.end()
    print(f"Instructions per particle and substep, bytes per particle; commit {commit_name()}.\n")
    print("| part | instructions when on | bytes when on | stages | calls and bytes when absent |")
    print("|---|---:|---:|---|---|")
    print(f"| water alone | {bare.instructions:.0f} | {bare.bytes:.0f} | {', '.join(bare.stages)} | |")
    print("\n".join(rows))


def row(name, without, with_it, stages, cost):
    off, on = cost(without), cost(with_it)
    left = [stage for stage in stages if stage in off.stages]
    absent = f"still there: {', '.join(left)}" if left else "0, 0: no such stage" if stages else "no such array"
    return (f"| {name} | {on.instructions - off.instructions:+.0f} | {on.bytes - off.bytes:+.0f} "
            f"| {', '.join(stages) or 'within lambda'} | {absent} |")
