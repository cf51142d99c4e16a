"""Which settings a user should take for a particle count or an accuracy, from the tables."""

from iib.error_runtime.naming import AXES, sort_key

# Particles, and mean density errors, for which the report names a setting.
COUNTS = (2_000, 5_000, 10_000, 20_000, 50_000, 100_000)
TARGETS = (0.01, 0.003, 0.001, 0.0003, 0.0001)

# Of the energy that the water has. A small density error alone can hide water that boils.
MAX_ENERGY_RISE = 0.02

COST = "us_per_particle_per_s"


def setting_of(row, keys):
    return tuple(str(row.get(key, "")) for key in keys)


def joined(tables, keys):
    """Settings that every table holds as stable: dicts with the row of each table and, each the
    worst of all tables, cost, error, largest and energy_rise."""
    by_setting = []
    for rows in tables:
        by_setting.append({setting_of(row, keys): row for row in rows if row["status"] == "ok"})
    common = set(by_setting[0]).intersection(*by_setting[1:])
    found = []
    for setting in sorted(common, key=lambda values: [sort_key(value) for value in values]):
        rows = [table[setting] for table in by_setting]
        found.append(
            {
                "keys": dict(zip(keys, setting)),
                "rows": rows,
                "cost": max(row[COST] for row in rows),
                "error": max(row["density_mean"] for row in rows),
                "largest": max(row["density_max"] for row in rows),
                "energy_rise": max(row.get("energy_rise", 0) for row in rows),
            }
        )
    return found


def sound(settings):
    """Those that make no energy out of nothing."""
    return [s for s in settings if s["energy_rise"] <= MAX_ENERGY_RISE]


def for_count(settings, particles):
    """The most accurate setting that simulates so many particles in real time, or None."""
    affordable = [s for s in settings if s["cost"] * particles <= 1e6]
    return min(affordable, key=lambda s: s["error"], default=None)


def for_target(settings, error):
    """The cheapest setting with at most this mean error, or None."""
    accurate = [s for s in settings if s["error"] <= error]
    return min(accurate, key=lambda s: s["cost"], default=None)


def most_particles(setting):
    """How many particles the setting simulates in real time, in two digits."""
    return float(f"{1e6 / setting['cost']:.2g}")


def against_peers(rows, peers):
    """Per peer's point: the cheapest of our stable points that is no worse in the mean and, where
    it was measured, the largest error; and how many times cheaper it is. None where no point is as
    accurate.
    """
    compared = []
    for peer in peers:
        largest = peer["max_error_percent"] or float("inf")
        as_good = [
            row
            for row in rows
            if row["status"] == "ok"
            and 100 * row["density_mean"] <= peer["mean_error_percent"]
            and 100 * row["density_max"] <= largest
        ]
        best = min(as_good, key=lambda row: row[COST], default=None)
        ratio = peer["us_per_particle_per_s"] / best[COST] if best else None
        compared.append((peer, best, ratio))
    return compared


def overrides(keys):
    """The setting as words for the command line of run_scene."""
    return " ".join(
        f"--{key} {value}" if key in ("threads", "precision", "preset") else f"--set {key}={value}"
        for key, value in keys.items()
        if key in AXES and value != ""
    )
