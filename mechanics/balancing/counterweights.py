"""Counterweights that balance a four-bar statically (domain BV-7)."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf

from mechanics.checks import finite, positive


@dataclass(frozen=True, slots=True)
class FourBarLinks:
    """A four-bar on pivots A (0, 0) and D (l4, 0): lengths, masses, centres from the first joint along the link."""

    l1: float  # crank AB, m
    l2: float  # coupler BC, m
    l3: float  # rocker CD, m
    l4: float  # frame AD, m
    m1: float  # kg
    m2: float  # kg
    m3: float  # kg
    s1: float  # A to the centre of the crank, m
    s2: float  # B to the centre of the coupler, m
    s3: float  # D to the centre of the rocker, m

    def __post_init__(self) -> None:
        for name in ("l1", "l2", "l3", "l4"):
            positive(name, getattr(self, name), "m")
        for name in ("s1", "s2", "s3"):
            finite(name, getattr(self, name), "m")
        for name in ("m1", "m2", "m3"):
            if not 0 <= getattr(self, name) < inf:
                raise ValueError(f"{name} = {getattr(self, name)} kg must be finite and not negative")
        if not self.m1 + self.m2 + self.m3:
            raise ValueError("m1, m2, m3: a four-bar without mass has no mass centre")

    def shared(self) -> tuple[tuple[float, float], ...]:
        """Share each link's mass between its joints: (A, B), (B, C), (D, C), kg; the pair keeps the mass centre."""
        links = ((self.m1, self.s1, self.l1), (self.m2, self.s2, self.l2), (self.m3, self.s3, self.l3))
        return tuple((m * (length - s) / length, m * s / length) for m, s, length in links)


@dataclass(frozen=True, slots=True)
class FourBarBalance:
    """Counterweights that keep the mass centre of a four-bar at rest, and its place on the line of the pivots.

    A negative counterweight stands for as much mass on the link's own side of its pivot.
    """

    m1k: float  # on the crank, kg
    m2k: float  # on the rocker, kg
    m_I: float  # all masses at A, kg
    m_II: float  # all masses at D, kg
    x_S: float  # m from A
    y_S: float = 0.0  # m, on the line of the pivots


def four_bar(links: FourBarLinks, e1: float, e3: float) -> FourBarBalance:
    """Balance a four-bar statically by counterweights behind A and D.

    Args:
        links: Lengths, masses and mass centres.
        e1: Distance of the crank's counterweight from A, m, positive.
        e3: Distance of the rocker's counterweight from D, m, positive.

    Raises:
        ValueError: A distance is not positive and finite.

    Source:
        Domain BV-7: m_k1 = (m_1B + m_2B) l1/e1, m_k2 = (m_2C + m_3C) l3/e3.
    """
    positive("distance e1", e1, "m")
    positive("distance e3", e3, "m")
    (m1A, m1B), (m2B, m2C), (m3D, m3C) = links.shared()
    m1k, m2k = (m1B + m2B) * links.l1 / e1, (m2C + m3C) * links.l3 / e3
    m_I, m_II = m1A + m1B + m2B + m1k, m3D + m3C + m2C + m2k
    if not m_I + m_II > 0:
        raise ValueError(f"m1k = {m1k:g} kg and m2k = {m2k:g} kg leave no mass in the linkage")
    return FourBarBalance(m1k, m2k, m_I, m_II, links.l4 * m_II / (m_I + m_II))
