"""What the documents promise can be done as written, and their links lead somewhere."""

from __future__ import annotations

import json
import re
import shlex
import tomllib
from pathlib import Path

import pytest

from cli.main import COMMANDS, parser
from exercises import catalogue
from tests.cli.calling import ROOT, run

DOCS = ROOT / "docs"
PAGES = sorted([*ROOT.glob("*.md"), *DOCS.rglob("*.md")])
EXAMPLES = DOCS / "examples"
TUTORIAL = (DOCS / "tutorial.md").read_text("utf-8")
ROOMS = ("cli", "server", "reports", "exercises", "graders", "mechanics", "figures")
HOUSE = ("tests", "docs", "benchmarks", "deploy", "changelog.d")
MADE = {"deploy/.env", "tests/spellings/de.toml", "server/static/build/"}  # by who follows the page, or at a build


def blocks(text: str, language: str) -> list[str]:
    """Give the fenced blocks of a page in one language."""
    fenced = re.findall(r"^```(\w*)\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)
    return [body for tag, body in fenced if tag == language]


def named(page: Path) -> str:
    return str(page.relative_to(ROOT))


@pytest.mark.parametrize("page", PAGES, ids=named)
def test_each_link_leads_to_a_file(page: Path) -> None:
    links = [link.partition("#")[0] for link in re.findall(r"\]\(([^)\s]+)\)", page.read_text("utf-8"))]
    gone = [link for link in links if link and "://" not in link and not (page.parent / link).exists()]
    assert gone == []


@pytest.mark.parametrize("page", PAGES, ids=named)
def test_each_path_that_is_named_exists(page: Path) -> None:
    places = re.findall(rf"`((?:{'|'.join((*ROOMS, *HOUSE))})/[^`\s]*)`", page.read_text("utf-8"))
    plain = [place for place in places if re.fullmatch(r"[\w./-]+", place) and place not in MADE]
    assert [place for place in plain if not (ROOT / place).exists()] == []


def commands() -> list[tuple[str, list[str]]]:
    """Every `grubler …` line of a shell block, with the page it stands on."""
    found = []
    for page in PAGES:
        for block in blocks(page.read_text("utf-8"), "sh"):
            for line in block.replace("\\\n", " ").splitlines():
                words = shlex.split(line.partition(">")[0], comments=True)
                at = next((i for i, word in enumerate(words) if word == "grubler" and words[i + 1 : i + 2]), None)
                if at is not None and words[at + 1] in COMMANDS:
                    found.append((named(page), words[at + 1 :]))
    return found


def test_the_commands_that_are_shown_exist() -> None:
    shown = commands()
    assert {"serve", "draw", "grade", "verify", "new"} <= {words[0] for _, words in shown}
    for page, words in shown:
        assert parser([words[0]]).parse_args(words), page


def test_the_tutorial_grades_its_own_answers_as_it_says(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    (answers,) = blocks(TUTORIAL, "json")
    assert json.loads(answers) == json.loads((EXAMPLES / "answers.json").read_text("utf-8"))
    Path("answers.json").write_text(answers, "utf-8")
    code, out, err = run(capsys, "grade", "answers.json")
    assert (code, err) == (0, "") and out in blocks(TUTORIAL, "")
    Path("answers.json").write_text(answers.replace('"2.4976 rad/s"', '"-2.4976 rad/s"'), "utf-8")
    code, out, _ = run(capsys, "grade", "answers.json")
    assert code == 0 and "answers.json: 80 %" in out and "the sign is opposite" in out


@pytest.mark.parametrize("kind", ["Answers", "Tasks"])
def test_the_files_that_are_shown_can_be_read(kind: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    page = (DOCS / "reference" / "files.md").read_text("utf-8")
    shown = blocks(page.partition(f"## {kind}")[2], "json")[0]
    (tmp_path / "shown.json").write_text(shown, "utf-8")
    answers = str(tmp_path / "shown.json" if kind == "Answers" else EXAMPLES / "answers.json")
    tasks = str(EXAMPLES / "tasks.json" if kind == "Answers" else tmp_path / "shown.json")
    assert run(capsys, "grade", answers, "--tasks", tasks, "--pass", "0.4")[0] == 0


def test_the_result_that_is_shown_has_the_fields_of_a_result(capsys: pytest.CaptureFixture[str]) -> None:
    page = (DOCS / "reference" / "files.md").read_text("utf-8")
    shown = json.loads(blocks(page.partition("## The result")[2], "json")[0])
    result = json.loads(run(capsys, "grade", str(EXAMPLES / "answers.json"), "--format", "json")[1])
    assert shown.keys() == result.keys() and shown["grader_version"] == result["grader_version"]
    assert shown["files"][0].keys() == result["files"][0].keys()
    assert shown["files"][0]["items"][0].keys() == result["files"][0]["items"][0].keys()
    verdicts = (document["files"][0]["items"][0]["verdicts"]["l3"] for document in (shown, result))
    assert next(verdicts) == next(verdicts)


def test_the_readme_names_its_two_commands_and_every_room() -> None:
    readme = (ROOT / "README.md").read_text("utf-8")
    assert readme.index("pip install uv") < readme.index("uv run grubler serve") < readme.index("uv run pytest")
    assert all(f"| `{room}/` |" in readme for room in ROOMS)


def test_the_readme_leads_to_every_page() -> None:
    readme = (ROOT / "README.md").read_text("utf-8")
    pages = [page for page in DOCS.rglob("*.md") if page.parent.name != "decisions"]
    assert [named(page) for page in pages if f"({named(page)})" not in readme] == []


def test_the_guide_to_servers_has_a_row_for_each_variable_that_is_read() -> None:
    sources = [path.read_text("utf-8") for room in ("cli", "server") for path in sorted((ROOT / room).rglob("*.py"))]
    read = set(re.findall(r'"(GRUBLER_[A-Z_]+|DATABASE_URL)"', "\n".join(sources)))
    guide = (DOCS / "how-to" / "run-a-server.md").read_text("utf-8")
    rows = re.findall(r"^\| (`.*?) \|", guide, re.MULTILINE)
    assert len(read) > 10 and {name.strip("`") for row in rows for name in row.split(", ")} == read


def test_the_guide_to_institutions_gives_what_the_compose_file_asks_for() -> None:
    asked = set(re.findall(r"\$\{([A-Z_]+):\?", (ROOT / "deploy" / "compose.yaml").read_text("utf-8")))
    (given,) = [block for block in blocks((DOCS / "how-to" / "scale.md").read_text("utf-8"), "") if "GRUBLER" in block]
    assert asked and {line.partition("=")[0] for line in given.splitlines()} == asked


def test_the_guide_to_exercises_describes_the_files_of_a_folder() -> None:
    guide = (DOCS / "how-to" / "write-an-exercise.md").read_text("utf-8")
    assert all(f"`{name}`" in guide for name in (*catalogue.FILES, "figure.py"))


def test_each_decision_is_listed_and_says_why() -> None:
    pages = sorted((DOCS / "decisions").glob("0*.md"))
    index = (DOCS / "decisions" / "README.md").read_text("utf-8")
    assert [page.name[:4] for page in pages] == [f"{number:04}" for number in range(1, len(pages) + 1)]
    for page in pages:
        text = page.read_text("utf-8")
        assert page.name in index
        assert all(f"**{part}.**" in text for part in ("Context", "Decision", "Alternatives", "Consequences"))


def test_the_guide_to_courses_calls_everything_as_the_pages_do() -> None:
    words = tomllib.loads((ROOT / "server" / "locales" / "en.toml").read_text("utf-8"))
    shown = {text for part in words.values() for text in part.values()}
    guide = (DOCS / "how-to" / "run-a-course.md").read_text("utf-8").split("## Before the term")[1]
    named = [" ".join(name.split()) for name in re.findall(r"\*([^*]+)\*", guide)]
    assert len(named) > 15
    assert [name for name in named if not any(text == name or text.startswith(f"{name} to {{") for text in shown)] == []
