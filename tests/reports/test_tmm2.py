"""The TMM-2 report: headings of the form, what it holds before and after grading, and what it never holds."""

from __future__ import annotations

import io
import re
import zipfile

import docx
import pytest

from exercises import catalogue, variants
from exercises.exercise import Submission
from exercises.grading import grade, reference
from exercises.presenting import presented
from exercises.solving import solved
from reports import formats
from reports.document import Beside, Document, Drawing, Formula, Heading, Paragraph, Ruled, Table, plain
from reports.formulas import latex, omml, typst
from reports.tmm2 import HandedIn, NoReport, Person, tmm2
from reports.typst import source

POLISH = [  # the form, domain RP-1
    "1. Dane studenta:",
    "2. Grupa:",
    "3. Ocena:",
    "4. Cel ćwiczenia:",
    "5. Schemat manipulatora oraz rysunek wieloboku wektorowego.",
    "6. Dane manipulatora:",
    "7. Równanie wieloboku wektorowego (2.1):",
    "8. Równania rzutów wieloboku wektorowego na osie XY układu współrzędnych (2.2-2.4):",
    "9. Wyznaczenie parametrów położenia członów i węzłów kinematycznych manipulatora:",
    "10. Różniczkowanie równań rzutów wieloboku wektorowego (2.5, 2.6):",
    "11. Wyznaczenie prędkości i przyspieszeń ogniw i węzłów kinematycznych manipulatora:",
    "12. Podanie zależności opisujących prędkość i przyspieszenie chwytaka manipulatora:",
    "13. Wnioski wynikające z obserwacji ruchu mechanizmu (zmiany parametrów geometrycznych manipulatora)",
]
LABORATORIES = [name for name in catalogue.ids() if catalogue.load(name).exercise.report]
HOSTILE = '"] #read("/etc/passwd") \\" $x$ <b> *a* {{ }} \u202e \x01 😀 漢字'


def report(exercise: str = "tmm2_oop", language: str = "pl", handed: HandedIn | None = None, **person: str) -> Document:
    variant = variants.deal(exercise, 7)
    return tmm2(variant, language, Person(**person), "7", handed)


def filled(exercise: str = "tmm2_oop", language: str = "pl", **changed: str) -> Document:
    variant = variants.deal(exercise, 7)
    answers = reference(variant) | changed
    found = grade(Submission(variant, answers))
    outcomes = {name: str(verdict.outcome) for name, verdict in found.verdicts.items()}
    return report(exercise, language, HandedIn(answers, outcomes, "R-77", "2026-11-28", "ab12cd34", found.score))


def texts(document: Document) -> str:
    """Everything that can be read in a document."""
    found = []
    for block in document.blocks:
        match block:
            case Heading(text=text):
                found.append(text)
            case Paragraph(line=line, aside=aside):
                found.append(f"{plain(line)} {aside}".strip())
            case Table(rows=rows):
                found += [plain(cell) for row in rows for cell in row]
            case _:
                pass
    return "\n".join(found)


def formulas(document: Document) -> list[str]:
    """The formulas in the lines of a document."""
    lines = [block.line for block in document.blocks if isinstance(block, Paragraph)]
    return [run.mathml for line in lines for run in line if isinstance(run, Formula)]


def test_the_polish_headings_are_those_of_the_form() -> None:
    assert [block.text for block in report().blocks if isinstance(block, Heading)] == POLISH


@pytest.mark.parametrize("language", ["pl", "en", "ru"])
@pytest.mark.parametrize("exercise", LABORATORIES)
def test_the_skeleton_holds_data_scheme_and_room_to_write(exercise: str, language: str) -> None:
    made = report(exercise, language, name="Łucja Żak", group="M2-31")
    assert [block.text.split(".")[0] for block in made.blocks if isinstance(block, Heading)] == [
        str(n) for n in range(1, 14)
    ]
    assert "Łucja Żak" in texts(made) and "M2-31" in texts(made)
    assert sum(isinstance(block, Drawing) for block in made.blocks) == 1
    assert sum(isinstance(block, Ruled) for block in made.blocks) == 10  # mark, aim, polygon, 7 to 13


@pytest.mark.parametrize("exercise", LABORATORIES)
def test_no_reference_value_stands_in_a_skeleton(exercise: str) -> None:
    variant = variants.deal(exercise, 7)
    values = solved(variant).values
    numbers = {f"{value:.4g}".lstrip("-") for name, value in values.items() if isinstance(value, float)}
    given = {f"{abs(v):.4g}" for v in vars_of(variant.givens)}
    written = formats.written(report(exercise), "typ").decode().replace(",", ".")
    sought = {number for number in numbers - given if len(number.replace(".", "")) >= 4}
    assert sought and not {number for number in sought if number in written}


def vars_of(givens: object) -> list[float]:
    found = [getattr(givens, name) for name in getattr(givens, "__dataclass_fields__", {})]
    return [value for value in found if isinstance(value, float)]


def test_a_filled_report_holds_the_students_own_answers_and_the_receipt() -> None:
    said = texts(filled(conclusions="Podwojenie długości zwiększa prędkość."))
    assert "Podwojenie długości zwiększa prędkość." in said and "u prowadzącego" in said and "dobrze" in said
    (beside,) = [block for block in filled().blocks if isinstance(block, Beside)]
    assert len(beside.drawings) == 2  # scheme and polygon
    assert sum(isinstance(block, Drawing) for block in filled().blocks) == 2  # plots of x and y
    assert not any(isinstance(block, Ruled) and block.squared for block in filled().blocks)


@pytest.mark.parametrize("exercise", LABORATORIES)
def test_every_laboratory_draws_the_students_own_polygon(exercise: str) -> None:
    (beside,) = [block for block in filled(exercise).blocks if isinstance(block, Beside)]
    names = re.findall(r"<desc[^>]*>(.*)</desc>", beside.drawings[1].svg)
    assert "l1: A → B" in names[0] and "l2: B → C" in names[0]
    assert not any(isinstance(block, Ruled) and block.squared for block in filled(exercise).blocks)


def test_an_answer_that_was_not_given_or_not_read_is_said_so() -> None:
    said = texts(filled(x_D="", y_D="3 +* ("))
    assert "brak odpowiedzi" in said and "3 +* (" in said and "nie odczytano" in said


def test_a_heading_that_asks_is_not_said_again() -> None:
    assert "Wyznaczyć ruch chwytaka." in texts(filled(aim="Wyznaczyć ruch chwytaka."))
    lines = [plain(b.line) for b in filled(aim="Wyznaczyć ruch.").blocks if isinstance(b, Paragraph)]
    assert "Wyznaczyć ruch." in lines and not any(line.startswith("Cel ćwiczenia") for line in lines)


def test_a_vector_is_written_in_the_equation_as_in_its_line() -> None:
    assert any("<msub><mi>r</mi><mi>x</mi></msub>" in one and "<mi>l</mi>" in one for one in formulas(filled()))


@pytest.mark.parametrize("language", ["pl", "en", "ru"])
@pytest.mark.parametrize("exercise", LABORATORIES)
def test_a_skeleton_fills_four_pages(exercise: str, language: str) -> None:
    content = formats.written(report(exercise, language=language), "pdf")
    assert int(re.search(rb"/Count (\d+)", content)[1]) == 4  # type: ignore[index]


def test_how_an_answer_was_judged_stands_at_the_end_of_its_last_line() -> None:
    assert "columns: (1fr, auto)" in formats.written(filled(), "typ").decode()


def test_an_unreadable_polygon_leaves_the_room_to_draw_it() -> None:
    assert any(isinstance(block, Ruled) and block.squared for block in filled(polygon="closure: ?").blocks)


def test_an_exercise_without_a_report_is_refused() -> None:
    with pytest.raises(NoReport):
        report("simple_beam")


@pytest.mark.parametrize("kind", formats.FORMATS)
@pytest.mark.parametrize("made", [report, filled], ids=["skeleton", "filled"])
def test_the_same_report_is_the_same_bytes(kind: str, made: object) -> None:
    make = report if made is report else filled
    assert formats.written(make(), kind) == formats.written(make(), kind)


def test_the_pdf_is_tagged_speaks_its_language_and_embeds_its_fonts() -> None:
    content = formats.written(report(), "pdf")
    assert content.startswith(b"%PDF-") and b"/StructTreeRoot" in content and b"/Lang" in content
    assert b"pdfuaid" in content and b"/FontFile" in content


def test_the_docx_has_headings_equations_and_pictures_with_words() -> None:
    content = formats.written(filled(), "docx")
    word = docx.Document(io.BytesIO(content))
    heads = [p.text for p in word.paragraphs if p.style is not None and p.style.name == "Heading 1"]
    assert heads[:13] == POLISH
    xml = zipfile.ZipFile(io.BytesIO(content)).read("word/document.xml").decode()
    assert xml.count("<m:oMath") > 20 and re.search(r'descr="[^"]+"', xml)
    looks = zipfile.ZipFile(io.BytesIO(content)).read("word/styles.xml").decode()
    for name in ("Title", "Heading1"):
        style = looks[looks.index(f'w:styleId="{name}"') :].split("</w:style>")[0]
        assert "Theme" not in style and "w:color" not in style and "Times New Roman" in style


def test_each_ruled_line_of_a_docx_is_drawn() -> None:
    """Paragraphs with the same border below count as one block: a line between them has to be asked for."""
    xml = zipfile.ZipFile(io.BytesIO(formats.written(report(), "docx"))).read("word/document.xml").decode()
    assert xml.count("<w:between ") == xml.count("<w:bottom ") > 40


def test_a_long_sum_of_a_docx_can_break_before_its_terms() -> None:
    from reports.formulas import omml

    longest = max(formulas(filled()), key=len)
    assert len(omml.pieces(longest)) > 3 and omml.pieces("<math><mi>a</mi><mo>+</mo><mi>b</mi></math>") == [
        omml.formula("<math><mi>a</mi><mo>+</mo><mi>b</mi></math>")
    ]
    assert all(re.findall(r"<m:t[^>]*>(.*?)</m:t>", piece)[0] in "+−" for piece in omml.pieces(longest)[1:])


@pytest.mark.parametrize("language", ["pl", "en", "ru"])
def test_markdown_keeps_headings_and_formulas(language: str) -> None:
    written = formats.written(filled(language=language), "md").decode()
    for block in filled(language=language).blocks:
        if isinstance(block, Heading):
            assert f"## {block.text}" in written
    assert r"\sin" in written and r"\dot{" in written


@pytest.mark.parametrize("kind", formats.FORMATS)
def test_what_a_student_writes_is_never_markup(kind: str) -> None:
    made = report(name=HOSTILE, group=HOSTILE, handed=HandedIn({"conclusions": HOSTILE, "aim": HOSTILE}))
    content = formats.written(made, kind)
    assert b"root:" not in content and len(content) > 1000


def test_every_formula_of_a_report_can_be_written_in_every_notation() -> None:
    formulas = [
        run
        for block in filled().blocks
        if isinstance(block, Paragraph)
        for run in block.line
        if isinstance(run, Formula)
    ]
    assert len(formulas) > 20
    for formula in formulas:
        assert typst.formula(formula.mathml) and latex.formula(formula.mathml)
        assert omml.formula(formula.mathml).startswith("<m:oMath")


def test_what_is_constant_among_students_stands_under_constant_settings() -> None:
    """The engine keeps the layout of a block only while the settings above it stay, so no name stands in them."""
    documents = [tmm2(variants.deal("tmm2_oop", 7), "pl", Person(name), name) for name in ("Anna", "Jan")]
    one, other = (source(document).partition("#metadata") for document in documents)
    assert one[0] == other[0] and one[2] != other[2]
    drawn = [next(block for block in document.blocks if isinstance(block, Drawing)) for document in documents]
    assert drawn[0].svg is drawn[1].svg


def test_a_sum_of_a_pdf_breaks_between_its_terms_and_a_long_product_where_it_must() -> None:
    dot = "<mo>·</mo>"
    short = typst.formula(f"<math><mi>a</mi>{dot}<mi>b</mi><mo>+</mo><mi>c</mi>{dot}<mi>d</mi></math>")
    long = typst.formula(f"<math>{dot.join(['<mi>a</mi>'] * 40)}</math>")
    assert short == 'a thin class("normal", dot.op) thin b + c thin class("normal", dot.op) thin d'
    assert "class" not in long and long.count("dot.op") == 39


def test_a_formula_of_a_note_is_as_small_as_the_note() -> None:
    assert "math.equation: set text" not in source(report())


def test_each_given_stands_with_its_name_symbol_and_value() -> None:
    (table,) = (block for block in report("tmm2_oop", "en").blocks if isinstance(block, Table))
    cells = [plain(cell) for row in table.rows for cell in row]
    given = presented(variants.deal("tmm2_oop", 7), "en").givens
    assert [cell.rpartition(" = ")[2] for cell in cells if cell] == [value for _, value in given]
    assert cells[0].startswith("length of the link AB: ") and cells[6].startswith("first derivative of ")
