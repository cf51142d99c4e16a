"""The points that no other point beats in both cost and error."""


def front(points):
    """Indices of the Pareto front, cheapest first.

    points: list of (cost, error), None for a point that does not count. A point is on the front if
    every point that costs no more has a larger error. Of equal points the first counts.
    """
    order = sorted(
        (k for k, point in enumerate(points) if point is not None), key=lambda k: (*points[k], k)
    )
    chosen, least = [], float("inf")
    for k in order:
        if points[k][1] < least:
            chosen.append(k)
            least = points[k][1]
    return chosen
