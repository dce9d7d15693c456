/* What the visual editor announces is English: phrase by phrase it is said in the language of the page. */

export type Phrases = Readonly<Record<string, string>>;

/** Says an announcement in other words: each phrase, the longest first, by what it is called there. */
export function inWords(text: string, phrases: Phrases): string {
  const known = Object.keys(phrases).sort((one, other) => other.length - one.length);
  if (known.length === 0) return text;
  const phrase = new RegExp(`(?<!\\p{L})(?:${known.join("|")})(?!\\p{L})`, "giu");
  return text.replace(phrase, (found) => phrases[found.toLowerCase()] ?? found);
}

/** Keeps the live region of an editor, and the name of its field behind its own label, in these words. */
export function speakIn(phrases: Phrases, live: Element, typed: Element, label: string): void {
  let said = "";
  const retell = (): void => {
    const text = live.textContent ?? "";
    if (text === said) return;
    said = inWords(text, phrases);
    if (said !== text) live.textContent = said;
  };
  const rename = (): void => {
    const [name, front] = [typed.getAttribute("aria-label") ?? "", `${label}: `];
    const now = name.startsWith(front) ? front + inWords(name.slice(front.length), phrases) : name;
    if (now !== name) typed.setAttribute("aria-label", now);
  };
  new MutationObserver(retell).observe(live, { childList: true, characterData: true, subtree: true });
  new MutationObserver(rename).observe(typed, { attributes: true, attributeFilter: ["aria-label"] });
  rename();
}
