"""matplotlib without a screen. Takes a second to import, so import it only where it is needed."""

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: F401
