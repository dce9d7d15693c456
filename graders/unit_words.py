"""Units in words, as they stand behind a number in Polish, English and Russian, and the symbols they mean."""

from __future__ import annotations

from collections.abc import Iterator

FORMS = {
    "m": "metre metres meter meters metr metra metry metrów метр метра метры метров",
    "g": "gram grams grama gramy gramów грамм грамма граммы граммов",
    "s": "second seconds sekunda sekundy sekundę sekund секунда секунды секунду секунд",
    "N": "newton newtons niuton niutona niutony niutonów ньютон ньютона ньютоны ньютонов",
    "N*m": "niutonometr niutonometra niutonometry niutonometrów ньютонометр ньютонометра ньютонометров",
    "Pa": "pascal pascals paskal paskala paskale paskali паскаль паскаля паскали паскалей",
    "J": "joule joules dżul dżula dżule dżuli джоуль джоуля джоули джоулей",
    "W": "watt watts wat wata waty watów ватт ватта ватты",
}
WHOLE = {
    "rad": "radian radians radiana radiany radianów радиан радиана радианы радианов",
    "min": "minute minutes minuta minuty minutę minut минута минуты минуту минут",
    "h": "hour hours godzina godziny godzinę godzin час часа часов",
    "rev": "revolution revolutions turns obrót obrotu obroty obrotów оборот оборота обороты оборотов",
}
PREFIXES = {
    "": "", "k": "kilo кило", "M": "mega мега", "G": "giga гига", "c": "centi centy санти", "d": "deci decy деци",
    "m": "milli mili милли", "μ": "micro mikro микро",
}  # fmt: skip
PER = frozenset(("per", "na", "в", "на"))


def words() -> Iterator[tuple[str, str]]:
    """Give each word with the symbol of its unit: `milimetrów` is mm, `kiloniutonometr` kN*m."""
    for symbol, forms in FORMS.items():
        for prefix, spelt in PREFIXES.items():
            for front in spelt.split() or [""]:
                yield from ((front + form, prefix + symbol) for form in forms.split())
    for symbol, forms in WHOLE.items():
        yield from ((form, symbol) for form in forms.split())
