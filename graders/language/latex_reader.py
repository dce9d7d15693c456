"""LaTeX as visual formula editors write it, rewritten in the answer language with the place of every character kept.

The reader knows the commands of the language and nothing else; what it writes goes through the same tokens and the
same tree as what is typed by hand.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import TypeVar

from graders.language.commands import ACCENTS, ENVIRONMENTS, FENCES, LETTERS, SIGNS, SPACES, UPRIGHT, WORDS
from graders.language.errors import AnswerSyntaxError, Reason
from graders.language.latex_sheet import Rewritten, Sheet
from graders.language.latex_source import Source, undollared

MAX_LATEX = 4000
MAX_WRITTEN = 2000  # characters of the answer language: no more is read
WORD = re.compile(r"[^\W\d_][^\W_]*")
MARKS = re.compile(r"[0-9 +\-*/=(),.]+")  # that mean themselves
INDICES = re.compile(r"(\d{1,2})[,;](\d{1,2})")
ENVIRONMENT = re.compile(r"\{([A-Za-z]{1,12})\}")
COLUMNS = re.compile(r"\{[lcr| ]{0,40}\}")
POWER_OF_TEN = re.compile(r"\^(?:\((-?\d{1,4})\)|(\d) )")
LITERAL = re.compile(r"(?:^|[^\w./,^ ]) {0,9}\d[\d.,]{0,60}$")
RIGHT = ("right", "mright", "bigr", "Bigr")
Read = TypeVar("Read")


def through(latex: str, read: Callable[[str], Read]) -> Read:
    """Read LaTeX by a reader of plain text; raises AnswerSyntaxError with the place in the LaTeX."""
    return kept(rewritten(latex), read)


def kept(plain: Rewritten, read: Callable[[str], Read]) -> Read:
    """Read what was rewritten; raises AnswerSyntaxError with the place in the LaTeX."""
    try:
        return read(plain.text)
    except AnswerSyntaxError as error:
        raise error.moved(plain.places[min(error.position, len(plain.places) - 1)]) from None


def rewritten(latex: str) -> Rewritten:
    """Rewrite LaTeX in the answer language; the last place is the end of the LaTeX.

    Raises:
        AnswerSyntaxError: An unknown command, an empty box, braces that do not match, a text that is too long.
    """
    if len(latex) > MAX_LATEX:
        raise AnswerSyntaxError(Reason.TOO_LONG, MAX_LATEX)
    reader = _Reader(undollared(latex))
    reader.sequence()
    if reader.at < len(latex):
        raise reader.error(Reason.EXTRA_BRACKET)
    return Rewritten(reader.sheet.text, (*reader.sheet.places, len(latex)))


@dataclass(slots=True)
class _Reader(Source):
    sheet: Sheet = field(default_factory=Sheet)

    def sequence(self, *ends: str) -> None:
        """Read up to the end, a closing brace, or one of some commands or marks."""
        self.deeper()
        while self.at < len(self.latex) and self.next() != "}":
            if ends and (self.ahead() or self.next()) in ends:
                break
            if len(self.sheet.out) > MAX_WRITTEN:
                raise AnswerSyntaxError(Reason.TOO_LONG, self.at)
            self.item()
        self.depth -= 1

    def item(self) -> None:
        char, place = self.next(), self.at
        if char == "\\":
            self.run(self.command(), place)
        elif char == "{":
            self.group(place)
        elif char == "^":
            self.superscript()
        elif char == "_":
            self.index(place)
        elif char.isalpha():
            self.word(place)
        else:
            marks = MARKS.match(self.latex, self.at)
            run = marks.group() if marks else char
            self.at += len(run)
            self.sheet.copy(" " if run == "~" else run, place)

    def group(self, place: int) -> None:
        """Braces group; around a mark they only keep it close: `3{,}5`."""
        inside = self.latex[self.at + 1 : self.at + 3]
        if inside in (",}", ".}", "=}", "<}", ">}"):
            decimal = inside == ",}" and self.latex[place - 1 : place].isdigit()
            self.at += 3
            self.sheet.write("." if decimal and self.next().isdigit() else inside[0], place)
            return
        self.sheet.write("(", place)
        self.braces()
        self.sheet.write(")", place)

    def braces(self) -> None:
        """Read what stands in braces; an empty pair is a box that was not filled."""
        opened = self.at
        self.at += 1
        inside = self.sheet.captured(self.sequence)
        if self.next() != "}":
            raise self.error(Reason.NEEDS_BRACKET, "}")
        self.at += 1
        if not inside.text.strip():
            raise self.error(Reason.EMPTY_BOX, "{}", opened)
        self.sheet.put(inside)

    def argument(self) -> None:
        """Read what a command applies to: a group without its braces, or one sign."""
        self.deeper()
        self.skip_spaces()
        place = self.at
        if self.next() == "{":
            self.braces()
        elif self.next() == "\\":
            self.run(self.command(), place)
        elif self.next() and self.next() not in "}&^_":
            self.at += 1
            self.sheet.write(self.latex[place], place)
        else:
            raise self.error(Reason.EMPTY_BOX)
        self.depth -= 1

    def captured(self) -> Rewritten:
        """Read an argument and give it."""
        return self.sheet.captured(self.argument)

    def run(self, command: str, place: int) -> None:
        """Carry out a command that has just been read."""
        if command in SPACES:
            self.sheet.write(" ", place)
        elif command in SIGNS:
            self.sheet.write(SIGNS[command], place)
            self.power_of_ten(command, place)
        elif command in LETTERS or command in WORDS:
            self.named(LETTERS.get(command) or WORDS[command], place)
        elif command in ACCENTS:
            self.dotted(command, place)
        elif command in UPRIGHT:
            self.upright(place)
        else:
            self.built(command, place)

    def built(self, command: str, place: int) -> None:
        if command in ("frac", "dfrac", "tfrac", "cfrac"):
            self.fraction(place)
        elif command == "sqrt":
            self.root(place)
        elif command in FENCES:
            self.fenced(place)
        elif command == "begin":
            self.matrix(place)
        elif command in ("placeholder", "square", "Box"):
            raise self.error(Reason.EMPTY_BOX, "\\" + command, place)
        elif command in (*RIGHT, "end", "\\"):
            raise self.error(Reason.EXTRA_BRACKET, "\\" + command, place)
        else:
            raise self.error(Reason.UNKNOWN_NAME, "\\" + command, place)

    def word(self, place: int) -> None:
        """Read a run of letters and figures; a subscript belongs to the last letter of the run."""
        found = WORD.match(self.latex, self.at)
        run = found.group() if found else self.next()
        self.at += len(run)
        scripted = self.next() != "" and self.next() in "_'"
        if not scripted:
            self.sheet.copy(run, place)
            return
        if run.isalpha() and len(run) > 1 and run not in LETTERS:
            self.sheet.write_word(run[:-1], place)
            run, place = run[-1], place + len(run) - 1
        self.named(run, place)

    def named(self, base: str, place: int, dots: str = "") -> None:
        """Write a name with its subscript, dots and primes, in whatever order the scripts come; a power follows."""
        below, primes, power = "", "", None
        while self.next() and self.next() in "_'^":
            if self.next() == "_" and not below:
                self.at += 1
                below = self.subscript()
            elif self.next() == "'":
                self.at += 1
                primes += "'"
            elif self.next() == "^" and power is None:
                mark = self.sheet.captured(self.superscript)
                primes, power = (primes + mark.text, None) if set(mark.text) == {"'"} else (primes, mark)
            else:
                break
        indices = INDICES.fullmatch(below)
        script = "_" + below if below and not indices else ""
        self.sheet.write_word(base + script + dots + primes, place)
        if indices:
            self.sheet.write(f"[{indices[1]};{indices[2]}]", place)
        if power is not None:
            self.sheet.put(power)

    def subscript(self) -> str:
        """Read a subscript as letters and figures, or as the two indices of an entry."""
        place = self.at
        text = re.sub(r"[\s_]", "", self.captured().text)
        if not text.isalnum() and not INDICES.fullmatch(text):
            raise self.error(Reason.BAD_CHARACTER, text[:12], place)
        return text

    def index(self, place: int) -> None:
        """Read the indices of an entry behind a bracket."""
        self.at += 1
        indices = INDICES.fullmatch(self.subscript())
        if indices is None:
            raise self.error(Reason.BAD_CHARACTER, "_", place)
        self.sheet.write(f"[{indices[1]};{indices[2]}]", place)

    def dotted(self, command: str, place: int) -> None:
        r"""Read a rate: `\dot{\varphi}_1` is the name `phi_1_d`."""
        base, _, below = self.captured().text.strip().partition("_")
        if not base.isalnum() or (below and not below.isalnum()):
            raise self.error(Reason.BAD_CHARACTER, "\\" + command, place)
        self.named(base + (f"_{below}" if below else ""), place, ACCENTS[command])

    def upright(self, place: int) -> None:
        """Read a word in upright letters: a name, a function or a unit."""
        piece = self.captured()
        if piece.text.strip().isalnum():
            self.named(piece.text.strip(), place)
            return
        if self.sheet.out and self.sheet.out[-1].isalnum():
            self.sheet.write(" ", place)
        self.sheet.put(piece)

    def superscript(self) -> None:
        """Read a power, a degree sign or primes."""
        place = self.at
        self.at += 1
        piece = self.captured()
        bare = piece.text.strip()
        if bare == "°" or (bare and set(bare) <= {"'", " "}):
            self.sheet.write(bare.replace(" ", ""), place)
        elif len(bare) == 1 and bare.isalnum():
            self.sheet.write(f"^{bare} ", place)
        else:
            self.sheet.write("^(", place)
            self.sheet.put(piece)
            self.sheet.write(")", place)

    def fraction(self, place: int) -> None:
        behind = bool(self.sheet.out) and self.sheet.out[-1].isdigit()
        over, under = self.captured(), self.captured()
        if behind and over.text.strip().isdigit() and under.text.strip().isdigit():
            raise self.error(Reason.MIXED_NUMBER, f"{over.text.strip()}/{under.text.strip()}", place)
        for mark, piece in (("((", over), (")/(", under)):
            self.sheet.write(mark, place)
            self.sheet.put(piece)
        self.sheet.write("))", place)

    def root(self, place: int) -> None:
        self.skip_spaces()
        degree = self.degree() if self.next() == "[" else None
        self.sheet.write_word("root" if degree else "sqrt", place)
        self.sheet.write("(", place)
        self.argument()
        if degree:
            self.sheet.write(";", place)
            self.sheet.put(degree)
        self.sheet.write(")", place)

    def degree(self) -> Rewritten:
        self.at += 1
        degree = self.sheet.captured(lambda: self.sequence("]"))
        if self.next() != "]":
            raise self.error(Reason.NEEDS_BRACKET, "]")
        self.at += 1
        return degree

    def fenced(self, place: int) -> None:
        r"""Read `\left( … \right)`; bars are an absolute value, angles a Macaulay bracket with its power."""
        opened = self.fence()
        inside = self.sheet.captured(lambda: self.sequence(*RIGHT))
        if self.ahead() not in RIGHT:
            raise self.error(Reason.NEEDS_BRACKET, {"(": ")", "[": "]", "<": ">"}.get(opened, opened))
        self.command()
        end = self.at
        closed = self.fence()
        if (opened + closed) not in ("()", "[]", "||", "<>"):
            raise self.error(Reason.EXTRA_BRACKET, closed, end)
        if opened == "[" and inside.text.strip().startswith("([[") and inside.text.strip().endswith("]])"):
            opened = "("  # the brackets of the matrix in them
        if opened in "|<":
            self.sheet.write_word("abs" if opened == "|" else "macaulay", place)
        self.sheet.write("[" if opened == "[" else "(", place)
        self.sheet.put(inside)
        if opened == "<":
            self.order(place)
        self.sheet.write("]" if opened == "[" else ")", end)

    def order(self, place: int) -> None:
        """Write the order of a Macaulay bracket as its second argument."""
        self.sheet.write(";", place)
        if self.next() == "^":
            self.at += 1
            self.argument()
        else:
            self.sheet.write("1", place)

    def fence(self) -> str:
        self.skip_spaces()
        place = self.at
        if self.next() == "\\":
            found = SIGNS.get(self.command(), "")
        else:
            found = self.next()
            self.at += 1
        if not found or found not in "()[]<>|":
            raise self.error(Reason.BAD_CHARACTER, "", min(place, len(self.latex)))
        return found

    def environment(self) -> str:
        found = ENVIRONMENT.match(self.latex, self.at)
        if found is None or found[1] not in ENVIRONMENTS:
            raise self.error(Reason.UNKNOWN_NAME, found[1] if found else "\\begin")
        self.at = found.end()
        return found[1]

    def matrix(self, place: int) -> None:
        opened = self.environment()
        columns = COLUMNS.match(self.latex, self.at) if opened == "array" else None
        self.at = columns.end() if columns else self.at
        self.sheet.write("([[", place)
        while True:
            self.sequence("&", "\\", "end")
            here = self.at
            if self.next() == "&":
                self.at += 1
                self.sheet.write(";", here)
            elif self.ahead() not in ("\\", "end"):
                raise self.error(Reason.NEEDS_BRACKET, f"\\end{{{opened}}}")
            elif self.command() == "end":
                break
            else:
                self.sheet.write("],[", here)
        if self.environment() != opened:
            raise self.error(Reason.EXTRA_BRACKET, "\\end", here)
        self.sheet.write("]])", here)

    def power_of_ten(self, command: str, place: int) -> None:
        r"""`1.5\times10^{-3}` behind no fraction bar is one literal, as `1.5e-3` is."""
        if command != "times" or not LITERAL.search("".join(self.sheet.out[-64:-1]).rstrip()):
            return
        start = self.at
        self.skip_spaces()
        if not self.latex.startswith("10^", self.at):
            self.at = start
            return
        self.at += 2
        ten = self.latex[start : self.at].replace("~", " ")
        mark = self.sheet.captured(self.superscript)
        power = POWER_OF_TEN.fullmatch(mark.text)
        if power is None:  # what was read is written: to read it again doubles the work at each level
            self.sheet.copy(ten, start)
            self.sheet.put(mark)
            return
        while self.sheet.out[-1] in "* ":
            self.sheet.out.pop()
            self.sheet.places.pop()
        self.sheet.write(f"e{power[1] or power[2]} ", place)
