"""Random trees, written without a look at the parser or the printer."""

from __future__ import annotations

from hypothesis import strategies as st

from graders.language.tree import Angle, Binary, Call, Grid, Number, Tree, Unary
from graders.language.tree import Name as Symbol

NAMES = ("l1", "l2", "alpha1", "omega1", "R_A", "x", "a", "F1", "psi_d", "lambda")

numbers = st.one_of(
    st.integers(0, 10**6).map(lambda n: Number(str(n))),
    st.decimals(0, 1000, places=3).map(lambda d: Number(str(d))),
    st.tuples(st.integers(1, 99), st.integers(-20, 20).filter(bool)).map(lambda p: Number(str(p[0]), p[1])),
)
leaves: st.SearchStrategy[Tree] = st.one_of(numbers, st.sampled_from((*NAMES, "pi")).map(Symbol))


def grown(inner: st.SearchStrategy[Tree]) -> st.SearchStrategy[Tree]:
    small = st.integers(0, 3).map(lambda n: Number(str(n)))
    return st.one_of(
        st.builds(Binary, st.sampled_from("+-*/^"), inner, inner),
        st.builds(Unary, st.sampled_from("+-"), inner),
        st.builds(lambda f, a: Call(f, (a,)), st.sampled_from(("sin", "cos", "sqrt", "abs", "atan", "exp")), inner),
        st.builds(lambda f, a, b: Call(f, (a, b)), st.sampled_from(("atan2", "min", "root")), inner, inner),
        st.builds(lambda u, n: Call("macaulay", (u, n)), inner, small),
        st.builds(lambda a, b: Binary("*", a, b, implicit=True), numbers, st.sampled_from(NAMES).map(Symbol)),
    )


trees: st.SearchStrategy[Tree] = st.recursive(leaves, grown, max_leaves=20)
whole = st.integers(0, 59).map(lambda n: Number(str(n)))
angles: st.SearchStrategy[Tree] = st.builds(Angle, whole, whole, st.one_of(st.none(), whole))
matrices: st.SearchStrategy[Tree] = st.integers(1, 4).flatmap(
    lambda width: st.lists(st.lists(trees, min_size=width, max_size=width).map(tuple), min_size=1, max_size=4).map(
        lambda rows: Grid(tuple(rows))
    )
)
