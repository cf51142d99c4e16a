"""The working tree against a commit, in turn, in one run."""

import sys

from iib.bench.builds import Tree, git
from iib.bench.series import Series, differ, microbench, text
from iib.common.machine import commit as commit_name
from iib.common.progress import Progress
from iib.common.run_scene import report_of


def scene_values(program, threads):
    """What run_scene tells of itself, which every commit can."""
    report = report_of(program, "dam_break", duration=0.25, threads=threads)
    name = f"run_scene/dam_break/threads:{threads}"
    return {name: report["wall_time_s"] / report["frames"]}


def measure(tree, pattern):
    values = {}
    if tree.program("microbench"):
        values.update(microbench(tree.program("microbench"), pattern))
    for threads in (1, 2):
        values.update(scene_values(tree.program("run_scene"), threads))
    return values


def rows(tree, base, shown):
    """Lines of a table: name, both medians, their ratio, and a word where they differ."""
    lines = []
    for name in tree:
        if name not in base or not shown(name):
            continue
        ratio = tree.median(name) / base.median(name) if base.median(name) else 1.0
        spread = max(tree.spread(name), base.spread(name))
        word = ("less" if ratio < 1 else "MORE") if differ(tree[name], base[name]) else ""
        lines.append(
            f"{name:<62} {text(name, base.median(name)):>9} {text(name, tree.median(name)):>9} "
            f"{ratio:>6.3f} {100 * spread:>5.1f} % {word}"
        )
    return lines


def compare(folder, commit, pattern, runs, stages):
    commit = git("rev-parse", "--short=10", commit)
    tree, base = Tree("tree", folder).copy_working_tree(), Tree("base", folder).check_out(commit)
    trees = {side.name: side.make("microbench", "run_scene") for side in (tree, base)}
    found = {name: Series() for name in trees}
    bar = Progress(["tree", "base"] * runs)
    for k in range(runs):
        for name in ("base", "tree") if k % 2 else ("tree", "base"):
            with bar.run(name):
                found[name].add(measure(trees[name], pattern))
    bar.close()
    print(f"base: {commit}, tree: {commit_name()}; medians of {runs} runs in turn\n")
    print(f"{'':<62} {'base':>9} {'tree':>9} {'ratio':>6} spread")
    hidden = (" per_p", " wall") if stages else (" per_p", " wall", " stage_")
    lines = rows(
        found["tree"], found["base"], lambda name: not any(part in name for part in hidden)
    )
    print("\n".join(lines))
    left_out = sorted(set(found["tree"]) ^ set(found["base"]))
    if left_out:
        print(f"\nonly on one side, so not compared: {len(left_out)}", file=sys.stderr)
    print("\nless, MORE: every run of one is beyond every run of the other.")
