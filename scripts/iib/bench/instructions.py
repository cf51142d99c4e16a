"""Instructions of the frames of a scene, counted by callgrind: the same on a busy machine."""

import re
import shutil
import subprocess
import tempfile

from iib.bench.builds import Tree, git
from iib.common.paths import ROOT
from iib.common.processes import run
from iib.common.refusal import Refusal
from iib.common.run_scene import words

SCENES = ("dam_break", "container_splash")
FRAMES = 3  # each scene has 60 a second


def count(tree, scene, overrides=(), frames=FRAMES):
    """Instructions that `frames` frames of a scene cost on one thread, set-up left out."""
    if not shutil.which("valgrind"):
        raise Refusal("valgrind is missing; scripts/install_dependencies bench")
    with tempfile.NamedTemporaryFile() as profile:
        out = run(
            ["valgrind", "--tool=callgrind", f"--callgrind-out-file={profile.name}"]
            + ["--toggle-collect=ice_ice_baby::Simulator<float>::advanceFrame()"]
            + [tree.program("run_scene")]
            + words(scene, overrides, duration=frames / 60.0, threads=1),
            stderr=subprocess.STDOUT,  # on which callgrind writes its count
        )
    return int(re.search(r"Collected : (\d+)", out).group(1))


def compare_counts(folder, commit):
    """The working tree against a commit."""
    commit = git("rev-parse", "--short=10", commit)
    base = Tree("base", folder).check_out(commit).make("run_scene")
    tree = Tree("tree", folder).copy_working_tree().make("run_scene")
    _print(f"base {commit}", base, "tree", tree)


def without_ice(folder):
    """The working tree against a copy without springs, temperature, heat and bodies."""
    tree = Tree("tree", folder).copy_working_tree().make("run_scene")
    bare = leave_out_ice(Tree("without_ice", folder).copy_working_tree()).make("run_scene")
    _print("without ice", bare, "tree", tree)
    print("\nWater only: no spring is made, no temperature changes. Target: at most 1.02.")


def _print(name_a, a, name_b, b):
    print(
        f"{'instructions of ' + str(FRAMES) + ' frames':<28} {name_a:>16} {name_b:>16} {'ratio':>8}"
    )
    for scene in SCENES:
        n_a, n_b = count(a, scene), count(b, scene)
        print(f"{scene:<28} {n_a:>16,} {n_b:>16,} {n_b / n_a:>8.4f}")


def leave_out_ice(tree):
    """Takes springs, temperature, heat and bodies of ice out of a copy of the source."""
    own = ROOT / "bench" / "without_ice" / "absent.h"
    core = tree.source / "src" / "core"
    shutil.copy2(own, core / "simulation" / "absent.h")
    simulator = core / "simulation" / "simulator.h"
    phase_change = core / "simulation" / "phase_change.h"
    _edit(simulator, r"std::optional<((Springs|PhaseChange)<Real>)>", r"Absent<\1>", 2)
    _edit(phase_change, r"std::optional<(Springs<Real>)>", r"Absent<\1>", 2)
    _edit(simulator, r"\bTemperature temperature_;", "NoTemperature temperature_;")
    _edit(simulator, r"\bdouble strictness_ = 0\.0;", "Zero strictness_;")
    _edit(
        phase_change,
        r'#include "thermal/thermal_solver.h"',
        '#include "simulation/absent.h"\n\\g<0>',
    )
    ice = r"ice/(springs|temperature|ice_\w+|contact_\w+)"
    left_out = (
        rf"\n +({ice}|phase/(phases|steam)|simulation/phase_change|checkpoint/restored_ice)\.cpp"
    )
    _edit(core / "CMakeLists.txt", left_out, "", 14)
    return tree


def _edit(path, pattern, replacement, times=1):
    source, found = re.subn(pattern, replacement, path.read_text())
    if found != times:
        raise Refusal(
            f"{path.name} has no {pattern} any more: iib/bench/instructions.py has to follow it"
        )
    path.write_text(source)
