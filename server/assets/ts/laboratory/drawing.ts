/* Shapes as data, painted into a group of a drawing; what is there is changed, not made again. */

export type Shape = readonly [tag: string, attributes: Record<string, string | number>, text?: string];

const NAMESPACE = "http://www.w3.org/2000/svg";

/** Makes the group show exactly these shapes. */
export function paint(group: Element, shapes: readonly Shape[]): void {
  shapes.forEach(([tag, attributes, text], at) => {
    let node = group.children[at];
    if (node?.localName !== tag) {
      const fresh = document.createElementNS(NAMESPACE, tag);
      if (node === undefined) group.append(fresh);
      else node.replaceWith(fresh);
      node = fresh;
    }
    for (const { name } of [...node.attributes]) if (!(name in attributes)) node.removeAttribute(name);
    for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, String(value));
    if (text !== undefined && node.textContent !== text) node.textContent = text;
  });
  while (group.children.length > shapes.length) group.lastElementChild!.remove();
}

/** Adds an empty group to a drawing. */
export function layer(drawing: Element): Element {
  const group = document.createElementNS(NAMESPACE, "g");
  drawing.append(group);
  return group;
}

/** A polyline through screen points; it is broken where a point is missing. */
export function path(points: readonly (readonly [number, number])[]): string {
  let [way, pen] = ["", "M"];
  for (const [x, y] of points) {
    if (Number.isFinite(x + y)) [way, pen] = [`${way}${pen}${x.toFixed(1)} ${y.toFixed(1)}`, "L"];
    else pen = "M";
  }
  return way;
}

/** A round step of an axis: 1, 2 or 5 times a power of ten, not under the least. */
export function roundStep(least: number): number {
  const power = 10 ** Math.floor(Math.log10(least));
  return (power * [1, 2, 5, 10].find((one) => one * power >= least * (1 - 1e-9))!);
}
