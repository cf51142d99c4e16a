"""Values just inside each range, which run, and just outside, which are refused by name."""

import dataclasses

from iib.stability.runs import Asked

FRAMES_S = 0.05


@dataclasses.dataclass
class Probe:
    """A value at or beyond an end.

    Another rule may forbid what the range allows; it has to name the key too.
    """

    key: str
    value: str
    inside: bool
    outcome: object

    @property
    def verdict(self):
        if self.outcome.status == "refused":
            return "refused"
        return "ran" if self.outcome.survived() else "unstable"

    def names_the_key(self):
        return self.key.split(".")[-1] in self.outcome.message

    def as_expected(self):
        if self.verdict == "refused":
            return self.names_the_key()
        return self.verdict == "ran" and self.inside


# An entry of the lists that the scene has not, so that the key is looked at.
LISTS = {
    "schedule": "schedule=[{at_s: 0.02}]",
    "planes": "planes=[{name: plate, position_m: [0, 0, -5]}]",
    "spheres": "spheres=[{name: ball, position_m: [0, 0, -5]}]",
    "boxes": "boxes=[{name: box, position_m: [0, 0, -5]}]",
    "cylinders": "cylinders=[{name: post, position_m: [100, 100, -100]}]",
    "capsules": "capsules=[{name: pill, position_m: [100, 100, -100]}]",
    "cups": "cups=[{name: cup, position_m: [100, 100, -100]}]",
    "gauges": "gauges=[{name: box, size_m: [0.1, 0.1, 0.1]}]",
    "cameras": "cameras=[{name: eye}]",
    "sources": "sources=[{name: tap, position_m: [0, 0, 5], radius_m: 0.05, speed_m_s: 1}]",
    "heat_regions": "heat_regions=[{name: torch, power_w: 1}]",
    "drains": "drains=[{name: hole, min_m: [-9, -9, -9], max_m: [9, 9, -8]}]",
    "meshes": "meshes=[{name: mesh, file: block.obj, position_m: [0, 0, -5]}]",
    "solids": "solids=[{name: raft, position_m: [0, 0, 5]}]",
}


ALONE = "blocks=[{min_m: [-0.025, -0.025, 0], max_m: [0.025, 0.025, 0.05]}]"

# Room for what is probed, so that no rule but the range can refuse it.
ROOM = {
    "blocks.copies": (
        f"{ALONE[:-2]}, copies_step_m: [0.05, 0.05, 0.05]}}]",
        "containers=[]",
        "bounds.max_m=[100, 100, 100]",
    ),
    "containers.size_m": (ALONE,),
    "sources.position_m": (
        "sources=[{name: tap, radius_m: 0.001, speed_m_s: 1}]",
        "bounds.min_m=[-100, -100, -100]",
        "bounds.max_m=[100, 100, 100]",
    ),
    "spheres.radius_m": ("spheres=[{name: ball, position_m: [0, 0, -100]}]",),
    "boxes.size_m": ("boxes=[{name: box, position_m: [0, 0, -100]}]",),
}


def beyond(end, outwards):
    """The next value outside, of whole numbers and small ones too."""
    return end + outwards * max(abs(end) * 1e-6, 1e-6)


def value_text(found, number):
    text = f"{number:.10g}"
    if found.matrix:
        return f"[[{text}, 0, 0], [0, 0, 0], [0, 0, 0]]"
    if not found.vector:
        return text
    rest = "1" if found.key.endswith("copies") else "0.5" if found.key.endswith("size_m") else "0"
    return f"[{text}, {rest}, {rest}]"


def asked(found, number):
    section, _, name = found.key.rpartition(".")
    path = f"{section}.0.{name}" if section in (*LISTS, "blocks", "containers") else found.key
    sets = ROOM.get(found.key, (LISTS[section],) if section in LISTS else ())
    # Heat is on where its keys are, so that the ends are run and not only read.
    scene = "frost" if section in ("thermal", "ice", "steam", "heat_regions") else "pool"
    return Asked(scene, (*sets, f"{path}={value_text(found, number)}"), duration_s=FRAMES_S)


def probes(ranges):
    """Key, number and whether it is allowed."""
    places = []
    for found in ranges.values():
        for end, outwards in ((found.low, -1), (found.high, 1)):
            places.append((found, end, True))
            places.append((found, beyond(end, outwards), False))
    return places


def measure(ranges, runner, pool, bar):
    def probe(place):
        found, number, inside = place
        outcome = runner.run(asked(found, number))
        bar.end("boundaries", outcome.seconds)
        return Probe(found.key, f"{number:.10g}", inside, outcome)

    return list(pool.map(probe, probes(ranges)))
