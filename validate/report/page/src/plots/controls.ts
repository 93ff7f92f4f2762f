// Controls of the plots; each is bound to a key of the page's state.
import { getState, onStateChange, setState } from "../state";

export interface Option {
  value: string;
  text: string;
  /** Options of one group are listed together under its name. */
  group?: string;
}

/** `fallback`: the choice if the state has none, or one that isn't among the options. */
export function chooser(label: string, key: string, options: Option[], fallback: () => string): HTMLElement {
  const select = document.createElement("select");
  const groups = new Map<string, HTMLOptGroupElement>();
  for (const { value, text, group } of options) {
    const option = new Option(text, value);
    if (group === undefined) {
      select.append(option);
      continue;
    }
    let parent = groups.get(group);
    if (!parent) {
      parent = document.createElement("optgroup");
      parent.label = group;
      groups.set(group, parent);
      select.append(parent);
    }
    parent.append(option);
  }
  const show = () => {
    select.value = chosen(key, options, fallback);
  };
  select.addEventListener("change", () => setState(key, select.value));
  onStateChange(show);
  show();
  return labeled(label, key, select);
}

export function chosen(key: string, options: Option[], fallback: () => string): string {
  const value = getState(key);
  return value !== undefined && options.some((option) => option.value === value) ? value : fallback();
}

/** The state is "1" if it is on. */
export function toggle(label: string, key: string): HTMLElement {
  const box = document.createElement("input");
  box.type = "checkbox";
  const show = () => {
    box.checked = getState(key) === "1";
  };
  box.addEventListener("change", () => setState(key, box.checked ? "1" : undefined));
  onStateChange(show);
  show();
  const whole = labeled(label, key, box);
  whole.classList.add("toggle");
  return whole;
}

function labeled(text: string, key: string, control: HTMLElement): HTMLElement {
  const label = document.createElement("label");
  label.textContent = text;
  label.htmlFor = control.id = `control-${key}`;
  const field = document.createElement("div");
  field.className = "plot-field";
  field.append(label, control);
  return field;
}
