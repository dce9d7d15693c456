"""The style sheet, scripts and fonts that the asset build has left beside us; pages work without them too."""

from __future__ import annotations

import gzip
import json
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from starlette.datastructures import Headers
from starlette.responses import FileResponse, Response
from starlette.staticfiles import StaticFiles
from starlette.types import Receive, Scope, Send

FOLDER = Path(__file__).parents[1] / "static"
MANIFESTS = ("manifest.json", ".vite/manifest.json")
ENTRY = "main.ts"
FOREVER = "public, max-age=31536000, immutable"  # a built file carries the digest of its content in its name
SHRINKING = (".js", ".css", ".svg")  # fonts are packed already
AN_HOUR = "public, max-age=3600"


@dataclass(frozen=True, slots=True)
class Assets:
    """Addresses of the built style sheets, of the script and of the fonts; none of them before the build."""

    styles: tuple[str, ...] = ()
    script: str | None = None
    fonts: tuple[str, ...] = ()


def find(folder: Path = FOLDER) -> Assets:
    """Read the build's manifest.

    Args:
        folder: The folder that is served as ``/static``.
    """
    for name in MANIFESTS:
        manifest = folder / "build" / name
        if manifest.is_file():
            entry = json.loads(manifest.read_text("utf-8"))[ENTRY]
            styles = tuple(f"/static/build/{style}" for style in entry.get("css", ()))
            fonts = sorted(name for name in entry.get("assets", ()) if name.endswith(".woff2"))
            return Assets(styles, f"/static/build/{entry['file']}", tuple(f"/static/build/{name}" for name in fonts))
    return Assets()


class Static:
    """Serves the folder, with the time each file may be kept."""

    def __init__(self, folder: Path = FOLDER) -> None:
        self._files = StaticFiles(directory=folder, check_dir=False)

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer with one file."""
        path = self._files.get_path(scope)
        response: Response = await self._files.get_response(path, scope)
        if isinstance(response, FileResponse) and path.endswith(SHRINKING):
            response = _shrunk(response, Headers(scope=scope))
        response.headers["Cache-Control"] = FOREVER if path.startswith("build") else AN_HOUR
        await response(scope, receive, send)


def _shrunk(whole: FileResponse, asked: Headers) -> Response:
    """The same file packed, if the browser can unpack it and asks for no part of it."""
    whole.headers["Vary"] = "Accept-Encoding"
    if "gzip" not in asked.get("accept-encoding", "") or "range" in asked:
        return whole
    packed = _packed(str(whole.path), whole.headers["etag"])
    headers = {"Content-Encoding": "gzip", "Vary": "Accept-Encoding"}
    return Response(packed, headers=headers, media_type=whole.media_type)


@lru_cache(maxsize=32)
def _packed(path: str, version: str) -> bytes:
    """Pack a file; `version` changes with it."""
    return gzip.compress(Path(path).read_bytes(), mtime=0)
