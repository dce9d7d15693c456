/* Seconds until a refused request may be sent again: `<p data-countdown="12">… <span>12</span> s</p>`. */

/** Counts the number in the line down to 0 and then removes the line. */
export function countDown(line: HTMLElement): void {
  const place = line.querySelector("span");
  let left = Number(line.dataset["countdown"]);
  if (place === null || !Number.isFinite(left)) return;
  const timer = window.setInterval(() => {
    left -= 1;
    place.textContent = String(left);
    if (left > 0) return;
    clearInterval(timer);
    line.remove();
  }, 1000);
}
