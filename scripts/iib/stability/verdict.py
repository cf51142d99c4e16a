"""Four words for what becomes of a run; doc/stability.md explains them."""

import math

REFUSED, STABLE, DEGRADED, UNSTABLE = "refused", "stable", "degraded", "unstable"
WORDS = (STABLE, DEGRADED, REFUSED, UNSTABLE)

# Beyond these a run that stays up is called degraded. Water at rest at the default has 0.6 % and 0
# %.
MOST_ERROR = 0.02  # mean density error
MOST_RISE = 0.01  # energy risen without work, of what the scene holds
MOST_CUT = 0.01  # corrections that were cut, per particle and substep


def worse(value, bound):
    """A metric that the scene lacks is no worse."""
    return not math.isnan(value) and value > bound


def cut_share(report):
    """Corrections that solver.max_correction_h cut short, per particle and substep."""
    return report["correction_limited"] / max(1, report["particles"] * report["steps"])


def energy_rise(outcome):
    """Without work, of what the scene holds; steam is lifted by heat, which is work."""
    return math.nan if outcome.report.get("max_steam", 0) > 0 else outcome.metric("energy_rise")


def verdict(outcome):
    if outcome.status == "refused":
        return REFUSED
    if not outcome.survived():
        return UNSTABLE
    report = outcome.report
    if (
        report["speed_limited"] > 0
        or cut_share(report) > MOST_CUT
        or worse(report["density_error_mean"], MOST_ERROR)
    ):
        return DEGRADED
    return DEGRADED if worse(energy_rise(outcome), MOST_RISE) else STABLE


def reason(outcome):
    """Why it is not stable, in a few words."""
    if outcome.status in ("refused", "crashed", "stopped"):
        return outcome.message
    report, words = outcome.report, []
    if report["non_finite"]:
        words.append(f"{report['non_finite']} values not finite")
    if report["escaped"]:
        words.append(f"{report['escaped']} particles escaped")
    if report["speed_limited"]:
        words.append(f"slowed {report['speed_limited']} times")
    if cut_share(report) > MOST_CUT:
        words.append(f"{100 * cut_share(report):.3g} corrections cut per hundred particle substeps")
    if worse(report["density_error_mean"], MOST_ERROR):
        words.append(f"density error {100 * report['density_error_mean']:.3g} %")
    if worse(energy_rise(outcome), MOST_RISE):
        words.append(f"energy risen by {100 * energy_rise(outcome):.3g} %")
    return ", ".join(words)
