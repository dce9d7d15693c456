"""T. Freeth et al., "Decoding the ancient Greek astronomical calculator known as the Antikythera Mechanism", Nature 444
(2006), pp. 587-591: the train from the Sun wheel b2 to the Moon, 64/38 x 48/24 x 127/32, makes 254 turns in 19 years.
"""

from __future__ import annotations

from fractions import Fraction

from mechanics import gear_train, willis
from mechanics.gear_train import Mesh, Train
from mechanics.willis import Stage

TEETH = ((64, 38), (48, 24), (127, 32))


def test_the_moon_makes_254_turns_in_19_years() -> None:
    shafts = ("b", "c", "d", "e")
    meshes = tuple(Mesh(shafts[i], shafts[i + 1], *teeth) for i, teeth in enumerate(TEETH))
    found = gear_train.solve(Train(shafts, meshes, input_omega={"b": 19}, output="e"))
    assert found.omega_exact["e"] == -254
    assert found.ratio is not None and found.ratio.exact == Fraction(-19, 254)
    assert willis.fixed_axis_ratio([Stage(*teeth) for teeth in TEETH]) == Fraction(-19, 254)
