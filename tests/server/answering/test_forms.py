"""A matrix typed into a grid is the same text as one typed in a line."""

from __future__ import annotations

from dataclasses import replace

from hypothesis import given
from hypothesis import strategies as st

from exercises.presenting import Field
from graders import Matrix
from graders.language.symbols import Symbols
from server.answering.forms import Form, apart, cell_names, join, split

ENTRIES = st.from_regex(r"-?[0-9]{1,3}(,[0-9]{1,2})?", fullmatch=True)


def matrix(rows: int, columns: int) -> Field:
    return Field("T", "matrix", "", "", "", "", "", (), "", None, None, rows, columns, (), (), 1.0)


@st.composite
def grids(draw: st.DrawFn) -> list[list[str]]:
    shapes = [(rows, columns) for rows in range(1, 5) for columns in range(1, 5) if rows * columns > 1]
    rows, columns = draw(st.sampled_from(shapes))
    return [[draw(ENTRIES) for _ in range(columns)] for _ in range(rows)]


@given(grids())
def test_a_grid_is_read_back_from_its_text(cells: list[list[str]]) -> None:
    assert split(join(cells), len(cells), len(cells[0])) == cells


@given(grids())
def test_a_grid_with_decimal_commas_is_the_matrix_it_shows(cells: list[list[str]]) -> None:
    read = Matrix(len(cells), len(cells[0])).parse(join(cells), Symbols(()))
    shown = tuple(tuple(float(entry.replace(",", ".")) for entry in row) for row in cells)
    assert read.rows == shown


@given(st.text(max_size=60), st.integers(1, 4), st.integers(1, 4))
def test_another_text_is_shown_as_text_or_says_exactly_the_same(text: str, rows: int, columns: int) -> None:
    cells = split(text, rows, columns)
    assert cells is None or join(cells) == text


def test_an_empty_grid_is_an_empty_answer() -> None:
    assert join([["", " "], ["", ""]]) == ""


def form(values: dict[str, str]) -> Form:
    return Form(values, {name: [text] for name, text in values.items()}, b"")


def test_the_text_twin_goes_before_the_grid() -> None:
    field = matrix(1, 2)
    names = cell_names(field)
    assert names == [["answer.T.1.1", "answer.T.1.2"]]
    values = {"answer.T": " ", "answer.T.1.1": "1", "answer.T.1.2": "2"}
    assert form(values).answer(field) == "[[1; 2]]"
    assert form(values | {"answer.T": "[3, 4]"}).answer(field) == "[3, 4]"
    assert form({}).answer(field) == ""


def test_a_table_is_typed_row_by_row_and_read_back() -> None:
    field = replace(matrix(0, 0), kind="diagram")
    values = {"answer.T.1.1": "0", "answer.T.1.3": "4,5", "answer.T.3.1": "2", "answer.T.3.2": "-1"}
    text = form(values).answer(field)
    assert text == "0; ; 4,5\n2; -1"
    cells = apart(field, text)
    assert cells is not None and len(cells) == 12 and cells[:2] == [["0", "", "4,5", ""], ["2", "-1", "", ""]]
    assert apart(field, "0 .. 2: 4*x") is None and apart(field, "0; 1\n" * 12 + "2; 3") is None


def test_all_boxes_that_are_ticked_are_the_answer() -> None:
    field = replace(matrix(0, 0), kind="choices")
    assert Form({"answer.T": "c"}, {"answer.T": ["a", "c"]}, b"").answer(field) == "a; c"
