"""What a server is told before it starts: where it listens, where it keeps its data, who may reach it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from ipaddress import ip_address
from pathlib import Path
from urllib.parse import urlsplit

DEFAULT_PORT = 8000
HIGHEST_PORT = 65535
LOGS = ("text", "json")


class SettingsError(ValueError):
    """A setting cannot be used; the message names it and says why."""


@dataclass(frozen=True, slots=True)
class Settings:
    """The settings of one server.

    Attributes:
        data_dir: Folder of the embedded store; made on the first start.
        host: Address to listen at.
        port: Port to listen at, 1 to 65535.
        database_url: PostgreSQL instead of the embedded store.
        secret: Server secret; without it one is made on the first start and kept in the store.
        public_url: The address people type, where a proxy stands in front.
        insecure_http: Whether a plain-http address other than loopback is allowed.
        limited: Whether posts of one person and of one address are limited.
        log: "text" for warnings only, "json" for a line of every request.
    """

    data_dir: Path = Path("data")
    host: str = "127.0.0.1"
    port: int = DEFAULT_PORT
    database_url: str | None = None
    secret: bytes | None = None
    public_url: str | None = None
    insecure_http: bool = False
    limited: bool = True
    log: str = "text"

    @property
    def store_url(self) -> str:
        """The store's address in the form that SQLAlchemy reads."""
        if self.database_url is None:
            return f"sqlite:///{self.data_dir.resolve() / 'grubler.sqlite3'}"
        scheme, _, rest = self.database_url.partition("://")
        if scheme.split("+")[0] not in ("postgres", "postgresql"):
            raise SettingsError(f"DATABASE_URL must begin with postgresql://, not with {scheme}://")
        return f"postgresql+psycopg://{rest}"

    @property
    def embedded(self) -> bool:
        """Whether the store is a file of this server alone."""
        return self.database_url is None

    @property
    def https(self) -> bool:
        """Whether people reach the server by https."""
        return self.public_url is not None and urlsplit(self.public_url).scheme == "https"

    @property
    def address(self) -> str:
        """The address people type; links that are handed out begin with it."""
        host = f"[{self.host}]" if ":" in self.host else self.host
        return self.public_url.rstrip("/") if self.public_url else f"http://{host}:{self.port}"

    @property
    def loopback(self) -> bool:
        """Whether only this machine can reach the server."""
        if self.host == "localhost":
            return True
        try:
            return ip_address(self.host).is_loopback
        except ValueError:
            return False


def from_environment(
    environ: Mapping[str, str], *, data_dir: str | None = None, host: str | None = None, port: int | None = None,
    public_url: str | None = None, insecure_http: bool = False,
) -> Settings:  # fmt: skip
    """Make settings from the environment; what is given by name goes before it.

    Raises:
        SettingsError: GRUBLER_PORT is not a port, or GRUBLER_LOG no kind of log.
    """
    secret = environ.get("GRUBLER_SECRET")
    return Settings(
        data_dir=Path(data_dir or environ.get("GRUBLER_DATA_DIR") or "data"),
        host=host or environ.get("GRUBLER_HOST") or "127.0.0.1",
        port=_port(str(port) if port is not None else environ.get("GRUBLER_PORT") or str(DEFAULT_PORT)),
        database_url=environ.get("DATABASE_URL") or None,
        secret=secret.encode() if secret else None,
        public_url=public_url or environ.get("GRUBLER_PUBLIC_URL") or None,
        insecure_http=insecure_http,
        log=_log(environ.get("GRUBLER_LOG") or "text"),
    )


def _log(kind: str) -> str:
    if kind not in LOGS:
        raise SettingsError(f"GRUBLER_LOG is one of {', '.join(LOGS)}, not {kind!r}")
    return kind


def _port(text: str) -> int:
    if not text.isdecimal() or not text.isascii() or not 1 <= int(text) <= HIGHEST_PORT:
        raise SettingsError(f"the port must be a number from 1 to {HIGHEST_PORT}, not {text!r}")
    return int(text)


def check(settings: Settings) -> None:
    """Refuse to be reachable from other machines without https, unless that is asked for.

    Raises:
        SettingsError: The bind would send answers and cookies over a network in the clear.
    """
    if not (settings.loopback or settings.https or settings.insecure_http):
        raise SettingsError(
            f"{settings.host} can be reached by other machines over plain http. Give the https address of the proxy "
            "in front with --public-url (or GRUBLER_PUBLIC_URL), or accept it with --insecure-http."
        )
