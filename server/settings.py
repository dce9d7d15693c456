"""What a server is told before it starts: where it listens, where it keeps its data, who may reach it."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from ipaddress import ip_address
from pathlib import Path
from urllib.parse import urlsplit

DEFAULT_PORT = 8000
HIGHEST_PORT = 65535
MOST_WORKERS = 256
LOGS = ("text", "json")


class SettingsError(ValueError):
    """A setting cannot be used; the message names it and says why."""


@dataclass(frozen=True, slots=True)
class Provider:
    """The one OpenID Connect issuer that may vouch for people; it tells its endpoints, on public hosts over https.

    Attributes:
        issuer: Its address: https, or plain http on a loopback address.
        client_id: How it knows this server.
        client_secret: What this server shows there; none for a public client.
    """

    issuer: str
    client_id: str
    client_secret: str | None = field(default=None, repr=False)


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
        provider: Who else vouches for people.
        workers: Batches of jobs that are done at a time; with PostgreSQL 0 leaves them all to `grubler worker`.
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
    provider: Provider | None = None
    workers: int = os.cpu_count() or 1

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
        SettingsError: GRUBLER_PORT is not a port, GRUBLER_LOG no kind of log, or the issuer is named by halves.
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
        provider=_provider(environ),
        workers=_workers(environ.get("GRUBLER_WORKERS") or str(os.cpu_count() or 1)),
    )


def _provider(environ: Mapping[str, str]) -> Provider | None:
    issuer, client = environ.get("GRUBLER_OIDC_ISSUER"), environ.get("GRUBLER_OIDC_CLIENT_ID")
    if not issuer and not client:
        return None
    if not issuer or not client or urlsplit(issuer).scheme not in ("https", "http"):
        raise SettingsError("GRUBLER_OIDC_ISSUER must be an address, with GRUBLER_OIDC_CLIENT_ID beside it")
    return Provider(issuer, client, environ.get("GRUBLER_OIDC_CLIENT_SECRET") or None)


def _workers(text: str) -> int:
    if not (text.isascii() and text.isdecimal() and int(text[:3]) <= MOST_WORKERS and len(text) <= 3):
        raise SettingsError(f"GRUBLER_WORKERS must be a whole number from 0 to {MOST_WORKERS}, not {text!r}")
    return int(text)


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
