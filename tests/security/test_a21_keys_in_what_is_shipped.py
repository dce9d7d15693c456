"""A21: no secret and no answer key stands in the repository, the image's context or the interface's description."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

from starlette.testclient import TestClient

ROOT = Path(__file__).parents[2]
KEYS = re.compile(
    r"-----BEGIN [A-Z ]*PRIVATE KEY|\bAKIA[0-9A-Z]{16}\b|\bghp_[A-Za-z0-9]{36}\b"
    r"|\beyJ[\w-]{20,}\.[\w-]{20,}\.[\w-]{20,}"
)


def tracked() -> list[Path]:
    listed = subprocess.run(["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=True)
    return [ROOT / name for name in listed.stdout.splitlines()]


def test_no_key_or_token_is_in_the_repository() -> None:
    for file in tracked():
        if file.is_file() and file.suffix not in (".png", ".woff2"):
            assert not KEYS.search(file.read_text("utf-8", errors="replace")), file


def test_no_store_and_no_environment_file_is_in_the_repository_or_the_image() -> None:
    names = [file.name for file in tracked()]
    assert not [name for name in names if name.endswith((".sqlite3", ".pem", ".key")) or name.startswith(".env")]
    context = (ROOT / ".dockerignore").read_text().split()
    let_in = {line[1:] for line in context if line.startswith("!")}
    assert "*" in context and not let_in & {".git", "tests", "docs", "benchmarks", "data"}


def test_the_description_of_the_interface_names_no_secret(client: TestClient) -> None:
    described = client.get("/api/v1/openapi.json").text
    assert not KEYS.search(described) and "only the server knows it" not in described
