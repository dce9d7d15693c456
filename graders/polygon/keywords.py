"""The words of a polygon in Polish, English and Russian, and what is only there for good style."""

from __future__ import annotations

LENGTH = frozenset("length len długość dlugosc długości dł dl długością длина длины длиной".split())
ANGLE = frozenset("angle ang kąt kat kąta kątem kącie ∠ угол угла углом".split())
CLOSURE = frozenset(
    "closure closed polygon loop sum vectors wielobok zamknięcie zamkniecie zamknięcia suma równanie rownanie równania "
    "closes контур замыкание замыкания замкнутость замкнутости многоугольник уравнение сумма".split()
)
UNKNOWNS = frozenset(
    "unknowns unknown sought niewiadome niewiadoma szukane szukana nieznane неизвестные неизвестное неизвестная "
    "неизвестный искомые искомая".split()
)
CONSTANT = frozenset(
    "constant const fixed stała stały stałe stałą stala staly stale постоянная постоянный постоянно постоянна "
    "const".split()
)
KNOWN = frozenset("known given dana dany dane dan znana znany znane дан дана известна известен известная заданная заданный "
                  "известный variable zmienna zmienny переменная переменный".split())  # fmt: skip
SOUGHT = frozenset(
    "unknown sought nieznana nieznany niewiadoma szukana szukany szukane неизвестна неизвестен неизвестная неизвестный "
    "искомая искомый".split()
)
FILLERS = frozenset("of o i and with at is the a from to z ze od do oraz из от в к до с и под pod equal =".split())
AXIS_FILLERS = frozenset(
    "projection proj on of the onto axis axes rzut rzuty na oś os osi проекция на ось оси equation równanie "
    "velocity velocities acceleration accelerations prędkości przyspieszenia скорости ускорения".split()
)
VECTOR_FILLERS = frozenset("vector wektor вектор".split())
RATES = frozenset("rates rate where gdzie pochodne oznaczenia где производные обозначения".split())

X = frozenset("x ox xd xdd dx ddx vx ax px x' x'' dx/dt".split())
Y = frozenset("y oy yd ydd dy ddy vy ay py y' y'' dy/dt".split())
CYRILLIC_AXES = str.maketrans("хХуУоО", "xXyYoO")
ARROWS = str.maketrans(dict.fromkeys("→⟶⇒➔➝>-–—−=", " "))
