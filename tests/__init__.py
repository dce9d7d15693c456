"""Tests, room by room.

Many of their processes import the same libraries. Where the machine keeps no bytecode, they keep it among themselves:
compiling everything anew would cost each of them more than most tests do.
"""

from __future__ import annotations

import os
import sys
from pathlib import Path

BYTECODE = Path(__file__).parents[1] / ".pytest_cache" / "bytecode"

if sys.dont_write_bytecode:
    sys.dont_write_bytecode, sys.pycache_prefix = False, str(BYTECODE)
    os.environ["PYTHONPYCACHEPREFIX"] = str(BYTECODE)
    os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
