"""What settings and metrics are called in pictures and tables."""

# key: text with the value in it
AXES = {
    "solver.substeps": "{} substeps",
    "solver.iterations": "{} iterations",
    "solver.relaxation": "relaxation {}",
    "solver.warm_start": "warm start {}",
    "solver.viscosity_1_s": "viscosity {}/s",
    "solver.quality": "quality {}",
    "fluid.spacing_m": "spacing {} m",
    "preset": "preset {}",
    "precision": "{}",
    "threads": "{} threads",
}

# metric: (what it is, unit as drawn, factor to that unit)
METRICS = {
    "density_mean": ("mean density error", "%", 100),
    "density_max": ("maximum density error", "%", 100),
    "own_density_mean": ("mean density error, own kernel", "%", 100),
    "own_density_max": ("maximum density error, own kernel", "%", 100),
    "volume_lost": ("volume lost to compression", "%", 100),
    "energy_drift": ("energy at the end against the start", "%", 100),
    "energy_rise": ("energy gained without work", "%", 100),
    "column_height_lost": ("error of the column height", "%", 100),
    "front_error": ("dam front, against Martin & Moyce", "%", 100),
    "ice_drift_spacings": ("ice, distance from rigid motion", "spacings", 1),
    "ice_residual_speed_m_s": ("ice, residual speed", "mm/s", 1000),
    "within_a_spacing_s": ("time within a spacing of the reference", "s", 1),
    "rms_speed_m_s": ("rms speed at the end", "m/s", 1),
    "residual_speed_m_s": ("rms speed of the last half second", "m/s", 1),
}


def words(key, value):
    text = AXES.get(key, key.split(".")[-1] + " {}").format(value)
    return text[:-1] if str(value) == "1" and key in AXES and text.endswith("s") else text


def metric(name):
    """(what it is, unit, factor) of any metric."""
    if name in METRICS:
        return METRICS[name]
    if name.startswith("apart_spacings_at_"):
        return ("distance to the reference at " + name[18:].replace("_", " "), "spacings", 1)
    return (name, "", 1)


def varying(rows, axes):
    return [key for key in axes if len({str(row.get(key, "")) for row in rows}) > 1]


def sort_key(value):
    """Numbers by size, before words."""
    try:
        return (0, float(value), "")
    except (TypeError, ValueError):
        return (1, 0.0, str(value))


def main_axis(rows, axes):
    """The axis along which points are joined by lines: substeps, else the one with most values."""
    keys = varying(rows, axes)
    if not keys or "solver.substeps" in keys:
        return "solver.substeps" if keys else None
    return max(keys, key=lambda key: len({str(row.get(key)) for row in rows}))


def setting(row, keys):
    """The point in words: "4 substeps, 1 iteration"."""
    return ", ".join(words(key, row[key]) for key in keys) or "as the scene has it"
