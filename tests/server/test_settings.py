"""Settings are read from the environment, and an unsafe bind is refused."""

from __future__ import annotations

from pathlib import Path

import pytest

from server.settings import Settings, SettingsError, check, from_environment


def test_what_is_given_by_name_goes_before_the_environment() -> None:
    environ = {"GRUBLER_PORT": "9000", "GRUBLER_DATA_DIR": "/d", "GRUBLER_SECRET": "s"}
    assert from_environment(environ) == Settings(Path("/d"), port=9000, secret=b"s")
    assert from_environment(environ, port=1, data_dir="/e", host="::1") == Settings(Path("/e"), "::1", 1, secret=b"s")
    assert from_environment({}) == Settings()


@pytest.mark.parametrize("port", ["", "0", "65536", "-1", "8e3", "٣"])
def test_what_is_no_port_is_refused_by_its_text(port: str) -> None:
    with pytest.raises(SettingsError, match="port"):
        from_environment({"GRUBLER_PORT": port or "x"})


def test_postgresql_is_reached_through_psycopg_whatever_its_scheme(tmp_path: Path) -> None:
    for scheme in ("postgres", "postgresql", "postgresql+psycopg"):
        assert Settings(tmp_path, database_url=f"{scheme}://u@h/d").store_url == "postgresql+psycopg://u@h/d"
    assert Settings(tmp_path).store_url == f"sqlite:///{tmp_path}/grubler.sqlite3"


def test_another_database_is_refused() -> None:
    with pytest.raises(SettingsError, match="postgresql"):
        _ = Settings(database_url="mysql://h/d").store_url


def refusal(settings: Settings) -> str | None:
    try:
        check(settings)
    except SettingsError as error:
        return str(error)
    return None


@pytest.mark.parametrize("host", ["127.0.0.1", "127.9.9.9", "::1", "localhost"])
def test_loopback_needs_no_https(host: str) -> None:
    assert refusal(Settings(host=host)) is None


@pytest.mark.parametrize("host", ["0.0.0.0", "::", "10.0.0.5", "example.org"])
def test_another_address_needs_https_in_front_or_a_word_for_it(host: str) -> None:
    with pytest.raises(SettingsError, match="plain http"):
        check(Settings(host=host))
    with pytest.raises(SettingsError):
        check(Settings(host=host, public_url="http://grubler.example.org"))
    assert refusal(Settings(host=host, public_url="https://grubler.example.org")) is None
    assert refusal(Settings(host=host, insecure_http=True)) is None
