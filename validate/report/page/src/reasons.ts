// Makes the reasons of absent figures readable without hovering: numbers next to the dashes, a list below the
// table.
import "./reasons.css";
import { make } from "./viewer/dom";

/** Applies to every table with cells whose title is a reason. */
export function listReasons(): void {
  for (const [index, table] of [...document.querySelectorAll(".wide > table")].entries()) {
    const cells = [...table.querySelectorAll<HTMLTableCellElement>("td[title]")];
    if (cells.length > 0) table.parentElement?.after(reasonList(cells, `reasons-${index + 1}`));
  }
}

/** Adds a list entry for each reason, and its number to the cells. */
function reasonList(cells: HTMLTableCellElement[], id: string): HTMLElement {
  const reasons = [...new Set(cells.map((cell) => cell.title))];
  for (const cell of cells) {
    const number = reasons.indexOf(cell.title) + 1;
    cell.setAttribute("aria-describedby", `${id}-${number}`);
    cell.append(make("sup", { "aria-hidden": "true" }, String(number)));
  }
  return make(
    "ol",
    { class: "reasons" },
    ...reasons.map((reason, i) => make("li", { id: `${id}-${i + 1}` }, reason)),
  );
}
