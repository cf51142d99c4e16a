"""Closed forms of freezing water and floating ice, and levels of particles. SI units."""

import dataclasses
import math

import numpy as np


@dataclasses.dataclass
class Freezing:
    """A plate at `wall_c` below water at `water_c`, both from the start; melting at 0 degrees C."""

    wall_c: float = -10.0
    water_c: float = 0.0
    latent_heat_fusion_j_kg: float = 334e3
    ice_j_kgk: float = 2050.0
    water_j_kgk: float = 4186.0
    ice_w_mk: float = 2.22
    water_w_mk: float = 0.58
    ice_kg_m3: float = 917.0
    water_kg_m3: float = 1000.0

    def stefan_number(self):
        return -self.ice_j_kgk * self.wall_c / self.latent_heat_fusion_j_kg

    def diffusivity_m2_s(self):
        """Of ice."""
        return self.ice_w_mk / (self.ice_kg_m3 * self.ice_j_kgk)

    def constant(self):
        """lambda of the front s = 2 lambda sqrt(alpha t): Neumann's solution, Carslaw and Jaeger
        1959, 11.2 (IV).

        Ice that is lighter than water lifts it at (1 - r) ds/dt with r the ratio of the densities,
        so that the water keeps the similarity with r lambda in place of lambda in its own terms.
        """
        water = self.water_w_mk / (self.water_kg_m3 * self.water_j_kgk)
        ratio = math.sqrt(self.diffusivity_m2_s() / water)
        superheat = self.water_w_mk / self.ice_w_mk * ratio * self.water_c / -self.wall_c
        low, high = 1e-6, 3.0
        for _ in range(80):
            guess = 0.5 * (low + high)
            swept = self.ice_kg_m3 / self.water_kg_m3 * ratio * guess
            warm = superheat * math.exp(-(swept**2)) / math.erfc(swept) if superheat else 0.0
            supply = math.exp(-(guess**2)) / math.erf(guess) - warm
            low, high = (
                (guess, high)
                if supply > guess * math.sqrt(math.pi) / self.stefan_number()
                else (low, guess)
            )
        return 0.5 * (low + high)

    def front(self, heat_s):
        """Thickness of the ice in m after so many seconds of heat."""
        return 2.0 * self.constant() * np.sqrt(self.diffusivity_m2_s() * np.asarray(heat_s))

    def time(self, front_m):
        """Seconds of heat until the ice is so thick."""
        return (front_m / (2.0 * self.constant())) ** 2 / self.diffusivity_m2_s()

    def settings(self):
        """The same for run_scene --set, but for what blocks and plates have of their own."""
        heat = {
            "latent_heat_fusion_j_kg": self.latent_heat_fusion_j_kg,
            "ice_specific_heat_j_kgk": self.ice_j_kgk,
            "water_specific_heat_j_kgk": self.water_j_kgk,
            "ice_conductivity_w_mk": self.ice_w_mk,
            "water_conductivity_w_mk": self.water_w_mk,
        }
        density = f"ice.density_ratio={self.ice_kg_m3 / self.water_kg_m3!r}"
        return [*(f"thermal.{key}={value!r}" for key, value in heat.items()), density]


def alike(stefan, water_c=0.0, ice_kg_m3=1000.0):
    """Ice and water with one conductivity and one capacity, at a Stefan number of choice."""
    latent_heat_fusion_j_kg = 2000.0 * 10.0 / stefan
    return Freezing(-10.0, water_c, latent_heat_fusion_j_kg, 2000.0, 2000.0, 2.0, 2.0, ice_kg_m3)


def level(heights_m, spacing_m, floor_m=0.0):
    """Height up to which a column of water stands: where the particles per height fall to half of
    those inside it.

    Each particle is spread over a spacing above and below it, so that a lattice of any offset has
    its own height.
    """
    heights_m = np.asarray(heights_m)
    top = heights_m.max() + spacing_m
    at = np.arange(floor_m, top + spacing_m, 0.02 * spacing_m)
    crowd = np.zeros_like(at)
    for height in heights_m:
        first, last = np.searchsorted(at, (height - spacing_m, height + spacing_m))
        crowd[first:last] += 1.0 - np.abs(at[first:last] - height) / spacing_m
    inside = (at > floor_m + 2 * spacing_m) & (at < top - 4 * spacing_m)
    above = np.flatnonzero(crowd >= 0.5 * crowd[inside].mean())
    return at[above[-1]]


def below(heights_m, level_m, cube_m):
    """Share of the volume of a body of cubes, upright enough, that lies below a level."""
    return np.clip((level_m - np.asarray(heights_m)) / cube_m + 0.5, 0.0, 1.0).mean()
