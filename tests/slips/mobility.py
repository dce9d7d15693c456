"""Slips at the mobility of a drawn mechanism (STR-3, STR-4, STR-6): what is counted, how often, by which formula."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from exercises.structure.mobility.parts import counts, double_joints, summed
from tests.slips.slip import Lines, S


def total(givens: Any, what: str) -> int:
    return sum(getattr(counts(part), what) for part in givens.parts)


def counted(what: str, step: str, by: int = 1, least: int = 1) -> Lines:
    """So many less of a step as there are such parts; no occasion where there is none."""

    def lines(g: Any) -> Mapping[str, str] | None:
        number = total(g, what)
        return (
            {step: f"{summed(g.parts, 'links' if step == 'n' else 'p5')} - {by * number}"} if number >= least else None
        )

    return lines


def more(step: str, by: int) -> Lines:
    return lambda g: {step: f"{summed(g.parts, 'links' if step == 'n' else 'p5')} + {by}"}


def where(what: str, lines: Mapping[str, str]) -> Lines:
    return lambda g: lines if total(g, what) else None


def doubled(times: int) -> Lines:
    return lambda g: (
        {"p5": f"{summed(g.parts, 'p5')} + {times * double_joints(g.parts)}"} if double_joints(g.parts) else None
    )


def chosen(word: str) -> Lines:
    return lambda g: {"drives": f"={word}"}


SLIPS = (
    # links
    S("the frame counted as a moving link", "frame_counted", more("n", 1)),
    S("a link overlooked", "one_link_less slider_forgotten", more("n", -1)),
    S("two links overlooked", "two_links_less slider_forgotten", more("n", -2)),
    S("sliders not counted as links", "slider_forgotten", counted("guides", "n")),
    S("the frame as a link in the formula only", "frame_moves", {"F": "3*(n + 1) - 2*p5 - p4"}),
    S("rods with several joints counted as several links", "rods_counted_twice one_link_more", more("n", 2)),
    # pairs
    S("a joint of three links counted once", "joint_once", doubled(-1)),
    S("a joint of three links counted three times", "joint_thrice", doubled(1)),
    S("guides not counted", "guide_forgotten", counted("guides", "p5")),
    S("sliders counted with their guide only", "slider_joint_forgotten guide_forgotten", counted("guides", "p5")),
    S(
        "joints on the frame not counted",
        "frame_joints_forgotten",
        lambda g: {"p5": f"{summed(g.parts, 'p5')} - {len(g.parts) + total(g, 'contacts')}"},
    ),
    S("a joint overlooked", "one_pair_less joint_once guide_forgotten", more("p5", -1)),
    S("a joint counted twice", "one_pair_more joint_thrice", more("p5", 1)),
    S(
        "the contact counted as a joint",
        "contact_as_joint",
        lambda g: {"p5": f"{summed(g.parts, 'p5')} + 1", "p4": "0"} if total(g, "contacts") else None,
    ),
    S(
        "the contact counted as both",
        "contact_as_both",
        lambda g: {"p5": f"{summed(g.parts, 'p5')} + 1"} if total(g, "contacts") else None,
    ),
    S("the contact overlooked", "contact_forgotten", where("contacts", {"p4": "0"})),
    S("the contact counted twice", "contact_twice", where("contacts", {"p4": "2"})),
    # the formula
    S("two freedoms for a contact", "contact_doubled", where("contacts", {"F": "3*n - 2*p5 - 2*p4"})),
    S("one freedom for a joint", "joint_takes_one", {"F": "3*n - p5 - p4"}),
    S("classes exchanged", "classes_exchanged", where("contacts", {"F": "3*n - p5 - 2*p4"})),
    S("contact left out of the formula", "contact_left_out", where("contacts", {"F": "3*n - 2*p5"})),
    S("contact with a plus", "contact_added", where("contacts", {"F": "3*n - 2*p5 + p4"})),
    S("spatial formula", "formula_of_space", {"F": "6*n - 5*p5 - 4*p4"}),
    S("frame taken off", "frame_taken_off", {"F": "3*(n - 1) - 2*p5 - p4"}),
    S("two freedoms a link", "two_freedoms", {"F": "2*n - 2*p5 - p4"}),
    S("sign of the mobility", "opposite_sign", lambda g: {"F": "2*p5 + p4 - 3*n"}),
    S("plus one for the frame", "one_added", {"F": "3*n - 2*p5 - p4 + 1"}),
    S("pairs of class 5 take three", "three_for_joint", {"F": "3*n - 3*p5 - p4"}),
    # local mobility
    S("the roller's turn kept", "roller_kept", where("spins", {"W": "F"})),
    S("the roller's turn taken off twice", "roller_twice", where("spins", {"W": "F - 2"})),
    S("the roller's turn added", "roller_added", where("spins", {"W": "F + 1"})),
    # loops
    S("loops without the frame", "loops_without_frame", {"k": "p5 + p4 - n + 1"}),
    S("loops without the one", "one_loop_lost", {"k": "p5 + p4 - (n + 1)"}),
    S(
        "loops without the contacts",
        "loops_without_contacts one_loop_lost",
        where("contacts", {"k": "p5 - (n + 1) + 1"}),
    ),
    S("links less pairs", "opposite_sign loops_turned", {"k": "n - p5 - p4"}),
    S("as many loops as pairs", "loops_as_pairs", {"k": "p5 + p4"}),
    S("contact counted twice in the loops", "contact_twice", where("contacts", {"k": "p5 + 2*p4 - n"})),
    # choice
    S("no drive", "wrong", {}, chosen("rigid")),
    S("two drives", "wrong", {}, chosen("two")),
    S("a drive for a mobility of two", "wrong", {}, lambda g: {"drives": "=one"}),
    S("drives by the mobility with the roller", "wrong roller_kept", where("spins", {"W": "F"}), {}),
    # several at once
    S(
        "sliders no links and guides no pairs",
        "slider_forgotten guide_forgotten",
        lambda g: (
            {**(counted("guides", "n")(g) or {}), **(counted("guides", "p5")(g) or {})} if total(g, "guides") else None
        ),
    ),
    S("frame moving, loops left empty", "frame_moves", {"F": "3*(n + 1) - 2*p5 - p4"}, {}, "k"),
    S("contact doubled, loops left empty", "contact_doubled", where("contacts", {"F": "3*n - 2*p5 - 2*p4"}), {}, "k"),
    S("guides forgotten, choice left empty", "guide_forgotten", counted("guides", "p5"), {}, "drives"),
    S("sliders forgotten, loops left empty", "slider_forgotten", counted("guides", "n"), {}, "k"),
    S("double joint once, loops left empty", "joint_once", doubled(-1), {}, "k"),
    S(
        "frame joints forgotten, loops left empty",
        "frame_joints_forgotten",
        lambda g: {"p5": f"{summed(g.parts, 'p5')} - {len(g.parts) + total(g, 'contacts')}"},
        {},
        "k",
    ),
    S("loops without the frame, choice left empty", "loops_without_frame", {"k": "p5 + p4 - n + 1"}, {}, "drives"),
    S(
        "contact as a joint, choice left empty",
        "contact_as_joint",
        lambda g: {"p5": f"{summed(g.parts, 'p5')} + 1", "p4": "0"} if total(g, "contacts") else None,
        {},
        "drives",
    ),
    S("frame moving in the formula, counts left empty", "frame_moves", {"F": "3*(n + 1) - 2*p5 - p4"}, {}, "n p5 p4"),
    S(
        "contact doubled, counts left empty",
        "contact_doubled contact_as_joint",
        where("contacts", {"F": "3*n - 2*p5 - 2*p4"}),
        {},
        "n p5 p4",
    ),
    S("roller kept, counts left empty", "roller_kept", where("spins", {"W": "F"}), {}, "n p5 p4"),
)
