/* Numbers and sentences as the reader's language writes them. */

/** Puts values where a sentence names them. */
export function filled(sentence: string, values: Record<string, string>): string {
  return sentence.replace(/\{(\w+)\}/g, (whole, name: string) => values[name] ?? whole);
}

/** Decimals that show a number of figures of values as large as the scale. */
export function decimals(scale: number, figures: number): number {
  return Math.min(8, Math.max(0, figures - 1 - Math.floor(Math.log10(Math.abs(scale) || 1) + 1e-6)));
}

const CYRILLIC: Record<string, string> = { m: "\u043c", s: "\u0441" };

export class Numbers {
  private readonly language: string;

  constructor(language: string) {
    this.language = language;
  }

  get comma(): boolean {
    return this.language !== "en";
  }

  /** A unit in the letters of the language. */
  unit(unit: string): string {
    return this.language === "ru" ? unit.replace(/[ms]/g, (name) => CYRILLIC[name] ?? name) : unit;
  }

  /** A number with a true minus and a unit parted by a narrow space that does not break; a dash for none. */
  shown(value: number, places: number, unit = ""): string {
    if (!Number.isFinite(value)) return "–";
    const text = Math.abs(value) < 0.5 * 10 ** -places ? (0).toFixed(places) : value.toFixed(places);
    const said = (this.comma ? text.replace(".", ",") : text).replace("-", "\u2212");
    return unit === "" ? said : `${said}\u202f${this.unit(unit)}`;
  }
}
