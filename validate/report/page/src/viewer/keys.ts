// Keys of the viewer.
import { make } from "./dom";

export interface KeyActions {
  arrange(arrangement: "side" | "wipe" | "blend", paneCount?: number): void;
  /** Swaps the two panes in the flicker arrangement, enters it from others. */
  flicker(): void;
  zoomBy(factor: number): void;
  fit(): void;
  moveCursor(dx: number, dy: number): void;
  releaseCursor(): void;
}

const kHelp: [keys: string, what: string][] = [
  ["← → ↑ ↓", "in a picture: move the pixel that is read; with Shift by 10"],
  ["Esc", "release the pixel that is held"],
  ["+ −", "zoom in, zoom out"],
  ["0", "fit the whole frame"],
  ["1 2 3 4", "number of panes side by side"],
  ["W", "wipe between the first two panes"],
  ["F", "flicker: swap the first two panes"],
  ["B", "blend the first two panes"],
  ["wheel, drag, pinch, double click", "zoom and pan all panes"],
  ["click", "hold the pixel that is read"],
];

export function makeKeyHelp(): HTMLElement {
  const rows = kHelp.flatMap(([keys, what]) => [make("dt", {}, keys), make("dd", {}, what)]);
  return make("details", { class: "keys" }, make("summary", {}, "Keys"), make("dl", {}, ...rows));
}

/**
 * Keys are handled while the focus is in the viewer, or on nothing while the pointer is over the viewer. Keys
 * typed into fields aren't handled. /
 */
export function listenToKeys(root: HTMLElement, actions: KeyActions): void {
  const arrows: { [key: string]: [dx: number, dy: number] } = {
    ArrowLeft: [-1, 0],
    ArrowRight: [1, 0],
    ArrowUp: [0, -1],
    ArrowDown: [0, 1],
  };
  const others: { [key: string]: () => void } = {
    "+": () => actions.zoomBy(2),
    "=": () => actions.zoomBy(2), // the same key without Shift
    "-": () => actions.zoomBy(1 / 2),
    "0": () => actions.fit(),
    w: () => actions.arrange("wipe"),
    b: () => actions.arrange("blend"),
    f: () => actions.flicker(),
    Escape: () => actions.releaseCursor(),
  };
  for (const count of [1, 2, 3, 4]) others[count] = () => actions.arrange("side", count);

  document.addEventListener("keydown", (event) => {
    const target = event.target as HTMLElement;
    const isOurs = root.contains(target) || (target === document.body && root.matches(":hover"));
    if (!isOurs || event.ctrlKey || event.altKey || event.metaKey || takesLetters(target)) return;
    const arrow = target.classList.contains("pane-view") ? arrows[event.key] : undefined;
    const step = event.shiftKey ? 10 : 1;
    const action = arrow
      ? () => actions.moveCursor(arrow[0] * step, arrow[1] * step)
      : others[event.key.toLowerCase()];
    if (!action) return;
    event.preventDefault();
    if (event.repeat && action === others.f) return; // key repeat would flash faster than is safe
    action();
  });
}

/** Menus use letters to choose entries. */
function takesLetters(target: HTMLElement): boolean {
  return target.matches("select, textarea, input:not([type=range], [type=checkbox]), [contenteditable]");
}
