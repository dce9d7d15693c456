"""A figure on paper: the same SVG with its own style sheet, black ink, dashes kept, fills of six per cent grey."""

from __future__ import annotations

from functools import cache

INK, GREY, FILL = "#000", "#555", "#f0f0f0"
STROKES: dict[str, tuple[str, float, str]] = {  # colour, width, dashes
    "f-link": (INK, 3, ""), "f-thick": (INK, 2, ""), "f-pos": (INK, 2, ""), "f-vel": (INK, 2, ""),
    "f-acc": (INK, 2, ""), "f-load": (INK, 2, ""), "f-loadthin": (INK, 1, ""), "f-thin": (GREY, 1, ""),
    "f-hatch": (INK, 1, ""), "f-axis": (GREY, 1, "14 3 2 3"), "f-hid": (GREY, 1, "5 3"), "f-grid": ("#ccc", 1, ""),
    "f-ord": ("#bbb", 1, ""), "f-ghost": (GREY, 2, "6 4"), "f-1": (INK, 1, ""), "f-sel": (INK, 1, ""),
}  # fmt: skip
FILLED = {"f-o": "#fff", "f-body": FILL, "f-handle": "#fff", "f-ghost-o": "#fff"}
HEADS = ("h-pos", "h-vel", "h-acc", "h-load", "h-ink", "h-thin")
SERIF = "Libertinus Serif"


def on_paper(svg: str) -> str:
    """Give a figure that stands alone: its style sheet inside, its size from its view box."""
    opening, _, rest = svg.partition(">")
    box = opening.partition('viewBox="')[2].partition('"')[0].split()
    size = f' width="{box[2]}" height="{box[3]}"' if len(box) == 4 and " width=" not in opening else ""
    space = "" if "xmlns=" in opening else ' xmlns="http://www.w3.org/2000/svg"'
    return f"{opening}{space}{size}><style>{_sheet()}</style>{rest}"


@cache
def _sheet() -> str:
    rules = [
        f".{name}{{fill:none;stroke:{colour};stroke-width:{width:g};stroke-linejoin:round"
        + (f";stroke-dasharray:{dashes}" if dashes else "")
        + "}"
        for name, (colour, width, dashes) in STROKES.items()
    ]
    rules += [
        f".{name}{{fill:{fill};stroke:{INK};stroke-width:2;stroke-linejoin:round}}" for name, fill in FILLED.items()
    ]
    rules += [f".{name}{{fill:{INK}}}" for name in HEADS] + [f".f-area{{fill:{FILL}}}"]
    rules += [
        f"text{{font-family:{SERIF};font-style:italic;font-size:17px;fill:{INK}}}",
        f"text.n{{font-family:{SERIF};font-style:normal;font-size:14px}}",
        "text.r{font-style:normal}", ".s{font-size:12px}", ".up{font-style:normal}",
        ".halo{paint-order:stroke;stroke:#fff;stroke-width:5px}",
    ]  # fmt: skip
    return "".join(rules)
