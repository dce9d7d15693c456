"""The compose file: hardened services, no secret by default, commands and routes that exist, limits that fit."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest
import yaml

from cli.main import COMMANDS
from server.policy import POLICIES
from server.run import GRACE
from server.settings import Settings
from server.web.envelope import LARGEST_BODY, LARGEST_ROSTER

DEPLOY = Path(__file__).parents[2] / "deploy"
TEXT = (DEPLOY / "compose.yaml").read_text("utf-8")
FILE: dict[str, Any] = yaml.safe_load(TEXT)
SERVICES: dict[str, dict[str, Any]] = FILE["services"]
PROXY = (DEPLOY / "nginx.conf").read_text("utf-8")
KEYS = {  # of a service, as the compose specification names them
    "build", "cap_drop", "command", "depends_on", "environment", "healthcheck", "image", "logging", "networks", "ports",
    "read_only", "restart", "security_opt", "shm_size", "stop_grace_period", "stop_signal", "tmpfs", "user", "volumes",
}  # fmt: skip
LOCATIONS = re.findall(r"location ~ (\S+) \{(.*?)\n        \}", PROXY, re.DOTALL)  # pattern and what is said of it
CONDITIONS = {"service_started", "service_healthy", "service_completed_successfully"}
OURS = ("server", "worker", "migrate")


def seconds(text: str) -> float:
    assert re.fullmatch(r"\d+s", text)
    return float(text[:-1])


def test_the_file_says_only_what_compose_reads() -> None:
    assert set(FILE) - {"x-hardened", "x-grubler"} == {"name", "services", "networks", "volumes"}
    assert {key for service in SERVICES.values() for key in service} <= KEYS
    assert set(SERVICES) == {"proxy", "database", *OURS}


@pytest.mark.parametrize("name", SERVICES)
def test_a_service_runs_as_nobody_special_on_a_root_that_it_cannot_write(name: str) -> None:
    service = SERVICES[name]
    assert service["read_only"] is True and service["cap_drop"] == ["ALL"]
    assert service["security_opt"] == ["no-new-privileges:true"]
    user, _, group = service["user"].partition(":")
    assert int(user) > 0 and int(group) > 0
    assert any(place.startswith("/tmp:") for place in service["tmpfs"])
    assert "privileged" not in service and "docker.sock" not in str(service)


@pytest.mark.parametrize("name", SERVICES)
def test_an_image_is_named_with_its_version(name: str) -> None:
    image = SERVICES[name]["image"]
    assert re.fullmatch(r"[a-z/-]+:(\d+(\.\d+)+-[a-z]+|\$\{GRUBLER_VERSION:\?[^}]+\})", image)


@pytest.mark.parametrize("name", SERVICES)
def test_a_service_tells_how_it_is_and_is_asked_within_its_time(name: str) -> None:
    check = SERVICES[name]["healthcheck"]
    if name == "migrate":  # it ends by itself, and the others wait for that
        assert check == {"disable": True} and SERVICES[name]["restart"] == "no"
        return
    assert check["test"][0] == "CMD" and seconds(check["timeout"]) < seconds(check["interval"])
    assert SERVICES[name]["restart"] == "unless-stopped"


def test_no_secret_has_a_default_and_none_is_written_down() -> None:
    assert not re.findall(r"\$\{[A-Z_]+(?::?-[^}]*)?\}", TEXT)  # ${NAME} is empty and ${NAME:-x} is x where not given
    asked = set(re.findall(r"\$\{([A-Z_]+):\?[^}]+\}", TEXT))
    assert asked == {"GRUBLER_VERSION", "GRUBLER_DATABASE_PASSWORD", "GRUBLER_NAME", "GRUBLER_TLS"}
    for service in SERVICES.values():
        for name, value in service.get("environment", {}).items():
            if re.search("PASSWORD|SECRET|TOKEN", name):
                assert value.startswith("${")
    assert "postgresql://grubler@" in TEXT  # the password comes apart, so that it may hold any character
    assert "HOST_AUTH_METHOD" not in TEXT and "scram-sha-256" in TEXT


@pytest.mark.parametrize("name", OURS)
def test_a_service_of_ours_runs_a_command_that_exists_on_the_shared_store(name: str) -> None:
    service = SERVICES[name]
    assert service["command"][0] in COMMANDS
    assert Settings(database_url=service["environment"]["DATABASE_URL"]).store_url.endswith("@database/grubler")
    assert service["environment"]["GRUBLER_PUBLIC_URL"].startswith("https://")
    assert service["networks"] == ["inside"] and "ports" not in service


def test_services_wait_for_what_they_need() -> None:
    for service in SERVICES.values():
        for other, how in service.get("depends_on", {}).items():
            assert other in SERVICES and how["condition"] in CONDITIONS
    for name in ("server", "worker"):
        assert SERVICES[name]["depends_on"]["migrate"]["condition"] == "service_completed_successfully"


def test_only_the_proxy_is_reached_from_outside() -> None:
    assert [name for name, service in SERVICES.items() if "ports" in service] == ["proxy"]
    assert FILE["networks"]["inside"] == {"internal": True}
    assert set(SERVICES["proxy"]["networks"]) == set(FILE["networks"])


def test_what_is_under_way_has_its_time_when_services_end() -> None:
    assert all(seconds(SERVICES[name]["stop_grace_period"]) > GRACE for name in ("server", "worker", "proxy"))


def test_the_proxy_takes_what_the_server_takes_and_passes_events_on_at_once() -> None:
    for path in ("/courses/{course}/roster", "/api/v1/courses/{course}/roster"):
        assert ("POST", path) in POLICIES
        rosters = next(one for one in LOCATIONS if re.fullmatch(one[0], path))
        assert int(re.findall(r"client_max_body_size (\d+)k;", rosters[1])[0]) * 1024 > LARGEST_ROSTER
    size = re.search(r"client_max_body_size (\d+)k;", PROXY)
    assert size and int(size[1]) * 1024 > LARGEST_BODY
    pattern = re.search(r"location ~ (\S+) \{[^}]*proxy_buffering off;", PROXY)
    paths = {path.replace("{job}", "AAAA-AAAA-AAAA") for _, path in POLICIES}
    assert pattern and {path for path in paths if re.search(pattern[1], path)} == {
        path for path in paths if path.endswith("/events")
    }


def test_the_proxy_speaks_https_alone_and_says_who_asks_itself() -> None:
    assert PROXY.count("{") == PROXY.count("}")
    assert "return 308 https://" in PROXY and "ssl_protocols TLSv1.2 TLSv1.3;" in PROXY
    assert "X-Forwarded-For $remote_addr;" in PROXY and "$proxy_add_x_forwarded_for" not in PROXY
    connections = re.search(r"limit_conn connections (\d+);", PROXY)
    assert connections and int(connections[1]) >= 60 * 6  # a class behind one address
    assert "Retry-After 5 always" in PROXY
