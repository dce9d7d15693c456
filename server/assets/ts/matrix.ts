/* Matrix grids: Tab goes by entry as anywhere, Ctrl and an arrow by row and column. */

const STEPS: Record<string, readonly [number, number]> = {
  ArrowUp: [-1, 0],
  ArrowDown: [1, 0],
  ArrowLeft: [0, -1],
  ArrowRight: [0, 1],
};

/** The name of the entry an arrow leads to: from `answer.T.2.3`, ArrowUp gives `answer.T.1.3`. */
export function neighbour(name: string, key: string): string | null {
  const step = STEPS[key];
  const entry = /^(.+)\.(\d+)\.(\d+)$/.exec(name);
  if (step === undefined || entry === null) return null;
  return `${entry[1]}.${Number(entry[2]) + step[0]}.${Number(entry[3]) + step[1]}`;
}

export function moveInGrid(form: HTMLFormElement): void {
  form.addEventListener("keydown", (event) => {
    const { target } = event;
    if (!event.ctrlKey || !(target instanceof HTMLInputElement)) return;
    const name = neighbour(target.name, event.key);
    const entry = name === null ? null : form.elements.namedItem(name);
    if (!(entry instanceof HTMLInputElement)) return;
    event.preventDefault();
    entry.focus();
    entry.select();
  });
}
