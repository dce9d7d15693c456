"""Task sheets and keys: one sheet a variant with its code, the same numbers as online, the key apart."""

from __future__ import annotations

import json
import re

import pytest
import typst

from exercises import catalogue, variants
from exercises.exercise import Variant
from exercises.grading import reference
from exercises.presenting import presented
from reports import formats, sheets
from reports.document import Break, Bullets, Document, Drawing, Facts, Formula, Heading, Paragraph, from_html, plain
from reports.formulas.typst import formula
from reports.typst import WRITERS


def dealt(exercise: str, count: int = 3) -> list[tuple[str, Variant]]:
    return [(f"K{seed}", variants.deal(exercise, seed)) for seed in range(count)]


def printed(exercise: str, count: int, language: str) -> list[sheets.Sheet]:
    return [sheets.sheet(code, variant, language) for code, variant in dealt(exercise, count)]


def facts(document: Document) -> list[str]:
    return [value for block in document.blocks if isinstance(block, Facts) for _, value in block.pairs]


@pytest.mark.parametrize("exercise", catalogue.ids())
@pytest.mark.parametrize("language", ["pl", "ru"])
def test_every_exercise_can_be_printed(exercise: str, language: str) -> None:
    made = sheets.sheets(printed(exercise, 1, language), language)
    assert any(isinstance(block, Drawing) for block in made.blocks)
    assert formats.written(made, "pdf").startswith(b"%PDF-")


def test_each_sheet_has_its_code_its_place_and_the_numbers_of_its_variant() -> None:
    made = sheets.sheets(printed("slider_crank", 3, "pl"), "pl")
    assert [value for value in facts(made) if value] == ["K0, 1 z 3", "K1, 2 z 3", "K2, 3 z 3"]
    assert sum(isinstance(block, Break) for block in made.blocks) == 2
    for _, variant in dealt("slider_crank"):
        for block in from_html(presented(variant, "pl").statement_html):
            assert block in made.blocks


def test_the_key_is_a_document_of_its_own_with_answers_that_are_right() -> None:
    made = sheets.key(printed("gear_train", 2, "en"), "en")
    assert [block.text for block in made.blocks if isinstance(block, Heading)] == ["Variant K0", "Variant K1"]
    written = formats.written(made, "typ").decode()
    for _, variant in dealt("gear_train", 2):
        for number in re.findall(r"\d+\.\d+", " ".join(reference(variant).values())):
            assert f"{float(number):.5g}" in written


@pytest.mark.parametrize("exercise", ["simple_beam", "rrr_matrices", "tmm2_oop"])
def test_no_reference_stands_on_a_sheet(exercise: str) -> None:
    written = formats.written(sheets.sheets(printed(exercise, 2, "en"), "en"), "typ").decode()
    for _, variant in dealt(exercise, 2):
        numbers = [number for text in reference(variant).values() for number in re.findall(r"\d+\.\d{4,}", text)]
        assert numbers and not [number for number in numbers if number in written]


def test_a_prompt_stands_with_its_unit_before_the_room_to_answer() -> None:
    made = sheets.sheets(printed("slider_crank", 1, "en"), "en")
    asked = presented(variants.deal("slider_crank", 0), "en").answers["l3"]
    assert any(isinstance(b, Paragraph) and plain(b.line).endswith(f"[{asked.unit_text}]") for b in made.blocks)


@pytest.mark.parametrize("language", ["pl", "en", "ru"])
def test_a_unit_that_a_prompt_says_is_not_said_again(language: str) -> None:
    made = sheets.sheets(printed("beam_diagrams", 1, language), language)
    asked = [plain(b.line) for b in made.blocks if isinstance(b, Paragraph) and re.match(r"\d\. ", plain(b.line))]
    assert [line.count("[") for line in asked] == [1, 1, 0, 0]


@pytest.mark.parametrize(
    ("language", "expected"),
    [
        ("pl", ["12,8\u202fkN", "0 … 0,8: 12,8"]),
        ("en", ["12.8\u202fkN", "0 … 0.8: 12.8"]),
        ("ru", ["12,8\u202fкН", "0 … 0,8: 12,8"]),
    ],
)
def test_a_key_writes_numbers_and_units_of_its_language(language: str, expected: list[str]) -> None:
    variant = variants.deal("beam_diagrams", 4)
    assert all(one in answers_of(sheets.sheet("K", variant, language), language) for one in expected)


def test_a_key_names_choices_by_their_words_and_sets_formulas() -> None:
    said = answers_of(sheets.sheet("K", variants.deal("gear_train", 4), "pl"), "pl")
    assert "w tę samą stronę co wał wejściowy" in said and "obr/min" in said
    assert not re.search(r"same|rpm|\*|\d\.\d", said)


def test_a_key_holds_a_cycle_in_a_few_rows_without_what_rounding_leaves() -> None:
    said = answers_of(sheets.sheet("K", variants.deal("slider_crank_cycle", 4), "pl"), "pl")
    assert 10 < said.count(" | ") <= 14 and "e-1" not in said and "·10" not in said


def answers_of(printed: sheets.Sheet, language: str) -> str:
    """What a key says of a variant."""
    (listed,) = [block for block in sheets.key([printed], language).blocks if isinstance(block, Bullets)]
    return "\n".join(map(plain, listed.lines))


def test_matrices_in_the_lines_of_a_key_do_not_stand_over_one_another() -> None:
    row = f"<mtr>{'<mtd><mn>0,5</mn></mtd>' * 4}</mtr>"
    matrix = Formula(f"<math><mrow><mo>[</mo><mtable>{row * 4}</mtable><mo>]</mo></mrow></math>")
    lines = [WRITERS[Bullets](Bullets((("A: ", matrix),) * count, True)) for count in (1, 2)]
    alone = f"#math.equation(block: true, ${formula(matrix.mathml)}$)"
    one, two, whole = heights(*lines, alone)
    assert two - one > 0.9 * whole


def heights(*contents: str) -> list[float]:
    """How high contents are in a document, in points."""
    measured = "\n".join(f"[#metadata(measure([{content}]).height.pt()) <height>]" for content in contents)
    made = f"#set text(size: 11pt)\n#set par(leading: 0.65em)\n#context {{\n{measured}\n}}"
    return [float(one) for one in json.loads(typst.query(made.encode(), "<height>", field="value"))]


@pytest.mark.parametrize(
    ("mathml", "said"),
    [
        ("<mtable><mtr><mtd>1,5</mtd><mtd>0</mtd></mtr><mtr><mtd>a</mtd><mtd>2</mtd></mtr></mtable>", "1,5; 0 | a; 2"),
        ("<mfrac><mrow><mi>a</mi><mo>+</mo><mi>b</mi></mrow><mn>2</mn></mfrac>", "(a+b)/2"),
        ("<msubsup><mi>ω</mi><mn>1</mn><mn>2</mn></msubsup><msup><mi>x</mi><mn>3</mn></msup>", "ω1^2x^3"),
        ("<msqrt><mi>a</mi><mo>+</mo><mi>b</mi></msqrt>", "√(a+b)"),
    ],
)
def test_a_formula_is_spoken_so_that_its_parts_can_be_told_apart(mathml: str, said: str) -> None:
    assert Formula(f"<math>{mathml}</math>").spoken == said


def test_a_prompt_stays_on_the_page_of_its_room() -> None:
    made = formats.written(sheets.sheets(printed("slider_crank", 1, "en"), "en"), "typ").decode()
    assert made.count("sticky: true") == len(presented(variants.deal("slider_crank", 0), "en").answers)
