/* One press, one attempt: while the answers travel the button says so and does nothing. */

function release(button: HTMLElement): void {
  if (button.dataset["label"] === undefined) return;
  button.textContent = button.dataset["label"];
  delete button.dataset["label"];
  button.removeAttribute("aria-disabled");
}

function hold(button: HTMLElement): void {
  button.dataset["label"] = button.textContent ?? "";
  button.textContent = button.dataset["sending"] ?? button.textContent;
  button.setAttribute("aria-disabled", "true"); // `disabled` would drop the focus and the button's own value
}

/** Guards a form whose button carries `data-sending`, the words to show while it is on its way. */
export function guardSubmit(form: HTMLFormElement): void {
  const button = form.querySelector<HTMLElement>("button[data-sending]");
  if (button === null) return;
  form.addEventListener("submit", (event) => {
    if (button.dataset["label"] === undefined) hold(button);
    else event.preventDefault();
  });
  window.addEventListener("pageshow", () => release(button)); // back from the next page
}
