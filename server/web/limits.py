"""How often somebody may post: a bucket of tokens for each owner and for each address, refilled steadily."""

from __future__ import annotations

import math
from collections import OrderedDict
from collections.abc import Callable
from dataclasses import dataclass, field
from time import monotonic

KEPT = 20_000  # buckets; the one not used for longest is forgotten, which only fills it again


@dataclass(frozen=True, slots=True)
class Rate:
    """What may come at once, and how fast it comes back.

    Attributes:
        burst: Posts at once.
        refill: Posts a second afterwards.
    """

    burst: float
    refill: float


OWNER = Rate(120, 6)  # one person: a preview after each pause in typing, and many submissions
NEWCOMERS = Rate(400, 10)  # of one address, without a cookie yet: a class of 60 behind it opens its first pages
ADDRESS = Rate(3000, 150)  # all of one address: the same class, typing
DOCUMENTS = Rate(20, 1 / 3)  # of one person: reports and sheets, which are printed for each request
DOCUMENTS_OF_ADDRESS = Rate(300, 5)  # the same class prints its reports at the end of the lesson
TRIES = Rate(10, 1 / 30)  # to sign in as one person from one address, or from a browser that knows the person
TRIES_FROM_ANYWHERE = Rate(60, 1 / 10)  # to sign in as one person from all browsers that do not
ALL_TRIES = Rate(600, 15)  # of everybody: passwords are work


@dataclass(slots=True)
class Limiter:
    """Counts posts by name; `clock` gives seconds."""

    clock: Callable[[], float] = monotonic
    _left: OrderedDict[tuple[Rate, str], tuple[float, float]] = field(default_factory=OrderedDict)

    def wait(self, rate: Rate, name: str) -> int:
        """Take one post of a name; gives 0, or the whole seconds after which it may be tried again."""
        now, key = self.clock(), (rate, name)
        left, then = self._left.pop(key, (rate.burst, now))
        left = min(rate.burst, left + (now - then) * rate.refill)
        allowed = left >= 1
        self._left[key] = (left - 1 if allowed else left, now)
        if len(self._left) > KEPT:
            self._left.popitem(last=False)
        return 0 if allowed else max(1, math.ceil((1 - left) / rate.refill))
