"""The laboratory of one arm: what the three manipulators of TMM-2 are made of alike, from their sides and joints."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from exercises.exercise import Draw, Exercise, Mistake, Steps, Values
from exercises.givens import numbers
from exercises.manipulators import _arm
from exercises.manipulators._arm import Sides, motion
from exercises.manipulators._arm.drawing import accelerations, angles, clear, lengths, rates
from exercises.manipulators._arm.motion import Arm
from figures.machine import Machine
from graders import States
from graders.polygon.mechanism import Mechanism

MEASURED = ("relative", "absolute")  # from the link before, or from +X


@dataclass(frozen=True, slots=True)
class Elbow:
    """A link whose angle is given from the link before it or from +X, as the task says.

    Attributes:
        base: The angle of the link before it.
        own: Its own coordinate.
        direction: The name of its direction from +X.
    """

    base: str
    own: str
    direction: str

    def turned(self, relative: bool) -> Steps:
        """Write its direction and turning."""
        marks = {self.direction: "", "omega3": "_d", "epsilon3": "_dd"}
        return {name: (f"{self.base}{mark} + " if relative else "") + self.own + mark for name, mark in marks.items()}

    def alone(self, relative: bool) -> Steps:
        """Write its turning taken from its own coordinate only; nothing where that is so."""
        return {"omega3": f"{self.own}_d", "epsilon3": f"{self.own}_dd"} if relative else {}


@dataclass(frozen=True, slots=True)
class Laboratory:
    """One manipulator.

    Attributes:
        systems: Where it stands in the domain.
        givens: Its givens: three lengths, two angles, their rates and accelerations, `measured` and `slide`.
        joints: Its word over R and P, by which the rates are drawn.
        slides: The ways its slide may run, in the order drawn.
        elbow: Its link with the angle of two kinds.
        steps: Gives its steps.
        arm: Gives its bodies.
        sides: Gives the sides of its polygon.
        doubled: The length that the observation doubles.
        mistakes: The slips of this arm alone.
        carried: Whether its slide is carried by a turning link.
    """

    systems: tuple[str, ...]
    givens: type[Any]
    joints: str
    slides: tuple[str, str]
    elbow: Elbow
    steps: Callable[[Any], Steps]
    arm: Callable[[Any], Arm]
    sides: Callable[[Any], Sides]
    doubled: str
    mistakes: Mapping[str, Mistake[Any]]
    carried: bool = True

    def draw(self, rng: Draw) -> Any:
        """Draw whole centimetres and degrees; no result is the small difference of large terms."""
        placed, kind = lengths(rng) + angles(rng), (rng.pick(MEASURED), rng.pick(self.slides))
        drawn = self.givens(*placed, *rates(rng, self.joints), *accelerations(rng, self.joints), *kind)
        if not clear(numbers(drawn), self.steps(drawn), self.sides(drawn)):
            rng.reject()
        return drawn

    def oracle(self, givens: Any) -> Values:
        """The same names by another way: bodies and joints, Newton's method, linear equations for the rates."""
        return motion.oracle(self.arm(givens), numbers(givens), self.doubled)

    def judged_by(self, givens: Any, values: Values, states: States) -> Mechanism:
        """Give the true motion at the drawn states."""
        return motion.mechanism(self.arm(givens), self.sides(givens), self.steps(givens), states)

    def machine(self, givens: Any) -> Machine:
        """Give the arm as the page of the laboratory moves it."""
        return motion.machine(self.arm(givens), self.sides(givens))

    def slips(self) -> dict[str, Mistake[Any]]:
        """Name the slips: of the elbow, of this arm, of all arms."""
        elbow, base, own = self.elbow, self.elbow.base, self.elbow.own
        return {
            "angle_of_the_other_kind": Mistake(lambda g: elbow.turned(g.measured != "relative")),
            "rate_alone": Mistake(lambda g: elbow.alone(g.measured == "relative")),
            **self.mistakes,
            "degrees_as_radians": Mistake(**{base: f"{base}*180/pi", own: f"{own}*180/pi"}),
            **_arm.slips(self.sides, self.carried),
        }

    def exercise(self) -> Exercise[Any]:
        """Make the exercise."""
        return Exercise(
            systems=self.systems,
            version=2,
            givens=self.givens,
            draw=self.draw,
            steps=self.steps,
            oracle=self.oracle,
            answers=_arm.answers(),
            references=_arm.references(self.judged_by),
            mistakes=self.slips(),
            report=_arm.REPORT,
            machine=self.machine,
            minutes=90,
        )
