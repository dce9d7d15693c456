"""The unit for systemd starts a command that exists, with time to end, as nobody special."""

from __future__ import annotations

from pathlib import Path

from cli.main import COMMANDS
from server.run import GRACE
from server.settings import from_environment

UNIT = Path(__file__).parents[2] / "deploy" / "grubler.service"


def service() -> dict[str, str]:
    """Read the section of the service."""
    section = UNIT.read_text("utf-8").partition("[Service]\n")[2].partition("\n\n")[0]
    return dict(line.split("=", 1) for line in section.splitlines())


def test_the_unit_serves_from_the_folder_that_it_may_write() -> None:
    told = service()
    program, command = told["ExecStart"].split()
    assert program == "/opt/grubler/bin/grubler" and command in COMMANDS
    given = dict(pair.split("=") for pair in told["Environment"].split())
    assert from_environment(given).data_dir == Path("/var/lib") / told["StateDirectory"]


def test_the_unit_gives_requests_time_to_end_and_the_process_no_rights() -> None:
    told = service()
    assert int(told["TimeoutStopSec"]) > GRACE
    assert told["User"] != "root" and told["CapabilityBoundingSet"] == "" and told["NoNewPrivileges"] == "yes"
    assert told["ProtectSystem"] == "strict" and told["EnvironmentFile"].startswith("/etc/")
