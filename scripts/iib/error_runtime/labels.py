"""Puts labels beside points so that none covers another."""

import math

from matplotlib import patheffects

# Directions in the order of preference: right above first, then around.
DIRECTIONS = [45, 135, -45, -135, 90, -90, 0, 180]
DISTANCES_PX = [7, 14, 24, 38, 55]


def overlap(a, b):
    width = min(a[2], b[2]) - max(a[0], b[0])
    height = min(a[3], b[3]) - max(a[1], b[1])
    return width * height if width > 0 and height > 0 else 0.0


def boxes_around(x, y, width, height):
    """Candidate places of a text of this size, as (x0, y0, x1, y1), all in pixels."""
    for distance in DISTANCES_PX:
        for degrees in DIRECTIONS:
            dx, dy = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
            centre_x = x + dx * (distance + width / 2)
            centre_y = y + dy * (distance + height / 2)
            yield (
                centre_x - width / 2,
                centre_y - height / 2,
                centre_x + width / 2,
                centre_y + height / 2,
            )


def place(points, sizes, frame, half_marker=4.0):
    """A box for each label. points: (x, y); sizes: (width, height); frame: box that holds them all.

    Earlier points choose first. Where nothing is free the place that covers least is taken.
    """
    taken = [
        (x - half_marker, y - half_marker, x + half_marker, y + half_marker) for x, y in points
    ]
    placed = []
    for (x, y), (width, height) in zip(points, sizes):
        best, least = None, math.inf
        for box in boxes_around(x, y, width, height):
            outside = (box[2] - box[0]) * (box[3] - box[1]) - overlap(box, frame)
            covered = 10 * outside + sum(overlap(box, other) for other in taken)
            if covered < least:
                best, least = box, covered
            if covered == 0:
                break
        taken.append(best)
        placed.append(best)
    return placed


def annotate(axes, labels):
    """Writes labels: list of (x, y, text, style) in data coordinates; a line leads to a far one."""
    figure = axes.figure
    figure.canvas.draw()
    texts, points, sizes = [], [], []
    for x, y, text, style in labels:
        artist = axes.text(x, y, text, ha="center", va="center", zorder=6, **style)
        artist.set_path_effects([patheffects.withStroke(linewidth=2.2, foreground="white")])
        extent = artist.get_window_extent()
        texts.append(artist)
        points.append(tuple(axes.transData.transform((x, y))))
        sizes.append((extent.width + 2, extent.height))
    window = axes.get_window_extent()
    boxes = place(points, sizes, (window.x0, window.y0, window.x1, window.y1))
    back = axes.transData.inverted()
    for artist, (x, y), box in zip(texts, points, boxes):
        centre = ((box[0] + box[2]) / 2, (box[1] + box[3]) / 2)
        artist.set_position(back.transform(centre))
        nearest = (min(max(x, box[0]), box[2]), min(max(y, box[1]), box[3]))
        if math.dist((x, y), nearest) > 14:
            ends = [back.transform((x, y)), back.transform(nearest)]
            axes.plot(*zip(*ends), color="0.6", lw=0.6, zorder=2)
