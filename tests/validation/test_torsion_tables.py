"""S. P. Timoshenko, J. N. Goodier, Theory of Elasticity, 3rd ed., McGraw-Hill 1970, section 109, table on page 312:
torsion of a rectangular bar, torsion constant k1 b a^3 and modulus k2 b a^2 for the sides b >= a.
"""

from __future__ import annotations

import pytest

from mechanics.section import Rectangle

TABLE = [
    (1.0, 0.1406, 0.208),
    (1.2, 0.166, 0.219),
    (1.5, 0.196, 0.231),
    (2.0, 0.229, 0.246),
    (2.5, 0.249, 0.258),
    (3.0, 0.263, 0.267),
    (4.0, 0.281, 0.282),
    (5.0, 0.291, 0.291),
    (10.0, 0.312, 0.312),
    (1e6, 0.333, 0.333),
]


@pytest.mark.parametrize(("ratio", "k1", "k2"), TABLE)
def test_a_rectangle_in_torsion(ratio: float, k1: float, k2: float) -> None:
    a = 0.02
    for section in (Rectangle(a, ratio * a), Rectangle(ratio * a, a)):
        assert section.torsion_constant / (ratio * a**4) == pytest.approx(k1, abs=5.1e-4 if k1 != 0.1406 else 5e-5)
        assert section.torsion_modulus / (ratio * a**3) == pytest.approx(k2, abs=5.1e-4)
