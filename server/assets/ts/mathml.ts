/* The preview's MathML is rebuilt node by node: only presentation elements and harmless attributes pass. */

const NAMESPACE = "http://www.w3.org/1998/Math/MathML";
const ELEMENTS = new Set(
  (
    "math mrow mi mn mo mtext mspace ms mfrac msqrt mroot msub msup msubsup munder mover munderover " +
    "mmultiscripts mprescripts none mtable mtr mtd mstyle mpadded mphantom merror"
  ).split(" "),
);
const ATTRIBUTES = new Set(
  (
    "accent accentunder columnalign columnspan depth dir display displaystyle fence form height largeop linethickness " +
    "lspace mathvariant maxsize minsize movablelimits rowspan rspace scriptlevel separator stretchy symmetric voffset width"
  ).split(" "),
);
const VALUE = /^[\w.%+ -]{0,40}$/;

export function allowsElement(name: string): boolean {
  return ELEMENTS.has(name);
}

export function allowsAttribute(name: string, value: string): boolean {
  return ATTRIBUTES.has(name) && VALUE.test(value);
}

function copy(source: Element): Element {
  const target = document.createElementNS(NAMESPACE, source.localName);
  for (const { name, value } of source.attributes) {
    if (allowsAttribute(name, value)) target.setAttribute(name, value);
  }
  for (const child of source.childNodes) {
    if (child.nodeType === Node.TEXT_NODE) target.append(child.nodeValue ?? "");
    else if (child instanceof Element && allowsElement(child.localName)) target.append(copy(child));
  }
  return target;
}

/** All top-level formulas of a text, read as XML: the parsed document is inert and is thrown away; damaged text gives none. */
export function readMathML(text: string): Element[] {
  const parsed = new DOMParser().parseFromString(`<lines>${text}</lines>`, "application/xml");
  if (parsed.querySelector("parsererror") !== null) return [];
  return Array.from(parsed.documentElement.children)
    .filter((node) => node.localName === "math")
    .map(copy);
}
