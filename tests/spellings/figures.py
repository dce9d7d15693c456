"""Numbers as hands write them: figures, marks, powers of ten, fractions, minutes of arc."""

from __future__ import annotations

from decimal import ROUND_HALF_EVEN, Context, Decimal
from math import floor, log10

RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def rounded(value: float, figures: int) -> str:
    """Write a number with so many significant figures and no power of ten."""
    return f"{Context(prec=figures, rounding=ROUND_HALF_EVEN).create_decimal(Decimal(value)):f}"


def comma(text: str) -> str:
    """Write a decimal comma."""
    return text.replace(".", ",")


def power_of_ten(value: float, figures: int = 8) -> tuple[str, int]:
    """Split a number into a mantissa of one figure before the point and a power of ten."""
    exponent = floor(log10(abs(value))) if value else 0
    return rounded(value / 10.0**exponent, figures), exponent


def fraction(value: float) -> str:
    """Write a number as a fraction of whole numbers."""
    top = Decimal(rounded(value, 7))
    places = max(0, -int(top.as_tuple().exponent))
    return f"{int(top.scaleb(places))}/{10**places}"


def scientific(value: float) -> list[tuple[str, str]]:
    """Write a number with a power of ten in the ways students do."""
    mantissa, exponent = power_of_ten(value)
    return [
        ("e-notation", f"{mantissa}e{exponent}"),
        ("e-notation with a comma", f"{comma(mantissa)}E{exponent:+03d}"),
        ("ten to a power", f"{mantissa}*10^{exponent}"),
        ("ten to a bracketed power", f"{comma(mantissa)}·10^({exponent})"),
        ("ten to a starred power", f"{mantissa}*10**{exponent}"),
        ("ten to a raised power", f"{comma(mantissa)}×10{str(exponent).translate(RAISED)}"),
        ("ten to a spaced power", f"{mantissa} ⋅ 10^{exponent}"),
    ]


def arc(degrees: float) -> list[tuple[str, str]]:
    """Write an angle in degrees, minutes and seconds of arc."""
    sign, size = "-" if degrees < 0 else "", abs(degrees)
    whole = int(size)
    minutes = (size - whole) * 60
    seconds = (minutes - int(minutes)) * 60
    return [
        ("degrees and minutes", f"{sign}{whole}°{minutes:.3f}'"),
        ("degrees and primes", f"{sign}{whole}° {comma(f'{minutes:.3f}')}′"),
        ("minutes and seconds", f"{sign}{whole}°{int(minutes)}'{seconds:.2f}\""),
        ("minutes and double primes", f"{sign}{whole}°{int(minutes)}′{comma(f'{seconds:.2f}')}″"),
    ]
