"""What the checks of `.ci/` ask a running server or an image; needs nothing but Python's own library.

probe.py get URL         does it answer?
probe.py practise URL    catalogue, a variant, a submission, its grade
probe.py image < JSON    the promises of an image, from `buildah inspect`
"""

from __future__ import annotations

import json
import sys
import urllib.error
import urllib.request
from http.cookiejar import CookieJar
from typing import Any

OPENER = urllib.request.build_opener(urllib.request.HTTPCookieProcessor(CookieJar()))


def ask(url: str, body: dict[str, Any] | None = None) -> Any:
    """Ask for JSON, with a body by POST."""
    data = None if body is None else json.dumps(body).encode()
    request = urllib.request.Request(url, data, {"Content-Type": "application/json", "Accept-Language": "en"})
    with OPENER.open(request, timeout=30) as response:
        return json.loads(response.read())


def get(url: str) -> int:
    """Tell whether something answers."""
    try:
        ask(url)
    except (urllib.error.URLError, ConnectionError, TimeoutError):
        return 1
    return 0


def practise(url: str) -> int:
    """Do what a student does: choose, read, answer, and be told."""
    listed = [entry["id"] for entry in ask(f"{url}/api/v1/exercises")["exercises"]]
    assert "slider_crank" in listed, listed
    variant = ask(f"{url}/api/v1/exercises/slider_crank/variants", {"seed": 3})
    answers = {"l3": "261.87 mm", "omega2": "1 rad/s", "alpha2": "2 )("}
    graded = ask(f"{url}/api/v1/variants/{variant['id']}/submissions", {"answers": answers})
    outcomes = {name: graded["verdicts"][name]["outcome"] for name in answers}
    assert outcomes == {"l3": "right", "omega2": "wrong", "alpha2": "unreadable"}, graded
    again = ask(f"{url}/api/v1/submissions/{graded['receipt']['id']}")
    assert again["score"] == graded["score"] > 0, again
    print(f"served {len(listed)} exercises, graded {outcomes}")
    return 0


def image() -> int:
    """Check user, volume, health check and command of an image."""
    config = json.load(sys.stdin)["Docker"]["config"]
    assert config["User"] == "10001:10001", config
    assert list(config["Volumes"]) == ["/data"], config
    assert config["Healthcheck"]["Test"][0] == "CMD", config
    assert (config["Entrypoint"], config["Cmd"]) == (["grubler"], ["serve", "--insecure-http"]), config
    return 0


if __name__ == "__main__":
    command, *arguments = sys.argv[1:]
    sys.exit({"get": get, "practise": practise, "image": image}[command](*arguments))
