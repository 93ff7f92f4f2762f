// Keys of the viewer.
import { make } from "./dom";

export interface KeyActions {
  arrange(arrangement: "side" | "wipe" | "blend", paneCount?: number): void;
  /** Flicker: to the other of the two; into it from elsewhere. */
  flicker(): void;
  zoomBy(factor: number): void;
  fit(): void;
  moveCursor(dx: number, dy: number): void;
  releaseCursor(): void;
}

const kHelp: [keys: string, what: string][] = [
  ["← → ↑ ↓", "in a picture: move the pixel that is read; with Shift by 10"],
  ["Esc", "let go of the pixel"],
  ["+ −", "closer, farther"],
  ["0", "the whole frame"],
  ["1 2 3 4", "so many panes side by side"],
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

/** Heard where the focus is in the viewer, or nowhere and the pointer is over it. No key is taken from a field. */
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
    const isHeard = root.contains(target) || (target === document.body && root.matches(":hover"));
    if (!isHeard || event.ctrlKey || event.altKey || event.metaKey || takesLetters(target)) return;
    const arrow = target.classList.contains("pane-view") ? arrows[event.key] : undefined;
    const step = event.shiftKey ? 10 : 1;
    const action = arrow ? () => actions.moveCursor(arrow[0] * step, arrow[1] * step) : others[event.key.toLowerCase()];
    if (!action) return;
    event.preventDefault();
    if (event.repeat && action === others.f) return; // a key held down would flash faster than is safe
    action();
  });
}

/** Menus find entries by letters. */
function takesLetters(target: HTMLElement): boolean {
  return target.matches("select, textarea, input:not([type=range], [type=checkbox]), [contenteditable]");
}
