"""The words of a polygon in Polish, English and Russian, and what is only there for good style."""

from __future__ import annotations


def _words(listed: str) -> frozenset[str]:
    return frozenset(listed.split())


LENGTH = _words("length len długość dlugosc długości dł dl długością длина длины длиной")
ANGLE = _words("angle ang kąt kat kąta kątem kącie ∠ угол угла углом")
CLOSURE = _words(
    "closure closed polygon loop sum vectors wielobok zamknięcie zamkniecie zamknięcia suma równanie rownanie równania "
    "closes контур замыкание замыкания замкнутость замкнутости многоугольник уравнение сумма"
)
UNKNOWNS = _words(
    "unknowns unknown sought niewiadome niewiadoma szukane szukana nieznane неизвестные неизвестное неизвестная "
    "неизвестный искомые искомая"
)
CONSTANT = _words(
    "constant const fixed stała stały stałe stałą stala staly stale постоянная постоянный постоянно постоянна const"
)
KNOWN = _words(
    "known given dana dany dane dan znana znany znane дан дана известна известен известная "
    "заданная заданный известный variable zmienna zmienny переменная переменный"
)
SOUGHT = _words(
    "unknown sought nieznana nieznany niewiadoma szukana szukany szukane неизвестна неизвестен неизвестная неизвестный "
    "искомая искомый"
)
FILLERS = _words("of o i and with at is the a from to z ze od do oraz из от в к до с и под pod equal =")
AXIS_FILLERS = _words(
    "projection proj on of the onto axis axes rzut rzuty na oś os osi проекция на ось оси equation równanie "
    "velocity velocities acceleration accelerations prędkości przyspieszenia скорости ускорения"
)
VECTOR_FILLERS = _words("vector wektor вектор")
RATES = _words("rates rate where gdzie pochodne oznaczenia где производные обозначения")

X = _words("x ox xd xdd dx ddx vx ax px x' x'' dx/dt")
Y = _words("y oy yd ydd dy ddy vy ay py y' y'' dy/dt")
CYRILLIC_AXES = str.maketrans("хХуУоО", "xXyYoO")
ARROWS = str.maketrans(dict.fromkeys("→⟶⇒➔➝>-–—−=", " "))
