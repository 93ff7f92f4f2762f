// Creates elements in one expression. Texts are set as text, never as markup, because names in a report are
// untrusted.

type Attributes = { [name: string]: string | number | boolean | ((event: Event) => void) };

/**
 * Attributes by name: true sets an empty one, false leaves it out, a function is a listener of the event of
 * that name. /
 */
export function make<Tag extends keyof HTMLElementTagNameMap>(
  tag: Tag,
  attributes: Attributes = {},
  ...children: (Node | string)[]
): HTMLElementTagNameMap[Tag] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") element.addEventListener(name, value);
    else if (value !== false) element.setAttribute(name, value === true ? "" : String(value));
  }
  element.append(...children);
  return element;
}

/** Sets the text only if it differs, so that an equal one doesn't cause a new layout. */
export function setText(element: Element, text: string): void {
  if (element.textContent !== text) element.textContent = text;
}

export interface Choice {
  value: string;
  label: string;
  /** Why it can't be chosen; it is listed as disabled. */
  reason?: string;
}

/** Replaces the options and the choice of a select. */
export function setOptions(select: HTMLSelectElement, choices: readonly Choice[], chosen: string): void {
  const signature = JSON.stringify(choices);
  if (select.dataset.choices !== signature) {
    select.dataset.choices = signature;
    select.replaceChildren(
      ...choices.map(({ value, label, reason }) =>
        make(
          "option",
          reason ? { value, disabled: true, title: reason } : { value },
          reason ? `${label} (${reason})` : label,
        ),
      ),
    );
  }
  select.value = chosen;
}
