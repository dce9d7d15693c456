"""Random trees, written without a look at the parser or the printer."""

from __future__ import annotations

from hypothesis import strategies as st

from graders.language.tree import Angle, Binary, Call, Grid, Index, Number, Relation, Tree, Unary
from graders.language.tree import Name as Symbol

NAMES = ("l1", "l2", "alpha1", "omega1", "R_A", "x", "a", "F1", "psi_d", "phi1_dd", "k_adm", "y'", "lambda")
MATRICES = ("T", "A1")

numbers = st.one_of(
    st.integers(0, 10**6).map(lambda n: Number(str(n))),
    st.decimals(0, 1000, places=3).map(lambda d: Number(str(d))),
    st.tuples(st.integers(1, 99), st.integers(-20, 20).filter(bool)).map(lambda p: Number(str(p[0]), p[1])),
)
whole = st.integers(0, 59).map(lambda n: Number(str(n)))
angles: st.SearchStrategy[Tree] = st.builds(Angle, whole, whole, st.one_of(st.none(), whole))
entries: st.SearchStrategy[Tree] = st.builds(
    Index, st.sampled_from(MATRICES).map(Symbol), st.integers(1, 4), st.integers(1, 4)
)
leaves: st.SearchStrategy[Tree] = st.one_of(numbers, st.sampled_from((*NAMES, "pi")).map(Symbol), angles)


def grown(inner: st.SearchStrategy[Tree]) -> st.SearchStrategy[Tree]:
    orders = st.sampled_from([*(Number(str(n)) for n in range(4)), Unary("-", Number("1")), Unary("-", Number("2"))])
    return st.one_of(
        st.builds(Binary, st.sampled_from("+-*/^"), inner, inner),
        st.builds(Unary, st.sampled_from("+-"), inner),
        st.builds(lambda f, a: Call(f, (a,)), st.sampled_from(("sin", "cos", "sqrt", "abs", "atan", "exp")), inner),
        st.builds(lambda f, a, b: Call(f, (a, b)), st.sampled_from(("atan2", "min", "root")), inner, inner),
        st.builds(lambda u, n: Call("macaulay", (u, n)), inner, orders),
        st.builds(lambda a, b: Binary("*", a, b, implicit=True), inner, inner),
        st.builds(Unary, st.just("°"), inner),
        st.builds(lambda a, b: Call("log", (a, b)), inner, inner),
    )


trees: st.SearchStrategy[Tree] = st.recursive(leaves, grown, max_leaves=20)
written: st.SearchStrategy[Tree] = st.recursive(st.one_of(leaves, entries), grown, max_leaves=20)
matrices: st.SearchStrategy[Tree] = st.integers(1, 4).flatmap(
    lambda width: st.lists(st.lists(written, min_size=width, max_size=width).map(tuple), min_size=1, max_size=4).map(
        lambda rows: Grid(tuple(rows))
    )
)
# A chain runs in one sense: `a <b> + c`, which would turn round, is read as a bracket of Macaulay.
senses = st.sampled_from((("=", "<", "<="), ("=", ">", ">=")))
relations: st.SearchStrategy[Tree] = st.tuples(st.lists(written, min_size=2, max_size=4), senses).flatmap(
    lambda drawn: st.lists(st.sampled_from(drawn[1]), min_size=len(drawn[0]) - 1, max_size=len(drawn[0]) - 1).map(
        lambda operators: Relation(tuple(operators), tuple(drawn[0]))
    )
)
