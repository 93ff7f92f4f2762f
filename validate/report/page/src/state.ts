// The state of the page: a flat map of strings, kept in the fragment of the address in the form of
// URLSearchParams, so that a reload or a copied address shows the same. A fragment without '=' is an anchor
// of the page and doesn't change the state.

export type StateListener = (changed: ReadonlySet<string>) => void;

/** Browsers refuse more than about 200 changes of the address in 30 s. */
const kWriteDelayMs = 200;

let values = parse(location.hash) ?? new Map<string, string>();
const listeners: StateListener[] = [];
let pendingWrite: number | undefined;

export function getState(key: string): string | undefined {
  return values.get(key);
}

/** undefined removes the key. */
export function setState(key: string, value: string | undefined): void {
  updateState({ [key]: value });
}

/** Changes several keys; listeners are called once. */
export function updateState(changes: { [key: string]: string | undefined }): void {
  const next = new Map(values);
  for (const [key, value] of Object.entries(changes)) {
    if (value === undefined) next.delete(key);
    else next.set(key, value);
  }
  if (replaceValues(next)) pendingWrite ??= window.setTimeout(writeAddress, kWriteDelayMs);
}

/** Called after any change, by the page or by a new address, with the keys that changed. */
export function onStateChange(listener: StateListener): void {
  listeners.push(listener);
}

/** Returns undefined for an anchor. */
function parse(hash: string): Map<string, string> | undefined {
  return hash.includes("=") ? new Map(new URLSearchParams(hash.slice(1))) : undefined;
}

/** Returns whether anything changed. */
function replaceValues(next: Map<string, string>): boolean {
  const keys = new Set([...values.keys(), ...next.keys()]);
  const changed = new Set([...keys].filter((key) => values.get(key) !== next.get(key)));
  values = next;
  if (changed.size > 0) for (const listener of listeners) listener(changed);
  return changed.size > 0;
}

function writeAddress(): void {
  window.clearTimeout(pendingWrite);
  pendingWrite = undefined;
  const text = new URLSearchParams([...values]).toString();
  history.replaceState(history.state, "", text ? `#${text}` : location.pathname + location.search);
}

window.addEventListener("hashchange", () => {
  const next = parse(location.hash);
  if (next) replaceValues(next);
});
window.addEventListener("pagehide", () => {
  if (pendingWrite !== undefined) writeAddress();
});
