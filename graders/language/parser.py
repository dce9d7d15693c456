"""Tokens to tree: precedence climbing, every error with its place and, where possible, a proposal."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

from graders.language import plain
from graders.language.cursor import Cursor
from graders.language.errors import AnswerSyntaxError, Reason
from graders.language.latex_source import is_latex, upright
from graders.language.proposals import figure_behind, not_known
from graders.language.symbols import DEGREES, FUNCTIONS, SUPERSCRIPTS, Symbols, function_named, key, latin
from graders.language.tokens import Token, exponent_of, partners, tokenize
from graders.language.tree import Angle, Binary, Call, Grid, Index, Name, Number, Relation, Tree, Unary, order_exists

MAX_MATRIX = 16
MAX_SIDES = 24  # of a chain of relations
ONE: Tree = Number("1")
RELATIONS = ("=", "<", ">", "<=", ">=")
LESS, GREATER = frozenset(("<", "<=")), frozenset((">", ">="))  # a chain runs in one sense
BEHIND = ("^", "raised", "end", ")", "]", ";", ",", ">", "+", "-", "*", "/")  # a bracket such as <x - a>
ROOTS = {"√": "2", "∛": "3", "∜": "4"}
STARTS = ("number", "name", "(", "[", *ROOTS)


def parse(text: str, symbols: Symbols) -> Tree:
    """Read a text over the declared symbols.

    Raises:
        AnswerSyntaxError: The text is not in the language; names the place and what may be meant.
    """
    return plain.read(text, symbols) or _Parser(tokenize(text), symbols, text if is_latex(text) else "").whole()


def parse_tokens(tokens: Sequence[Token], symbols: Symbols) -> Tree:
    """Read what was cut into tokens already, the last of kind `end`; raises as `parse` does."""
    return _Parser(list(tokens), symbols).whole()


@lru_cache(maxsize=4096)
def parse_line(text: str) -> Tree:
    """Read a line written by an author, in which every name stands for itself; the result is remembered."""
    return _Parser(tokenize(text), None).whole()


class _Parser(Cursor):
    """One pass over the tokens; `at` is the next of them. LaTeX, if any, tells what its letters mean (0019)."""

    def __init__(self, tokens: list[Token], symbols: Symbols | None, latex: str = "") -> None:
        super().__init__(tokens)
        self.symbols, self.latex, self.bars = symbols, latex, 0
        self.closed: dict[int, int] | None = None

    def whole(self) -> Tree:
        tree = self.relation()
        if self.token.kind != "end":
            raise self.error(Reason.EXTRA_BRACKET if self.token.kind in (")", "]") else Reason.EXTRA_TEXT)
        return tree

    def relation(self) -> Tree:
        sides, operators, said = [self.sum()], [], set[str]()
        while self.token.kind in RELATIONS:
            operators.append(self.token.kind)
            said.add(self.token.kind)
            if said & LESS and said & GREATER:
                raise self.error(Reason.TURNED_CHAIN)
            if len(sides) > MAX_SIDES:
                raise self.error(Reason.TOO_LONG)
            self.at += 1
            sides.append(self.sum())
        return Relation(tuple(operators), tuple(sides)) if operators else sides[0]

    def sum(self) -> Tree:
        tree, below = self.product(), self.height
        while self.token.kind in ("+", "-"):
            operator = self.token.kind
            self.at += 1
            self.longer()
            tree = self.count(Binary(operator, tree, self.product()))
        self.height = below
        return tree

    def product(self) -> Tree:
        below = self.height
        tree = self.factors(self.signed())
        self.height = below
        return tree

    def factors(self, tree: Tree) -> Tree:
        divided: Tree | None = None
        while True:
            token = self.token
            if token.kind in ("*", "/"):
                self.at += 1
                self.longer()
                right = self.signed()
                divided = right if token.kind == "/" else None
                tree = self.count(Binary(token.kind, tree, right))
            elif self.begins_factor():
                self.refuse_doubt(tree, divided, token)
                self.longer()
                tree, divided = self.count(Binary("*", tree, self.power(), implicit=True)), None
            else:
                return tree

    def begins_factor(self) -> bool:
        kind = self.token.kind
        return kind in STARTS or (kind == "|" and not self.bars) or (kind == "<" and self.opens_bracket())

    def opens_bracket(self) -> bool:
        """Tell `F<x - a>^1` from the relation `F < x`: only behind a bracket a power, a sign or nothing follows."""
        if self.closed is None:
            self.closed = partners(self.tokens)
        after = self.closed.get(self.at - len(self.tokens))
        return after is not None and self.tokens[after + 1].kind in BEHIND

    def refuse_doubt(self, tree: Tree, divided: Tree | None, token: Token) -> None:
        """`a/2b` may be (a/2)b or a/(2b): ask, unless a plain fraction of numbers stands in front."""
        if token.kind == "number":  # a b, 2 b and (a) (b) are products; a figure behind something is asked about
            raise figure_behind(self.tokens, self.at)
        plain = isinstance(tree, Binary) and isinstance(tree.left, Number) and isinstance(tree.right, Number)
        if divided is not None and not plain and not isinstance(divided, Grid):
            raise self.error(Reason.AMBIGUOUS_FRACTION, token)

    def signed(self) -> Tree:
        token = self.token
        if token.kind in ("+", "-"):
            self.at += 1
            self.enter(token)
            tree = self.count(Unary(token.kind, self.signed()))
            self.depth -= 1
            return tree
        return self.power()

    def power(self) -> Tree:
        base = self.postfix()
        token = self.token
        if self.accept("^"):
            self.enter(token)
            base = self.count(Binary("^", base, self.signed()))
            self.depth -= 1
        elif token.kind == "raised":
            self.at += 1
            base = self.count(Binary("^", base, self.raised(token)))
            if self.accept("°"):  # 1,2·10¹ °
                base = self.count(Unary("°", base))
        return base

    def raised(self, token: Token) -> Tree:
        digits = "".join(SUPERSCRIPTS[c] for c in token.text)
        if len(digits) > 4:
            raise self.error(Reason.TOO_LARGE, token)
        return Unary("-", Number(digits[1:])) if digits[0] == "-" else Number(digits)

    def postfix(self) -> Tree:
        tree = self.atom()
        while self.token.kind == "[" and isinstance(tree, Name | Index):
            tree = self.index(tree)
        if self.token.kind == "°" or self.names_degrees(self.token):
            self.at += 1
            return self.arc(tree)
        return tree

    def names_degrees(self, token: Token) -> bool:
        """Tell whether a word is the unit of an angle: `30 deg`, where no symbol is called so."""
        if token.kind != "name" or token.text not in DEGREES:
            return False
        return token.text == "deg" if self.symbols is None else self.symbols.find(token.text) is None

    def arc(self, degrees: Tree) -> Tree:
        """Read what follows a degree sign: minutes and seconds of arc, if they are typed."""
        if isinstance(degrees, Number) and self.token.kind == "number" and self.tokens[self.at + 1].kind == "'":
            minutes, seconds = self.number(), None
            self.at += 1
            if self.token.kind == "number" and self.tokens[self.at + 1].kind in ('"', "'"):
                seconds = self.number()
                self.at += 2 if self.token.kind == "'" and self.tokens[self.at + 1].kind == "'" else 1
            return self.count(Angle(degrees, minutes, seconds))
        return self.count(Unary("°", degrees))

    def index(self, matrix: Tree) -> Tree:
        opened = self.token
        self.at += 1
        row = self.small_integer()
        if not (self.accept(",") or self.accept(";")):
            raise self.error(Reason.NEEDS_ARGUMENTS)
        column = self.small_integer()
        self.close(opened)
        return self.count(Index(matrix, row, column))

    def small_integer(self) -> int:
        token = self.token
        if token.kind != "number" or not token.text.isdigit() or not 1 <= int(token.text[:3]) <= MAX_MATRIX:
            raise self.error(Reason.NOT_AN_INTEGER)
        self.at += 1
        return int(token.text)

    def atom(self) -> Tree:
        token = self.token
        if token.kind == "number":
            return self.count(self.number())
        if token.kind == "name":
            self.at += 1
            return self.count(self.named(token))
        if token.kind == "[":
            return self.matrix()
        if token.kind in ("(", "|", "<"):
            return self.bracket()
        if token.kind in ROOTS:
            return self.root(token)
        raise self.error(Reason.NEEDS_OPERAND)

    def root(self, token: Token) -> Tree:
        self.at += 1
        self.enter(token)
        inside = self.power() if self.token.kind != "number" else self.count(self.number())
        self.depth -= 1
        if token.kind == "√":
            return self.count(Call("sqrt", (inside,)))
        return self.count(Call("root", (inside, Number(ROOTS[token.kind]))))

    def number(self) -> Number:
        token = self.token
        self.at += 1
        try:
            return Number(*exponent_of(token.text))
        except OverflowError:
            raise self.error(Reason.TOO_LARGE, token) from None

    def bracket(self) -> Tree:
        opened = self.token
        self.at += 1
        self.enter(opened)
        outside, self.bars = self.bars, int(opened.kind == "|")
        tree = self.sum()
        self.bars = outside
        self.close(opened)
        self.depth -= 1
        if opened.kind == "<":
            return self.macaulay(tree)
        return self.count(Call("abs", (tree,))) if opened.kind == "|" else tree

    def macaulay(self, inside: Tree) -> Tree:
        """`<u>^n`; without a power the bracket means `<u>^1`."""
        mark, order = self.token, ONE
        if self.accept("^"):
            order = self.signed()
        elif self.accept("raised"):
            order = self.raised(mark)
        if not order_exists(order):
            raise self.error(Reason.OUT_OF_RANGE, mark)
        return self.count(Call("macaulay", (inside, order)))

    def matrix(self) -> Tree:
        opened = self.token
        self.at += 1
        self.enter(opened)
        nested = self.token.kind == "["
        rows = [self.row(nested)]
        while self.accept(";") or (nested and self.accept(",")):
            rows.append(self.row(nested))
        self.close(opened)
        self.depth -= 1
        first = rows[0][0]
        if not nested and len(rows) == len(rows[0]) == 1 and isinstance(first, Binary):  # [a + b] c is a product
            return first
        if len({len(row) for row in rows}) > 1:
            raise self.error(Reason.RAGGED_MATRIX, opened)
        if max(len(rows), len(rows[0])) > MAX_MATRIX:
            raise self.error(Reason.TOO_LARGE, opened)
        return self.count(Grid(tuple(rows)))

    def row(self, nested: bool) -> tuple[Tree, ...]:
        opened = self.token
        if nested and not self.accept("["):
            raise AnswerSyntaxError(Reason.NEEDS_BRACKET, opened.position, "[")
        entries = [self.sum()]
        while self.accept(",") or (nested and self.accept(";")):
            entries.append(self.sum())
        if nested:
            self.close(opened)
        return tuple(entries)

    def named(self, token: Token) -> Tree:
        symbol = self.symbol(token.text)
        if symbol is not None:
            return Name(symbol)
        function = function_named(token.text) or function_named(latin(token.text))
        if function is not None:
            return self.call(function, token)
        folded = key(token.text)
        if folded == "pi":
            return Name("pi")
        if folded.startswith("log") and folded[3:].isdigit() and len(folded) < 9:  # log_2(8), log₂ 8
            return self.call("log", token, Number(folded[3:]))
        if token.text in (*DEGREES, "grad"):  # never declared here, so it is the unit of an angle
            raise self.error(Reason.UNKNOWN_NAME, token, "°")
        return self.named(self.cut(token))

    def cut(self, token: Token) -> Token:
        """Put the parts of a run in its place and give the first of them; raises where it cannot be cut."""
        parts = self.symbols.parts(token.text) if self.symbols else []
        if not parts and self.symbols and self.latex and not upright(self.latex, token.position):
            parts = self.symbols.run(token.text)
        if not parts:
            assert self.symbols is not None
            raise not_known(token, self.tokens[self.at :], self.symbols)
        places = [token.position + len("".join(parts[:i])) for i in range(len(parts))]
        cut = [Token("name", part, place) for part, place in zip(parts, places, strict=True)]
        self.tokens[self.at - 1 : self.at] = cut
        return cut[0]

    def symbol(self, spelling: str) -> str | None:
        if self.symbols is None:
            return None if function_named(spelling) or spelling == "pi" else spelling
        return self.symbols.find(spelling)

    def call(self, function: str, token: Token, *last: Tree) -> Tree:
        power = self.function_power(token)
        self.enter(token)
        arguments = (*self.arguments(token), *last)
        self.depth -= 1
        least, most = FUNCTIONS[function]
        if not least <= len(arguments) <= most:
            raise self.error(Reason.NEEDS_ARGUMENTS, token)
        if function == "macaulay" and not order_exists(arguments[1]):
            raise self.error(Reason.OUT_OF_RANGE, token)
        tree = self.count(Call(function, arguments))
        return self.count(Binary("^", tree, power)) if power else tree

    def function_power(self, token: Token) -> Tree | None:
        """`sin^2(x)` is (sin x)^2; `sin^-1(x)` is asked about."""
        if self.token.kind not in ("^", "raised"):
            return None
        mark = self.token
        self.at += 1
        power = self.raised(mark) if mark.kind == "raised" else self.exponent()
        if isinstance(power, Unary):
            raise self.error(Reason.INVERSE_OR_RECIPROCAL, token, "a" + token.text)
        return power

    def exponent(self) -> Tree:
        opened = self.token
        bracket = self.accept("(")
        if self.token.kind == "-":
            return Unary("-", Number("1"))
        if self.token.kind != "number":
            raise self.error(Reason.NEEDS_OPERAND)
        power = self.number()
        if bracket:
            self.close(opened)
        return power

    def arguments(self, token: Token) -> tuple[Tree, ...]:
        opened = self.token
        if not self.accept("("):
            return (self.bare_argument(token),)
        found = [self.sum()]
        while self.accept(";") or self.accept(","):
            found.append(self.sum())
        self.close(opened)
        return tuple(found)

    def bare_argument(self, token: Token) -> Tree:
        """`sin α1`, `sin 2α1`: one name with a number in front; more is asked about."""
        if self.token.kind in ("end", "+", "*", "/", ")"):
            raise self.error(Reason.NEEDS_ARGUMENTS, token)
        tree = self.power() if self.token.kind != "-" else self.signed()
        if isinstance(tree, Number) and self.token.kind == "name" and not function_named(self.token.text):
            tree = self.count(Binary("*", tree, self.power(), implicit=True))
        if self.token.kind in ("number", "name", "√") and not function_named(self.token.text):
            raise self.error(Reason.AMBIGUOUS_ARGUMENT)
        return tree
