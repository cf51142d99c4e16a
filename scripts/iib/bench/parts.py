"""What each optional part costs a scene that has it, and that one without it does not pay."""

from iib.bench.builds import Tree
from iib.bench.instructions import FRAMES, count
from iib.common import markdown
from iib.common.machine import commit
from iib.common.progress import Progress
from iib.common.run_scene import report_of

# The water of dam_break at rest and without gravity, so that every part meets the same water.
SCENE = ("gravity_m_s2=[0, 0, 0]",)
BARE = (*SCENE, "containers=[]", "solver.viscosity_1_s=0")
TANK = (*SCENE, "fluid.boundary_density=false", "solver.viscosity_1_s=0")
WALLS = (*SCENE, "solver.viscosity_1_s=0")
ICE = ("springs.sleep_speed_m_s=0",)

HEATED = (*SCENE, "containers=[]", "thermal.enabled=true", "thermal.air_heat_transfer_w_m2k=0")
BLOCK = "blocks=[{{min_m: [-0.4, -0.4, 0], max_m: [0.4, 0.4, 0.8], celsius: {}}}]"

COLUMNS = (
    "part",
    "instructions when on",
    "bytes when on",
    "stages",
    "calls and bytes when absent",
)

# Name, scene without it, scene with it, stages that it brings.
PARTS = (
    ("viscosity", BARE, (*SCENE, "containers=[]"), ("viscosity",)),
    ("colliders: a tank", BARE, TANK, ("collide",)),
    ("density of walls", TANK, WALLS, ()),
    (
        "springs, freezing",
        BARE,
        (*BARE, "temperature.initial_c=2"),
        ("make_springs", "correct_springs"),
    ),
    (
        "springs, frozen",
        BARE,
        (*BARE, *ICE, "temperature.initial_c=-10"),
        ("make_springs", "correct_springs"),
    ),
    ("heat of water", (*SCENE, "containers=[]"), HEATED, ("heat", "phases")),
    (
        "rigid ice, one body",
        (*HEATED, BLOCK.format(5)),
        (*HEATED, BLOCK.format(-5)),
        ("ice_contacts", "ice_bodies"),
    ),
    ("steam", (*HEATED, BLOCK.format(5)), (*HEATED, BLOCK.format(200)), ()),
)


class Cost:
    """Instructions and bytes per particle of a scene, and its stages."""

    def __init__(self, tree, overrides):
        report = report_of(
            tree.program("run_scene"), "dam_break", overrides, duration=FRAMES / 60.0, threads=1
        )
        substeps = report["steps"]
        self.instructions = count(tree, "dam_break", overrides) / report["particles"] / substeps
        self.stages = {stage["name"]: stage for stage in report["stages"]}
        self.bytes = sum(stage["bytes"] for stage in report["stages"]) / report["particles"]


def print_parts(folder):
    tree = Tree("tree", folder).copy_working_tree().make("run_scene")
    known, bar = {}, Progress(["callgrind"] * len({o for part in PARTS for o in part[1:3]}))

    def cost(overrides):
        if overrides not in known:
            with bar.run("callgrind"):
                known[overrides] = Cost(tree, overrides)
        return known[overrides]

    rows = [row(*part, cost) for part in PARTS]
    bare = cost(BARE)
    bar.close()
    first = [
        "water alone",
        f"{bare.instructions:.0f}",
        f"{bare.bytes:.0f}",
        ", ".join(bare.stages),
        "",
    ]
    print(f"Instructions per particle and substep, bytes per particle; commit {commit()}.\n")
    print(markdown.table(COLUMNS, [first, *rows], left=[COLUMNS[0], *COLUMNS[3:]]))


def row(name, without, with_it, stages, cost):
    off, on = cost(without), cost(with_it)
    left = [stage for stage in stages if stage in off.stages]
    absent = (
        f"still there: {', '.join(left)}"
        if left
        else "0, 0: no such stage"
        if stages
        else "no such array"
    )
    instructions, size = on.instructions - off.instructions, on.bytes - off.bytes
    return [
        name,
        f"{instructions:+.0f}",
        f"{size:+.0f}",
        ", ".join(stages) or "within lambda",
        absent,
    ]
