"""A small OpenID Connect issuer on loopback that can be told to lie."""

from __future__ import annotations

import base64
import json
import secrets
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from hashlib import sha256
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from threading import Thread
from typing import Any
from urllib.parse import parse_qs, parse_qsl, urlsplit

from joserfc import jwt
from joserfc.jwk import ECKey

CLIENT, PASSWORD = "grubler", "between us"
KEY, OTHER_KEY = (ECKey.generate_key("P-256", auto_kid=True) for _ in range(2))


@dataclass
class Issuer:
    """The issuer: `claims` and `described` replace what it would say, `key` what it signs with."""

    address: str = ""
    claims: dict[str, Any] = field(default_factory=dict)
    described: dict[str, Any] = field(default_factory=dict)
    key: ECKey = field(default_factory=lambda: KEY)
    padding: str = ""
    codes: dict[str, dict[str, str]] = field(default_factory=dict)

    def consent(self, location: str) -> str:
        """Agree to what a browser was sent here with; gives the query it comes back with."""
        asked = dict(parse_qsl(urlsplit(location).query))
        code = secrets.token_urlsafe(8)
        self.codes[code] = asked
        return f"state={asked['state']}&code={code}"

    def answer(self, path: str, form: dict[str, list[str]]) -> tuple[int, dict[str, Any]]:
        """Answer a request of the server."""
        if path == "/.well-known/openid-configuration":
            places = {
                name: f"{self.address}/{name}" for name in ("authorization_endpoint", "token_endpoint", "jwks_uri")
            }
            return 200, {"issuer": self.address, "padding": self.padding} | places | self.described
        if path == "/jwks_uri":
            return 200, {"keys": [KEY.as_dict(private=False)]}
        return self._token({name: values[0] for name, values in form.items()})

    def _token(self, form: dict[str, str]) -> tuple[int, dict[str, Any]]:
        asked = self.codes.pop(form.get("code", ""), None)
        proof = base64.urlsafe_b64encode(sha256(form["code_verifier"].encode()).digest()).rstrip(b"=").decode()
        if asked is None or asked["code_challenge"] != proof or form.get("client_secret") != PASSWORD:
            return 400, {"error": "invalid_grant"}
        claims = {
            "iss": self.address, "aud": CLIENT, "sub": "u1", "name": "Olga Uczelniana", "nonce": asked["nonce"],
            "iat": int(time.time()), "exp": int(time.time()) + 60,
        }  # fmt: skip
        header = {"alg": "ES256", "kid": KEY.kid}
        return 200, {"id_token": jwt.encode(header, claims | self.claims, self.key, algorithms=["ES256"])}


@contextmanager
def running() -> Iterator[Issuer]:
    """Run an issuer on a free port of loopback."""
    issuer = Issuer()

    class Handler(BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            self._reply({})

        def do_POST(self) -> None:
            self._reply(parse_qs(self.rfile.read(int(self.headers["content-length"])).decode()))

        def _reply(self, form: dict[str, list[str]]) -> None:
            status, body = issuer.answer(self.path, form)
            raw = json.dumps(body).encode()
            self.send_response(status)
            self.send_header("Content-Length", str(len(raw)))
            self.end_headers()
            self.wfile.write(raw)

        def log_message(self, format: str, *args: Any) -> None:
            """Say nothing."""

    server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    issuer.address = f"http://127.0.0.1:{server.server_port}"
    Thread(target=server.serve_forever, args=(0.05,), daemon=True).start()
    yield issuer
    server.shutdown()
    server.server_close()
