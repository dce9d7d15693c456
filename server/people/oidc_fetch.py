"""Calls to a registered issuer and to where it sends us: https, no private address, no redirect, a bounded answer."""

from __future__ import annotations

import json
import socket
import ssl
from collections.abc import Mapping
from http.client import HTTPConnection, HTTPException, HTTPSConnection
from ipaddress import ip_address
from typing import Any
from urllib.parse import urlencode, urlsplit

LARGEST = 256 * 1024  # bytes of an answer
PATIENCE = 5.0  # s


class Unreachable(RuntimeError):
    """The issuer does not answer as it should; the message says why."""


def fetch(issuer: str, url: str, form: Mapping[str, str] | None = None) -> dict[str, Any]:
    """Get a JSON object from the issuer, or post a form to it.

    Args:
        issuer: The registered issuer; plain http and a loopback address are for an issuer that itself is there.
        url: What is fetched: at the issuer's own address, or over https on another public host.
        form: What is posted.

    Raises:
        Unreachable: A place that is not to be asked, no answer in time, too much of it, or no JSON object.
    """
    if not trusted(issuer, url):
        raise Unreachable(f"{url} is not asked for {issuer}")
    try:
        there = urlsplit(url)
        return _asked(there.scheme, there.hostname or "", there.port, _path(url), form)
    except (OSError, HTTPException, ValueError) as error:
        raise Unreachable(str(error)) from error


def trusted(issuer: str, url: str) -> bool:
    """Whether an issuer may send us there: to its own address, or to another host over https at the usual port.

    Whether the host has a public address is seen when it is asked.
    """
    try:
        ours, there = urlsplit(issuer), urlsplit(url)
        if (there.scheme, there.netloc) == (ours.scheme, ours.netloc):
            return True
        named = there.hostname is not None and there.username is None and there.password is None
        return named and there.scheme == "https" and there.port in (None, 443) and not _loopback(there.hostname or "")
    except ValueError:
        return False


def _asked(scheme: str, host: str, port: int | None, path: str, form: Mapping[str, str] | None) -> dict[str, Any]:
    connection = _connection(scheme, host, port)
    try:
        headers = {"Accept": "application/json"}
        if form is None:
            connection.request("GET", path, headers=headers)
        else:
            posted = {"Content-Type": "application/x-www-form-urlencoded"}
            connection.request("POST", path, urlencode(form), headers | posted)
        with connection.getresponse() as reply:
            raw = reply.read(LARGEST + 1)
    finally:
        connection.close()
    if reply.status != 200 or len(raw) > LARGEST:
        raise Unreachable(f"{path} answers {reply.status} with {len(raw)} bytes")
    answer = json.loads(raw)
    if not isinstance(answer, dict):
        raise Unreachable(f"{path} answers no JSON object")
    return answer


def _connection(scheme: str, host: str, port: int | None) -> HTTPConnection:
    """Connect to the address that was checked: a name that is resolved again could lead elsewhere."""
    address = _address(scheme, host, port or (443 if scheme == "https" else 80))
    wire = socket.create_connection(address, timeout=PATIENCE)
    if scheme == "https":
        secure = HTTPSConnection(host, port, timeout=PATIENCE)
        try:
            secure.sock = ssl.create_default_context().wrap_socket(wire, server_hostname=host)
        except OSError:
            wire.close()
            raise
        return secure
    plain = HTTPConnection(host, port, timeout=PATIENCE)
    plain.sock = wire
    return plain


def _address(scheme: str, host: str, port: int) -> tuple[str, int]:
    named_loopback = _loopback(host)
    if scheme != "https" and not named_loopback:
        raise Unreachable(f"{host} is not asked over plain http")
    found = {str(info[4][0]) for info in socket.getaddrinfo(host, port, type=socket.SOCK_STREAM)}
    for address in found:
        if not ip_address(address).is_global and not (named_loopback and ip_address(address).is_loopback):
            raise Unreachable(f"{host} has the private address {address}")
    return sorted(found)[0], port


def _loopback(host: str) -> bool:
    try:
        return ip_address(host).is_loopback
    except ValueError:
        return False


def _path(url: str) -> str:
    there = urlsplit(url)
    return (there.path or "/") + (f"?{there.query}" if there.query else "")
