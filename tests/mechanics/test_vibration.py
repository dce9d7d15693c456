"""Steady vibration against the complex response and the domain's examples."""

from __future__ import annotations

from cmath import phase
from decimal import Decimal, localcontext
from math import degrees, inf, nan, pi, sin, sqrt

import pytest
from hypothesis import given
from hypothesis import strategies as st

from mechanics.errors import SingularError
from mechanics.vibration import Oscillator, base, force, octaves, polyharmonic, rms

MACHINE = Oscillator(20, 32000, 160)
oscillators = st.builds(Oscillator, st.floats(0.1, 1e3), st.floats(1e2, 1e6), st.floats(1, 1e4))


@given(oscillators, st.floats(0.1, 1e3), st.floats(0, 500))
def test_a_force_moves_the_mass_as_the_complex_response_says(body: Oscillator, F0: float, omega: float) -> None:
    answer = F0 / complex(body.c - body.m * omega**2, body.b * omega)
    found = force(body, F0, omega)
    assert found.amplitude == pytest.approx(abs(answer))
    assert found.phase == pytest.approx(-phase(answer), abs=1e-9)
    assert found.force_to_base == pytest.approx(abs(answer * complex(body.c, body.b * omega)))


@given(oscillators, st.floats(1e-4, 1e-2), st.floats(0, 500))
def test_a_shaken_base_moves_the_mass_as_the_complex_response_says(body: Oscillator, xi0: float, omega: float) -> None:
    spring = complex(body.c, body.b * omega)
    answer = xi0 * spring / (spring - body.m * omega**2)
    found = base(body, xi0, omega)
    assert found.amplitude == pytest.approx(abs(answer))
    assert found.relative == pytest.approx(abs(answer - xi0), rel=1e-6, abs=1e-12 * xi0)
    assert found.phase == pytest.approx(-phase(answer), abs=1e-9)


def test_the_machine_of_the_domain() -> None:
    """BV-9, BV-10."""
    found = force(MACHINE, 50, 70)
    assert (MACHINE.omega0, MACHINE.n, MACHINE.damping_ratio) == pytest.approx((40, 4, 0.1))
    assert found.amplitude == pytest.approx(0.0007468978533, rel=1e-9)
    assert (found.force_to_base, found.transmissibility) == pytest.approx((25.32237083, 0.5064474165), rel=1e-9)
    assert degrees(found.phase) == pytest.approx(170.3688302, rel=1e-9)
    assert (MACHINE.isolates_from, MACHINE.peak) == pytest.approx((56.56854249, 39.59797975), rel=1e-9)
    shaken = base(MACHINE, 0.001, 70)
    assert (shaken.amplitude, shaken.relative) == pytest.approx((0.0005064474165, 0.001463919793), rel=1e-9)


@given(st.floats(0, 1e4))
def test_every_damping_passes_the_whole_force_at_root_two_of_the_natural_frequency(b: float) -> None:
    body = Oscillator(3, 1200, b)
    assert force(body, 7, body.isolates_from).transmissibility == pytest.approx(1)


def test_the_amplitude_peaks_where_it_is_said_to() -> None:
    assert MACHINE.peak is not None
    top = force(MACHINE, 1, MACHINE.peak).amplitude
    assert all(force(MACHINE, 1, MACHINE.peak * share).amplitude < top for share in (0.99, 1.01))
    assert Oscillator(1, 1, 2).peak is None


def test_a_polyharmonic_process_of_the_domain() -> None:
    """BV-8; its mean square is also the mean over one period."""
    process = (0.0005, (0.002, 0.001), 50.0, (0.3, -0.5))
    assert polyharmonic(*process, 0.02) == pytest.approx(0.003424611357, rel=1e-9)
    assert rms(0.0005, (0.002, 0.001)) == pytest.approx(0.001658312395, rel=1e-9)
    times = [2 * pi / 50 * i / 360 for i in range(360)]
    assert sqrt(sum(polyharmonic(*process, t) ** 2 for t in times) / 360) == pytest.approx(0.001658312395, rel=1e-9)
    assert octaves(10, 12000) == pytest.approx(10.22881869, rel=1e-9)
    assert polyharmonic(0, (1,), 2, (0,), 0.1) == sin(0.2)


@pytest.mark.parametrize("off", [1e-4, 1e-8, -1e-10, 3e-12])
def test_beside_resonance_no_digits_cancel(off: float) -> None:
    """Against sixty decimal digits of the floats themselves."""
    omega = 50 * (1 + off)
    with localcontext(prec=60):
        dynamic = abs(50_000 - 20 * Decimal(omega) ** 2)
        amplitude, force_to_base = float(100 / dynamic), float(100 * 50_000 / dynamic)
    found = force(Oscillator(20, 50_000), 100, omega)
    assert found.amplitude == pytest.approx(amplitude, rel=1e-14)
    assert found.force_to_base == pytest.approx(force_to_base, rel=1e-14)


def test_resonance_without_damping_has_no_answer() -> None:
    with pytest.raises(SingularError, match="resonance at 10"):
        force(Oscillator(1, 100), 1, 10)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: Oscillator(0, 1), "mass m"),
        (lambda: Oscillator(1, nan), "stiffness c"),
        (lambda: Oscillator(1, 1, -1), "damping b"),
        (lambda: force(MACHINE, inf, 1), "F0"),
        (lambda: force(MACHINE, 1, -1), "frequency omega"),
        (lambda: base(MACHINE, 0, 1), "base_amplitude"),
        (lambda: octaves(0, 1), "lower frequency"),
        (lambda: polyharmonic(0, (1, 2), 1, (0,), 0), "1 phases for 2"),
    ],
)
def test_impossible_numbers_are_refused_by_name(make: object, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        make()  # type: ignore[operator]
