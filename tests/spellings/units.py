"""Units as hands write them, grouped by what they measure: our own factors to SI, not the table of the product."""

from __future__ import annotations

from math import pi

DEGREE, TURN = pi / 180, 2 * pi

Group = tuple[tuple[str, float], ...]

GROUPS: dict[str, Group] = {
    "length": (
        ("m", 1), ("mm", 1e-3), ("cm", 1e-2), ("km", 1e3), ("dm", 0.1), ("μm", 1e-6), ("µm", 1e-6),
        ("м", 1), ("мм", 1e-3), ("см", 1e-2), ("m.", 1),
    ),
    "angle": (
        ("deg", DEGREE), ("°", DEGREE), ("rad", 1), ("mrad", 1e-3), ("рад", 1), ("град", DEGREE), ("stopni", DEGREE),
        ("rad.", 1), ("º", DEGREE),
    ),
    "angular velocity": (
        ("rad/s", 1), ("1/s", 1), ("s^-1", 1), ("s⁻¹", 1), ("rad·s⁻¹", 1), ("rad/sec", 1), ("рад/с", 1), ("1/с", 1),
        ("с⁻¹", 1), ("rpm", TURN / 60), ("obr/min", TURN / 60), ("об/мин", TURN / 60), ("rev/min", TURN / 60),
        ("obr./min", TURN / 60), ("об./мин", TURN / 60), ("obr/s", TURN), ("deg/s", DEGREE), ("°/s", DEGREE),
        ("krad/s", 1e3),
    ),
    "angular acceleration": (
        ("rad/s^2", 1), ("rad/s²", 1), ("rad/s2", 1), ("1/s^2", 1), ("s^-2", 1), ("s⁻²", 1), ("рад/с²", 1),
        ("рад/с^2", 1), ("deg/s^2", DEGREE),
    ),
    "velocity": (
        ("m/s", 1), ("mm/s", 1e-3), ("cm/s", 1e-2), ("km/h", 1 / 3.6), ("m*s^-1", 1), ("m·s⁻¹", 1), ("m s^-1", 1),
        ("м/с", 1), ("мм/с", 1e-3), ("км/ч", 1 / 3.6),
    ),
    "acceleration": (
        ("m/s^2", 1), ("m/s²", 1), ("m/s2", 1), ("mm/s^2", 1e-3), ("m·s⁻²", 1), ("м/с²", 1), ("м/с^2", 1),
        ("мм/с²", 1e-3), ("m/s/s", 1),
    ),
    "force": (("N", 1), ("kN", 1e3), ("MN", 1e6), ("daN", 10), ("Н", 1), ("кН", 1e3), ("МН", 1e6), ("H", 1)),
    "torque": (
        ("N*m", 1), ("Nm", 1), ("N·m", 1), ("N m", 1), ("N.m", 1), ("kNm", 1e3), ("kN*m", 1e3), ("kN·m", 1e3),
        ("N*mm", 1e-3), ("N·mm", 1e-3), ("Nmm", 1e-3), ("kNmm", 1), ("kN·cm", 10), ("kNcm", 10), ("Ncm", 1e-2),
        ("Н·м", 1), ("Нм", 1), ("кН·м", 1e3), ("кНм", 1e3), ("Н·мм", 1e-3), ("Нмм", 1e-3), ("Н*м", 1), ("kN m", 1e3),
    ),
    "stress": (
        ("Pa", 1), ("kPa", 1e3), ("MPa", 1e6), ("GPa", 1e9), ("N/m^2", 1), ("N/mm^2", 1e6), ("N/mm²", 1e6),
        ("N/mm2", 1e6), ("N·mm⁻²", 1e6), ("N*mm^-2", 1e6), ("kN/cm^2", 1e7), ("kN/m²", 1e3), ("Па", 1), ("кПа", 1e3),
        ("МПа", 1e6), ("ГПа", 1e9), ("Н/мм²", 1e6), ("Н/мм2", 1e6), ("Н/мм^2", 1e6),
    ),
    "line load": (
        ("N/m", 1), ("kN/m", 1e3), ("N/mm", 1e3), ("kN·m⁻¹", 1e3), ("N*m^-1", 1), ("Н/м", 1), ("кН/м", 1e3),
        ("Н/мм", 1e3),
    ),
    "twist": (
        ("rad/m", 1), ("deg/m", DEGREE), ("°/m", DEGREE), ("mrad/m", 1e-3), ("1/m", 1), ("рад/м", 1),
        ("град/м", DEGREE),
    ),
    "area": (("m^2", 1), ("m²", 1), ("cm^2", 1e-4), ("cm²", 1e-4), ("mm^2", 1e-6), ("mm2", 1e-6), ("мм²", 1e-6)),
    "section modulus": (
        ("m^3", 1), ("m³", 1), ("cm^3", 1e-6), ("cm³", 1e-6), ("cm3", 1e-6), ("mm^3", 1e-9), ("mm³", 1e-9),
        ("мм³", 1e-9), ("см³", 1e-6), ("см^3", 1e-6),
    ),
    "second moment": (
        ("m^4", 1), ("m⁴", 1), ("cm^4", 1e-8), ("cm⁴", 1e-8), ("cm4", 1e-8), ("mm^4", 1e-12), ("mm⁴", 1e-12),
        ("mm4", 1e-12), ("см⁴", 1e-8), ("мм^4", 1e-12), ("см4", 1e-8),
    ),
    "bending stiffness": (
        ("N*m^2", 1), ("N·m²", 1), ("Nm²", 1), ("Nm^2", 1), ("kN*m^2", 1e3), ("kNm²", 1e3), ("kN·m²", 1e3),
        ("N·mm²", 1e-6), ("Nmm²", 1e-6), ("MN·m²", 1e6), ("Н·м²", 1), ("кН·м²", 1e3), ("кНм²", 1e3),
    ),
    "power": (("W", 1), ("kW", 1e3), ("MW", 1e6), ("N*m/s", 1), ("Вт", 1), ("кВт", 1e3)),
    "energy": (("J", 1), ("kJ", 1e3), ("Дж", 1), ("кДж", 1e3), ("N*m", 1)),
    "mass": (("kg", 1), ("g", 1e-3), ("t", 1e3), ("кг", 1), ("г", 1e-3)),
    "time": (("s", 1), ("ms", 1e-3), ("min", 60), ("с", 1), ("мин", 60)),
    "frequency": (("Hz", 1), ("kHz", 1e3), ("Гц", 1)),
    "number": (("", 1),),
}  # fmt: skip
PRINTED = {"1": ""}  # a field without a unit


def group_of(unit: str) -> tuple[str, float, Group]:
    """Give what a printed unit measures, its factor, and all spellings of units of the same quantity.

    Raises:
        KeyError: No group holds this unit; write it into the table above.
    """
    wanted = PRINTED.get(unit, unit)
    for name, group in GROUPS.items():
        for spelling, factor in group:
            if spelling == wanted:
                return name, factor, group
    raise KeyError(unit)
