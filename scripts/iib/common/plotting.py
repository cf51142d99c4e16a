"""matplotlib without a screen. It takes a second to import, so only import this where it is needed."""

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402, F401
