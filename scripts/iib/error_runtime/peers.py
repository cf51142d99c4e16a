"""Points of other programs, from a CSV file."""

import csv

from iib.common.refusal import Refusal

COLUMNS = """peer method setting particles threads precision us_per_particle_per_s
mean_error_percent max_error_percent""".split()
NUMBERS = ("us_per_particle_per_s", "mean_error_percent", "max_error_percent")


def read_peers(path):
    """List of dicts with the COLUMNS; the NUMBERS as floats, None where a cell is empty."""
    try:
        with open(path, newline="") as file:
            rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    except OSError as error:
        raise Refusal(f"--peers {path} cannot be read: {error.strerror}")
    for number, row in enumerate(rows, 1):
        missing = [name for name in COLUMNS if row.get(name) is None]
        if missing:
            raise Refusal(
                f"--peers {path}: row {number} lacks {', '.join(missing)}; the columns are "
                f"{','.join(COLUMNS)}"
            )
        for name in NUMBERS:
            row[name] = positive(row[name], f"--peers {path}: {name} of row {number}")
        if row["us_per_particle_per_s"] is None or row["mean_error_percent"] is None:
            raise Refusal(
                f"--peers {path}: row {number} needs us_per_particle_per_s and mean_error_percent"
            )
    return rows


def positive(text, thing):
    if text.strip() == "":
        return None
    try:
        value = float(text)
    except ValueError:
        value = 0.0
    if not 0.0 < value < float("inf"):
        raise Refusal(
            f"{thing} = {text} must be a number above 0, or empty where it was not measured"
        )
    return value
