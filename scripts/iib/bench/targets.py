"""The ratios that have a target, each from values of one run; medians of several runs."""

import concurrent.futures
import os

from iib.bench.builds import Tree
from iib.bench.series import Series, microbench
from iib.common.machine import commit
from iib.common.progress import Progress

ITERATION = ("lambda", "delta_p", "collide", "position")
POOL, DAM, BOUND = "scene/still_pool", "scene/dam_break", "bound/iteration"


def at(name, n, threads):
    return f"{name}/n:{n}/threads:{threads}"


def two_at_once(program, pattern):
    """Mean time of two processes of one thread each that run at the same time, per benchmark."""
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        one, other = pool.map(lambda _: microbench(program, pattern), range(2))
    return {
        f"{name} beside another": (one[name] + other[name]) / 2
        for name in one
        if name.endswith(" wall")
    }


def measure(program):
    """One round of everything that the ratios need."""
    values = {}
    values.update(microbench(program, r"bound/iteration(_skinned)?/n:30000/|scene/.*/n:30000/"))
    values.update(two_at_once(program, f"{POOL}/n:30000/threads:1|{BOUND}/n:30000/threads:1"))
    values.update(
        microbench(program, f"({POOL}|{BOUND}|neighbours/build)/n:(30000|1000000)/threads:1")
    )
    return values


def iteration(found, name, without=()):
    per_substep = sum(
        found.median(f"{name} stage_{stage}")
        for stage in ITERATION
        if stage not in without and f"{name} stage_{stage}" in found
    )
    return per_substep / found.median(f"{name} iterations_per_substep")


def print_targets(folder, runs):
    program = Tree("tree", folder).copy_working_tree().make("microbench").program("microbench")
    found, bar = Series(), Progress(["all ratios"] * runs)
    for _ in range(runs):
        with bar.run("all ratios"):
            found.add(measure(program))
    bar.close()
    print(f"commit {commit()}, {os.cpu_count()} processors, medians of {runs} runs\n")
    for line in bound_lines(found) + thread_lines(found) + size_lines(found) + memory_lines(found):
        print(line)


def ratio_line(what, value, target=""):
    return f"{what:<66} {value:>7.2f} {target}"


def bound_lines(found):
    bare = found.median(at(BOUND, 30000, 1) + " per_particle")
    skinned = found.median(at("bound/iteration_skinned", 30000, 1) + " per_particle")
    lines = [
        f"{'bound, ns per particle and iteration':<66} {1e9 * bare:>7.1f}",
        f"{'the same with lists that reach 0.3 spacings further':<66} {1e9 * skinned:>7.1f}",
    ]
    for name, without in (
        (at("scene/floating", 30000, 1), ()),
        (at(POOL, 30000, 1), ("collide",)),
        (at(POOL, 30000, 1), ()),
        (at(DAM, 30000, 1), ()),
    ):
        cost = iteration(found, name, without)
        what = f"iteration of {name.split('/')[1]}{' less collide' if without else ''}"
        lines.append(ratio_line(f"{what} ({1e9 * cost:.1f} ns) / bound", cost / bare, "target 1.5"))
    return lines


def thread_lines(found):
    lines = []
    for name in (POOL, DAM, "scene/floating", BOUND):
        one, two = (found.median(at(name, 30000, threads) + " wall") for threads in (1, 2))
        target = "target 1.8" if name.startswith("scene") else ""
        lines.append(ratio_line(f"{name}: two threads / one, speed", one / two, target))
    for name in (POOL, BOUND):
        alone = found.median(at(name, 30000, 1) + " wall")
        beside = found.median(at(name, 30000, 1) + " wall beside another")
        lines.append(
            ratio_line(
                f"{name}: two processes of one thread / one, speed",
                2 * alone / beside,
                "what the machine allows",
            )
        )
    return lines


def size_lines(found):
    lines = []
    for name, per in (
        (POOL, "per_particle_substep"),
        (BOUND, "per_particle"),
        ("neighbours/build", "per_particle"),
    ):
        small, large = (found.median(f"{at(name, n, 1)} {per}") for n in (30000, 1000000))
        target = "target 1.3" if name == POOL else ""
        lines.append(
            ratio_line(f"{name}: a particle among 1,000,000 / among 30,000", large / small, target)
        )
    return lines


def memory_lines(found):
    bytes_each = found.median(at(DAM, 30000, 1) + " bytes_per_particle")
    return [f"{'bytes per particle, neighbours and all':<66} {bytes_each:>7.0f} target 400"]
