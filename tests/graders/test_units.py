"""Units: the table against Pint, and the spellings engineers use."""

from __future__ import annotations

import math
import warnings
from typing import Any

import pytest

from graders import AnswerSyntaxError
from graders.language import Reason
from graders.unit_words import words
from graders.units import TABLE, WORDS, fits, nearest_unit, read_unit, readings
from graders.words import UNITS, printed_unit

PINT = [
    "m",
    "mm",
    "cm",
    "km",
    "kg",
    "g",
    "s",
    "ms",
    "min",
    "h",
    "N",
    "kN",
    "MN",
    "Pa",
    "kPa",
    "MPa",
    "GPa",
    "J",
    "kJ",
    "W",
    "kW",
    "Hz",
    "rad",
    "deg",
    "N*m",
    "kN*m",
    "N/m",
    "kN/m",
    "N/mm^2",
    "N/m^2",
    "m/s",
    "m/s^2",
    "mm/s",
    "rad/s",
    "rad/s^2",
    "deg/s",
    "deg/m",
    "rad/m",
    "m^2",
    "m^3",
    "m^4",
    "mm^4",
    "cm^4",
    "cm^3",
    "kg*m^2",
    "kg/m^3",
    "1/s",
    "1/m",
    "rpm",
    "bar",
    "N*s/m",
    "N*m/rad",
    "t",
    "mrad",
    "um",
    "W/m^2",
    "J/kg",
]


@pytest.fixture(scope="module")
def registry() -> Any:
    """The units of another program."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return pytest.importorskip("pint").UnitRegistry()


@pytest.mark.parametrize("text", PINT)
def test_factor_and_dimension_agree_with_pint(registry: Any, text: str) -> None:
    quantity = registry.Quantity(1, text.replace("^", "**").replace("min", "minute")).to_base_units()
    unit = read_unit(text)
    powers = {str(key): power for key, power in quantity.dimensionality.items()}
    assert unit.factor == pytest.approx(quantity.magnitude, rel=1e-12)
    assert unit.dimension[:3] == tuple(powers.get(f"[{name}]", 0) for name in ("length", "mass", "time"))


@pytest.mark.parametrize(
    ("typed", "plain"),
    [
        ("Nm", "N*m"),
        ("N·m", "N*m"),
        ("N m", "N*m"),
        ("N.m", "N*m"),
        ("kNm", "kN*m"),
        ("kN.m", "kN*m"),
        ("Н·м", "N*m"),
        ("кН·м", "kN*m"),
        ("Нм", "N*m"),
        ("N/mm²", "MPa"),
        ("N/mm2", "MPa"),
        ("N/mm^2", "MPa"),
        ("N mm^-2", "MPa"),
        ("N·mm⁻²", "MPa"),
        ("МПа", "MPa"),
        ("ГПа", "GPa"),
        ("кПа", "kPa"),
        ("mm^4", "mm⁴"),
        ("cm³", "cm^3"),
        ("мм", "mm"),
        ("obr/min", "rpm"),
        ("об/мин", "rpm"),
        ("rev/min", "rpm"),
        ("1/s", "s^-1"),
        ("s⁻¹", "1/s"),
        ("рад/с", "rad/s"),
        ("°", "deg"),
        ("град", "deg"),
        ("м/с²", "m/s^2"),
        ("m/s/s", "m/s^2"),
        ("kN/(m*m)", "kN/m^2"),
        ("кг", "kg"),
        ("µm", "μm"),
        ("um", "μm"),
        ("stopni", "deg"),
        ("Вт", "W"),
        ("кВт", "kW"),
        ("N*m", "Nm"),
        ("сек", "s"),
        ("milimetrów", "mm"),
        ("millimetres", "mm"),
        ("миллиметра", "mm"),
        ("kiloniutony", "kN"),
        ("килоньютон-метров", "kN*m"),
        ("kilonewton metres", "kN*m"),
        ("niutonometrów", "N*m"),
        ("megapascals", "MPa"),
        ("мегапаскалей", "MPa"),
        ("metres per second", "m/s"),
        ("radianów na sekundę", "rad/s"),
        ("оборотов в минуту", "rpm"),
        ("obrotów/min", "rpm"),
        ("r/min", "rpm"),
        ("Nmm", "N*mm"),
        ("kNcm", "kN*cm"),
        ("кНмм", "kN*mm"),
        ("kNm²", "kN*m^2"),
        ("Nmm^2", "N*mm^2"),
        ("obr./min", "rpm"),
        ("об./мин.", "rpm"),
        ("м/c", "m/s"),
        ("кH", "kN"),
        ("MПа", "MPa"),
    ],
)
def test_spellings_of_one_unit_are_one_unit(typed: str, plain: str) -> None:
    one, other = read_unit(typed), read_unit(plain)
    assert one.dimension == other.dimension
    assert one.factor == pytest.approx(other.factor, rel=1e-12)


def test_the_table_reads_three_hundred_spellings() -> None:
    joined = [f"{a}/{b}" for a in ("m", "mm", "kN", "N", "rad", "м") for b in ("s", "m", "mm", "мин", "min")]
    readable = [
        text for text in (*TABLE, *joined, *(f"{t}^2" for t in TABLE if t != "1")) if read_unit(text).factor > 0
    ]
    assert len(set(readable)) >= 300


@pytest.mark.parametrize(
    ("text", "place"), [("qq", 0), ("N/", 2), ("m^x", 2), ("m^99", 2), ("(N", 2), ("N//m", 2), ("5", 0)]
)
def test_an_unknown_unit_is_refused_with_its_place(text: str, place: int) -> None:
    with pytest.raises(AnswerSyntaxError) as refused:
        read_unit(text)
    assert refused.value.position == place
    assert refused.value.reason in (Reason.UNKNOWN_UNIT, Reason.NEEDS_OPERAND)


@pytest.mark.parametrize(
    ("typed", "expected", "same"),
    [
        ("1/s", "rad/s", True),
        ("rpm", "rad/s", True),
        ("Hz", "rad/s", False),
        ("J", "N*m", False),
        ("N*m", "J", True),
        ("MPa", "Pa", True),
        ("N", "Pa", False),
        ("m", "mm", True),
        ("rad", "deg", True),
        ("deg/m", "rad/m", True),
        ("1/m", "rad/m", True),
        ("Hz", "Hz", True),
        ("s", "min", True),
        ("m/m", "m", False),
        ("m/m", "rad", False),
    ],
)
def test_units_fit_what_they_measure(typed: str, expected: str, same: bool) -> None:
    assert fits(read_unit(typed), read_unit(expected)) is same


def test_a_turn_a_minute_is_a_thirtieth_of_pi() -> None:
    assert read_unit("obr/min").factor == pytest.approx(math.pi / 30, rel=1e-15)


def test_a_decanewton_is_ten_newtons() -> None:
    assert read_unit("daN").factor == 10


@pytest.mark.parametrize(
    ("typed", "expected", "factors"),
    [
        ("1/min", "rpm", (math.pi / 30, 1 / 60)),
        ("1/s", "rpm", (2 * math.pi, 1)),
        ("1/min", "rad/s", (math.pi / 30, 1 / 60)),
        ("1/s", "rad/s", (1,)),
        ("rad/s", "rpm", (1,)),
        ("obr/min", "rpm", (math.pi / 30,)),
        ("Hz", "Hz", (1,)),
        ("mm", "m", (1e-3,)),
    ],
)
def test_turns_left_out_of_a_speed_are_read_where_turns_are_counted(
    typed: str, expected: str, factors: tuple[float, ...]
) -> None:
    assert readings(read_unit(typed), read_unit(expected)) == pytest.approx(factors, rel=1e-12)


@pytest.mark.parametrize("lang", UNITS)
def test_a_printed_unit_is_read_as_the_same_unit(lang: str) -> None:
    for unit in [*PINT, "rad/s^2", "kN*m^2", "N/mm^2", "deg/m", "rpm"]:
        printed = printed_unit(unit, lang)
        assert read_unit(printed) == read_unit(unit), (unit, printed)


def test_russian_prints_units_in_its_own_letters() -> None:
    units = ("mm", "kN*m^2", "rad/s", "MPa", "m/s^2", "1", "1/s")
    assert [printed_unit(unit, "ru") for unit in units] == ["мм", "кН·м²", "рад/с", "МПа", "м/с²", "", "1/с"]
    assert [printed_unit(unit, "pl") for unit in units] == ["mm", "kN·m²", "rad/s", "MPa", "m/s²", "", "1/s"]


@pytest.mark.parametrize(
    ("typed", "meant"),
    [
        ("Mpa", "MPa"),
        ("KN", "kN"),
        ("knm", "kNm"),
        ("mmm", "mm"),
        ("w", "W"),
        ("MM", "mm"),
        ("mM", "mm"),
        ("\u041c\u041c", "мм"),
        ("\u0421\u041c", "см"),
        ("\u041c\u041f\u0410", "МПа"),
        ("MPA", "MPa"),
    ],
)
def test_a_near_unit_is_proposed(typed: str, meant: str) -> None:
    assert nearest_unit(typed) == meant


@pytest.mark.parametrize("typed", ["grad", "up", "мm", "na", "w górę", "pod"])
def test_what_is_near_to_no_unit_is_not_taken_for_one(typed: str) -> None:
    with pytest.raises(AnswerSyntaxError) as refused:
        read_unit(typed)
    assert refused.value.proposal.meant in ("", "W", "rad")


def test_every_word_is_a_unit() -> None:
    every = [word for word, _ in words()]
    assert (
        len(every) > 1000 and [word for word in every if read_unit(word).factor != read_unit(WORDS[word]).factor] == []
    )
