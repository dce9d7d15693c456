"""The state of strain in a point, and its stresses by Hooke's law of an isotropic material (domain SM-5, SM-16).

Strains are numbers, extension positive; off the diagonal of the tensor stand gamma/2. Stresses in pascals.
"""

from __future__ import annotations

from dataclasses import dataclass

from mechanics import tensor
from mechanics.checks import positive
from mechanics.stress import StressState
from mechanics.tensor import Matrix
from mechanics.vectors import Vector


@dataclass(frozen=True, slots=True)
class Material:
    """An isotropic linear elastic material.

    Raises:
        ValueError: E is not positive and finite, or nu not between -1 and 0.5.
    """

    E: float  # Young's modulus, Pa
    nu: float  # Poisson's ratio

    def __post_init__(self) -> None:
        positive("Young's modulus E", self.E, "Pa")
        if not -1 < self.nu < 0.5:
            raise ValueError(f"Poisson's ratio nu = {self.nu} must be above -1 and below 0.5")

    @property
    def G(self) -> float:
        """Shear modulus E/(2(1 + nu)), Pa."""
        return self.E / (2 * (1 + self.nu))

    @property
    def K(self) -> float:
        """Bulk modulus E/(3(1 - 2 nu)), Pa."""
        return self.E / (3 * (1 - 2 * self.nu))

    @property
    def lame(self) -> float:
        """Lamé's first constant E nu/((1 + nu)(1 - 2 nu)), Pa."""
        return self.E * self.nu / ((1 + self.nu) * (1 - 2 * self.nu))


@dataclass(frozen=True, slots=True)
class StrainState:
    """A symmetric strain tensor, (3, 3), rows and columns x, y, z.

    Raises:
        ValueError: It is not of three rows of three, not finite, or not symmetric.
    """

    components: Matrix

    def __post_init__(self) -> None:
        object.__setattr__(self, "components", tensor.symmetric(self.components, "strain", ""))

    @property
    def shear(self) -> Vector:
        """Shear strains gamma_xy, gamma_yz, gamma_zx, rad: twice the components off the diagonal."""
        (_, xy, zx), (_, _, yz), _ = self.components
        return 2 * xy, 2 * yz, 2 * zx

    @property
    def volumetric(self) -> float:
        """Relative change of volume, the trace."""
        return tensor.invariants(self.components)[0]

    @property
    def principal(self) -> Vector:
        """Principal strains, largest first."""
        return tensor.principal(self.components)[0]

    @property
    def directions(self) -> Matrix:
        """Principal directions as rows, in the order of the strains; a right-handed set."""
        return tensor.principal(self.components)[1]


def strain_of(stress: StressState, material: Material) -> StrainState:
    """Return the strain of a stress: eps = ((1 + nu) S - nu tr(S) I)/E (domain SM-16)."""
    mean = material.nu * stress.invariants[0]
    return StrainState(_scaled(stress.components, (1 + material.nu) / material.E, -mean / material.E))


def stress_of(strain: StrainState, material: Material) -> StressState:
    """Return the stress of a strain: S = 2 G eps + lambda tr(eps) I (domain SM-16)."""
    return StressState(_scaled(strain.components, 2 * material.G, material.lame * strain.volumetric))


def _scaled(components: Matrix, factor: float, diagonal: float) -> Matrix:
    (a, b, c), (_, d, e), (_, _, f) = components
    return (
        (factor * a + diagonal, factor * b, factor * c),
        (factor * b, factor * d + diagonal, factor * e),
        (factor * c, factor * e, factor * f + diagonal),
    )
