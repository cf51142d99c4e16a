"""The grid of settings: axes with their values, expanded into points."""

import itertools

from iib.common.refusal import Refusal

# Options of error_vs_runtime that stand for a key of a scene, or for an option of run_scene.
SHORTHANDS = {
    "substeps": "solver.substeps",
    "iterations": "solver.iterations",
    "relaxation": "solver.relaxation",
    "warm_start": "solver.warm_start",
    "viscosity": "solver.viscosity_1_s",
    "spacing": "fluid.spacing_m",
    "quality": "solver.quality",
    "preset": "preset",
    "precision": "precision",
    "threads": "threads",
}

# Axes that are options of run_scene; every other axis is a key that --set takes.
PROGRAM_OPTIONS = ("precision", "threads")


def split_values(text):
    """Splits at commas that no bracket holds: "1,[0, 0, -9.81]" are two values."""
    values, depth, word = [], 0, ""
    for letter in text:
        depth += {"[": 1, "{": 1, "]": -1, "}": -1}.get(letter, 0)
        if letter == "," and depth == 0:
            values.append(word)
            word = ""
        else:
            word += letter
    return [value.strip() for value in values + [word]]


def canonical(value):
    """One spelling per number, so that 0.50 and .5 are the same point."""
    try:
        number = float(value)
    except ValueError:
        return value
    return str(int(number)) if number == int(number) and abs(number) < 1e15 else repr(number)


def parse_axis(key, text):
    """The values of one axis, each once, in the order given."""
    values = [canonical(value) for value in split_values(text)]
    if "" in values:
        raise Refusal(f'{key} = "{text}" has an empty value; give values between commas, as 2,4,8')
    for value in values:
        check_value(key, value)
    return list(dict.fromkeys(values))


def check_value(key, value):
    """What this program itself knows to be wrong; run_scene knows the rest."""
    if key == "precision" and value not in ("float", "double"):
        raise Refusal(f"precision = {value} must be float or double")
    if key == "threads" and not (value.isdigit() and 1 <= int(value) <= 1024):
        raise Refusal(
            f"threads = {value} must be a whole number from 1 to 1024; a point says how many it "
            "used, so 0 for all of them is not allowed"
        )


def parse_grid(shorthands, grid_texts):
    """Axes in a dict, key -> values.

    shorthands: dict of option -> text or None; grid_texts: list of "key=v1,v2".
    """
    axes = {}
    given = [(SHORTHANDS[name], text) for name, text in shorthands.items() if text is not None]
    for text in grid_texts:
        key, separator, values = text.partition("=")
        if not separator or not key.strip():
            raise Refusal(
                f'--grid "{text}" must be key=v1,v2,..., as --grid solver.epsilon=0.01,0.1'
            )
        given.append((SHORTHANDS.get(key.strip().replace("-", "_"), key.strip()), values))
    for key, text in given:
        if key in axes:
            raise Refusal(f"{key} is given twice; give all of its values at once")
        axes[key] = parse_axis(key, text)
    return axes


def expand(axes):
    """Every combination, the last axis fastest: a list of dicts key -> value."""
    return [dict(zip(axes, values)) for values in itertools.product(*axes.values())]


def identity(point):
    """The point as one line that does not depend on the order of its axes."""
    return (
        " ".join(f"{key}={value}" for key, value in sorted(point.items())) or "as the scene has it"
    )
