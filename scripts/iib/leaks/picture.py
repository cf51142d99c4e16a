"""Picture of what scripts/leaks measured. Needs matplotlib."""

import math

CLEAN, LEAKING, EMPTY = "#2b6cb0", "#b3001b", "#e6e8eb"


def colour(tally, most):
    """Blue, the darker the more particle-seconds; red if anything leaked."""
    from matplotlib.colors import to_rgb

    base = to_rgb(LEAKING if tally.failed() else CLEAN)
    share = math.log10(1 + tally.particle_seconds) / math.log10(1 + most)
    weight = 1.0 if tally.failed() else max(0.1, share**3)
    return tuple(1 - weight * (1 - part) for part in base)


def short(number):
    for factor, letter in ((1e6, "M"), (1e3, "k")):
        if number >= factor:
            return f"{number / factor:.3g} {letter}"
    return f"{number:.0f}"


def write(path, vessels, motions, total, pairs):
    from iib.common.plotting import pyplot

    most = max(tally.particle_seconds for tally in pairs.values())
    size = (1.6 + 1.15 * len(motions), 1.4 + 0.55 * len(vessels))
    figure, place = pyplot.subplots(figsize=size, constrained_layout=True)
    for y, vessel in enumerate(vessels):
        for x, motion in enumerate(motions):
            tally = pairs.get((vessel, motion))
            face = colour(tally, most) if tally else EMPTY
            place.add_patch(pyplot.Rectangle((x - 0.48, y - 0.46), 0.96, 0.92, facecolor=face))
            if not tally:
                continue
            text = f"{short(tally.particle_seconds)}\n{tally.through_wall:,} leaked"
            if tally.particle_seconds == 0:
                text = "no water left"
            dark = sum(face) < 1.7
            place.text(x, y, text, ha="center", va="center", color="white" if dark else "black")
    place.set_xlim(-0.5, len(motions) - 0.5)
    place.set_ylim(len(vessels) - 0.5, -0.5)
    place.set_xticks(range(len(motions)), motions)
    place.set_yticks(range(len(vessels)), vessels)
    place.tick_params(length=0)
    for side in place.spines.values():
        side.set_visible(False)
    place.set_title(
        f"Particle-seconds and particles through a wall: {short(total.particle_seconds)}, "
        f"{total.through_wall:,}",
        loc="left",
    )
    figure.savefig(path, dpi=110)
    pyplot.close(figure)
