"""Sign changes of polynomials, found piece by piece, so that a tiny leading coefficient loses none."""

from __future__ import annotations

from collections.abc import Sequence

# c0 + c1 t + c2 t^2 + c3 t^3 + c4 t^4, written out: these few lines are the inner loop of every exact extreme.
Quartic = tuple[float, float, float, float, float]

# A bracket as narrow as the first is a root to the last digit; so is a Newton step as short as the second, once taken.
_ROUNDING = 4e-16
_SHORT = 1e-10


def crossings(polynomial: Quartic, end: float, inner: Sequence[float] = ()) -> Sequence[float]:
    """Find where a polynomial changes its sign between 0 and an end.

    Args:
        polynomial: Coefficients from the constant term up.
        end: The end of the stretch, positive.
        inner: The rising crossings of the derivative on the stretch: between them the polynomial is monotone.

    Returns:
        The rising places of the sign changes; an inner place where the polynomial is exactly zero is among them.
    """
    c0, c1, c2, c3, c4 = polynomial
    if not (c2 or c3 or c4):
        t = -c0 / c1 if c1 else 0.0
        return (t,) if 0 < t < end else ()
    found: list[float] = []
    left, at_left = 0.0, c0
    for right in (*inner, end):
        at_right = c0 + right * (c1 + right * (c2 + right * (c3 + right * c4)))
        if at_left < 0 < at_right or at_right < 0 < at_left:
            found.append(_between(polynomial, left, right, at_left, at_right))
        elif at_right == 0 and right < end:
            found.append(right)
        left, at_left = right, at_right
    return found


def _between(polynomial: Quartic, left: float, right: float, at_left: float, at_right: float) -> float:
    """Newton's method kept in a bracket, which is halved where Newton would leave it, and at every eighth step.

    A root that rounding alone has moved inside from an end is that end.
    """
    c0, c1, c2, c3, c4 = polynomial
    d2, d3, d4 = 2 * c2, 3 * c3, 4 * c4  # of the derivative
    rising = at_left < at_right
    t = left + (right - left) * (at_left / (at_left - at_right))
    size = max(abs(left), abs(right))
    narrow, short = _ROUNDING * size, _SHORT * size
    step = 0
    while True:
        step += 1
        residue = c0 + t * (c1 + t * (c2 + t * (c3 + t * c4)))
        if residue == 0 or right - left <= narrow:
            return t
        if (residue < 0) == rising:
            left = t
        else:
            right = t
        incline = c1 + t * (d2 + t * (d3 + t * d4))
        last, t = t, t - residue / incline if incline else left
        if step % 8 == 0 or not left - narrow <= t <= right + narrow:
            t = (left + right) / 2
        elif abs(t - last) <= short:
            return min(max(t, left), right)
