"""A41: everything is pinned, the image runs as nobody in particular, and holds no package manager of its own making."""

from __future__ import annotations

import json
import re
import tomllib
from pathlib import Path

ROOT = Path(__file__).parents[2]


def test_every_package_of_the_lock_has_its_digest() -> None:
    locked = tomllib.loads((ROOT / "uv.lock").read_text())
    for package in locked["package"]:
        if "registry" in package["source"]:
            files = [*package.get("wheels", []), *([package["sdist"]] if "sdist" in package else [])]
            assert files and all(file["hash"].startswith("sha256:") for file in files), package["name"]


def test_every_package_of_the_pages_is_pinned_with_its_digest() -> None:
    wanted = json.loads((ROOT / "server/assets/package.json").read_text())
    for name, version in {**wanted.get("dependencies", {}), **wanted.get("devDependencies", {})}.items():
        assert re.fullmatch(r"\d+\.\d+\.\d+", version), name
    locked = json.loads((ROOT / "server/assets/package-lock.json").read_text())
    for name, package in locked["packages"].items():
        assert not name or package.get("link") or package["integrity"].startswith("sha512-"), name


def test_the_image_names_an_exact_base_and_a_numeric_user() -> None:
    lines = (ROOT / "Dockerfile").read_text().splitlines()
    (base,) = [line for line in lines if line.startswith("ARG BASE=")]
    assert re.fullmatch(r"ARG BASE=python:\d+\.\d+\.\d+-slim-\w+", base)
    users = [line for line in lines if line.startswith("USER ")]
    assert users and re.fullmatch(r"USER [1-9]\d+:[1-9]\d+", users[-1])
    assert not [line for line in lines if line.startswith(("ADD ", "ARG GRUBLER_SECRET", "ENV GRUBLER_SECRET"))]
    assert any(line.startswith("HEALTHCHECK") for line in lines)
