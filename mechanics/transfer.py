"""Transfer functions: how an output follows the driving coordinate, whatever the time (domain ML-4).

phi = f(q), u = df/dq, u' = d2f/dq2; then phi' = u q' and phi'' = u' q'^2 + u q''.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from mechanics.linkage import LinkageMotion


@dataclass(frozen=True, slots=True)
class Transfer:
    """First and second transfer function at one position; units of the output by those of q, and by their square."""

    u: float
    u_prime: float = 0.0

    def rate(self, q_dot: float) -> float:
        """Rate of the output."""
        return self.u * q_dot

    def acceleration(self, q_dot: float, q_ddot: float) -> float:
        """Second rate of the output."""
        return self.u_prime * q_dot**2 + self.u * q_ddot

    def behind(self, ratio: float) -> Transfer:
        """The same output by a coordinate that drives q with a constant ratio dq/d(coordinate), such as a gear's."""
        return Transfer(self.u * ratio, self.u_prime * ratio**2)


def of_unit_motion(motion: LinkageMotion) -> Mapping[str, Transfer]:
    """Read the transfer functions of every output of a linkage from its motion at unit rate of the driver.

    Args:
        motion: Solved with a rate of 1 and an acceleration of 0: then rates are u and accelerations u'.
    """
    return {name: Transfer(u, motion.acc[name]) for name, u in motion.vel.items()}
