// Elements in one expression. Texts are set as text, never as markup: names in a report come from outside.

type Attributes = { [name: string]: string | number | boolean | ((event: Event) => void) };

/**
 * Attributes by name: true sets an empty one, false leaves it out, a function listens to the event of that
 * name.
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

/** Writes only a text that differs, so that an equal one doesn't cost a new layout. */
export function setText(element: Element, text: string): void {
  if (element.textContent !== text) element.textContent = text;
}

export interface Choice {
  value: string;
  label: string;
  /** Why it can't be chosen; it is listed, disabled. */
  reason?: string;
}

/** Replaces a select's options and its choice. */
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
