"""Point masses in place of a link (domain BV-6)."""

from __future__ import annotations

from dataclasses import dataclass

from mechanics.checks import positive


@dataclass(frozen=True, slots=True)
class Substitution:
    """Point masses in place of a link; the defect is J_S less the inertia of the points about S."""

    m_A: float  # kg
    m_B: float  # kg
    m_S: float  # kg, 0 for two points
    defect: float  # kg m^2


def two_points(m: float, l_AS: float, l_BS: float, J_S: float = 0.0) -> Substitution:
    """Replace a link by masses in A and B with its mass and its mass centre (BV-6, static).

    Raises:
        ValueError: A mass or a distance is not positive and finite.
    """
    _link(m, l_AS, l_BS)
    m_A, m_B = m * l_BS / (l_AS + l_BS), m * l_AS / (l_AS + l_BS)
    return Substitution(m_A, m_B, 0.0, J_S - (m_A * l_AS**2 + m_B * l_BS**2))


def three_points(m: float, l_AS: float, l_BS: float, J_S: float) -> Substitution:
    """Replace a link by masses in A, B and S with its mass, its mass centre and its inertia (BV-6, dynamic).

    Raises:
        ValueError: A mass, an inertia or a distance is not positive and finite.
    """
    _link(m, l_AS, l_BS)
    positive("inertia J_S", J_S, "kg m^2")
    span = l_AS + l_BS
    return Substitution(J_S / (l_AS * span), J_S / (l_BS * span), m - J_S / (l_AS * l_BS), 0.0)


def _link(m: float, l_AS: float, l_BS: float) -> None:
    positive("mass m", m, "kg")
    positive("distance l_AS", l_AS, "m")
    positive("distance l_BS", l_BS, "m")
