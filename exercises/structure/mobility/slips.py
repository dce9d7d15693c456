"""Lines of the known slips in counting; no lines where a slip has no occasion or another explains the same."""

from __future__ import annotations

from typing import TYPE_CHECKING

from exercises.exercise import Mistake, Steps
from exercises.structure.mobility.parts import counts, double_joints, summed

if TYPE_CHECKING:
    from exercises.structure.mobility import Givens

FRAME_PAIRS = {"cam": 2, "roller": 2, "gears": 2}  # of a part by its type, else one


def total(givens: Givens, what: str) -> int:
    """Count guides, contacts or free turns of all parts."""
    return sum(getattr(counts(part), what) for part in givens.parts)


def links(givens: Givens, by: int) -> Steps:
    """So many links too many, or too few."""
    return {"n": f"{summed(givens.parts, 'links')} + {by}"}


def pairs(givens: Givens, by: int) -> Steps:
    """So many pairs of class 5 too many, or too few."""
    return {"p5": f"{summed(givens.parts, 'p5')} + {by}"}


def frame_counted(givens: Givens) -> Steps:
    """The frame taken for a moving link."""
    return links(givens, 1)


def frame_in_n(givens: Givens) -> Steps:
    """The frame counted, and formulas that allow for it: what follows is right."""
    return {**links(givens, 1), "F": "3*(n - 1) - 2*p5 - p4", "k": "p5 + p4 - n + 1"}


def rods_counted_twice(givens: Givens) -> Steps:
    """Two links too many: a rod taken for one link from each joint to the next."""
    return links(givens, 2)


def slider_forgotten(givens: Givens) -> Steps:
    """The sliders not taken for links."""
    sliders = total(givens, "guides")
    return links(givens, -sliders) if sliders else {}


def one_link_less(givens: Givens) -> Steps:
    """A link overlooked."""
    return links(givens, -1) if total(givens, "guides") != 1 else {}


def two_links_less(givens: Givens) -> Steps:
    """Two links overlooked."""
    return links(givens, -2) if total(givens, "guides") != 2 else {}


def joint_once(givens: Givens) -> Steps:
    """A joint of three links counted as one pair."""
    double = double_joints(givens.parts)
    return pairs(givens, -double) if double else {}


def joint_thrice(givens: Givens) -> Steps:
    """A joint of three links counted as three pairs, one for each two of them."""
    double = double_joints(givens.parts)
    return pairs(givens, double) if double > 1 or (double and not total(givens, "contacts")) else {}


def guide_forgotten(givens: Givens) -> Steps:
    """The pair of slider and guide forgotten."""
    guides = total(givens, "guides")
    return pairs(givens, -guides) if guides else {}


def one_pair_less(givens: Givens) -> Steps:
    """A pair overlooked."""
    return pairs(givens, -1) if 1 not in (double_joints(givens.parts), total(givens, "guides")) else {}


def one_pair_more(givens: Givens) -> Steps:
    """A pair counted twice; where there is a contact, it may be in both counts."""
    return pairs(givens, 1) if double_joints(givens.parts) != 1 and not total(givens, "contacts") else {}


def guide_as_higher(givens: Givens) -> Steps:
    """The pairs of slider and guide put into the other class."""
    both = total(givens, "contacts") + total(givens, "guides")
    return {**guide_forgotten(givens), "p4": str(both)} if total(givens, "guides") else {}


def sliders_left_out(givens: Givens) -> Steps:
    """The sliders taken neither for links nor for pairs."""
    return {**slider_forgotten(givens), **guide_forgotten(givens)}


def frame_joints_forgotten(givens: Givens) -> Steps:
    """The joints on the frame left out."""
    return pairs(givens, -sum(FRAME_PAIRS.get(getattr(part, "type", "strut"), 1) for part in givens.parts))


def contact_as_joint(givens: Givens) -> Steps:
    """The contact of teeth or of a cam taken for a pair of one freedom."""
    return {**pairs(givens, 1), "p4": "0"} if total(givens, "contacts") else {}


def contact_as_both(givens: Givens) -> Steps:
    """The contact counted in both classes."""
    return pairs(givens, 1) if total(givens, "contacts") else {}


def where(what: str, **lines: str) -> Mistake[Givens]:
    """A slip that has no occasion without contacts, or without a roller that turns."""

    def lines_of(givens: Givens) -> Steps:
        return lines if total(givens, what) else {}

    return Mistake(lines_of)


COUNTED: dict[str, Mistake[Givens]] = {
    "frame_counted": Mistake(frame_counted),
    "frame_in_n": Mistake(frame_in_n),
    "rods_counted_twice": Mistake(rods_counted_twice),
    "slider_forgotten": Mistake(slider_forgotten),
    "one_link_less": Mistake(one_link_less),
    "two_links_less": Mistake(two_links_less),
    "joint_once": Mistake(joint_once),
    "joint_thrice": Mistake(joint_thrice),
    "guide_forgotten": Mistake(guide_forgotten),
    "one_pair_less": Mistake(one_pair_less),
    "one_pair_more": Mistake(one_pair_more),
    "guide_as_higher": Mistake(guide_as_higher),
    "sliders_left_out": Mistake(sliders_left_out),
    "frame_joints_forgotten": Mistake(frame_joints_forgotten),
    "contact_as_joint": Mistake(contact_as_joint),
    "contact_as_both": Mistake(contact_as_both),
    "contact_forgotten": where("contacts", p4="0"),
    "contact_twice": where("contacts", p4="2"),
}
IN_FORMULAS: dict[str, Mistake[Givens]] = {
    "frame_moves": Mistake(F="3*(n + 1) - 2*p5 - p4"),
    "frame_taken_off": Mistake(F="3*(n - 1) - 2*p5 - p4"),
    "one_added": Mistake(F="3*n - 2*p5 - p4 + 1"),
    "two_freedoms": Mistake(F="2*n - 2*p5 - p4"),
    "formula_of_space": Mistake(F="6*n - 5*p5 - 4*p4"),
    "joint_takes_one": Mistake(F="3*n - p5 - p4"),
    "three_for_joint": Mistake(F="3*n - 3*p5 - p4"),
    "classes_exchanged": where("contacts", F="3*n - p5 - 2*p4"),
    "contact_left_out": where("contacts", F="3*n - 2*p5"),
    "contact_added": where("contacts", F="3*n - 2*p5 + p4"),
    "contact_doubled": where("contacts", F="3*n - 2*p5 - 2*p4"),
    "roller_kept": where("spins", W="F"),
    "roller_twice": where("spins", W="F - 2"),
    "roller_added": where("spins", W="F + 1"),
    "loops_without_frame": Mistake(k="p5 + p4 - n + 1"),
    "one_loop_lost": Mistake(k="p5 + p4 - (n + 1)"),
    "loops_without_contacts": where("contacts", k="p5 - (n + 1) + 1"),
    "loops_as_pairs": Mistake(k="p5 + p4"),
}
