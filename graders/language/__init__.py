"""The answer language: text to tokens, tree, value, and back to text, LaTeX and MathML.

Student text never reaches `eval`, a computer algebra system or a regular expression that can backtrack.
"""

from graders.language.errors import AnswerSyntaxError, Proposal, Reason
from graders.language.parser import parse, parse_line
from graders.language.symbols import Symbols
from graders.language.tree import Tree

__all__ = ["AnswerSyntaxError", "Proposal", "Reason", "Symbols", "Tree", "parse", "parse_line"]
