// Makes the table of metrics sortable: heads become buttons, and the choice is kept in the address. The first
// press puts the best figures first, the second the worst, the third restores the program's order. Absent
// figures are always last.
import "./table.css";
import { getState, onStateChange, setState } from "./state";

type Direction = "asc" | "desc";
interface Sorting {
  key: string;
  direction: Direction;
}
interface Column {
  key: string;
  head: HTMLTableCellElement;
  /** The value by which a row is sorted; undefined if the figure is absent. */
  valueOf(row: HTMLTableRowElement): number | string | undefined;
  /** The direction that puts the best figures first. */
  first: Direction;
}

/** `showing`: returns a function that shows a technique in the viewer; undefined if it drew no frame. */
export function enhanceTable(
  root: HTMLElement,
  showing: (technique: string) => (() => void) | undefined,
): void {
  const table = root.querySelector("table");
  const body = table?.tBodies[0];
  if (!table?.tHead || !body) return;
  const columns = [...table.tHead.rows[0].cells].map(columnOf);
  const original = [...body.rows];

  const apply = () => {
    const sorting = parseSorting(getState("sort"), columns);
    body.append(...sortRows(original, columns, sorting));
    for (const column of columns)
      if (sorting?.key === column.key)
        column.head.setAttribute("aria-sort", sorting.direction === "asc" ? "ascending" : "descending");
      else column.head.removeAttribute("aria-sort");
  };
  for (const column of columns)
    addButton(column, () => {
      const next = nextSorting(column, parseSorting(getState("sort"), columns));
      setState("sort", next && `${next.key}:${next.direction}`);
    });
  for (const row of original) addShowButton(row, showing);
  onStateChange((changed) => {
    if (changed.has("sort")) apply();
  });
  apply();
}

function columnOf(head: HTMLTableCellElement, index: number): Column {
  const key = head.dataset.key ?? `column-${index}`;
  if (index === 0) return { key, head, valueOf: (row) => row.dataset.technique, first: "asc" };
  const better = head.dataset.better;
  return {
    key,
    head,
    first: better === "high" ? "desc" : "asc",
    valueOf(row) {
      const text = row.cells[index]?.dataset.value;
      if (text === undefined || text === "") return undefined;
      // Where lower is better, signed figures such as a bias are sorted by their magnitude.
      const value = better === "low" ? Math.abs(Number(text)) : Number(text);
      return Number.isNaN(value) ? undefined : value;
    },
  };
}

function parseSorting(text: string | undefined, columns: Column[]): Sorting | undefined {
  const colon = text?.lastIndexOf(":") ?? -1;
  if (text === undefined || colon < 0) return undefined;
  const [key, direction] = [text.slice(0, colon), text.slice(colon + 1)];
  if (direction !== "asc" && direction !== "desc") return undefined;
  return columns.some((column) => column.key === key) ? { key, direction } : undefined;
}

function nextSorting(column: Column, present: Sorting | undefined): Sorting | undefined {
  if (present?.key !== column.key) return { key: column.key, direction: column.first };
  if (present.direction !== column.first) return undefined;
  return { key: column.key, direction: column.first === "asc" ? "desc" : "asc" };
}

/** Stable: rows of equal figures keep the program's order, in either direction. */
function sortRows(
  rows: HTMLTableRowElement[],
  columns: Column[],
  sorting: Sorting | undefined,
): HTMLTableRowElement[] {
  const column = columns.find((candidate) => candidate.key === sorting?.key);
  if (!column || !sorting) return rows;
  const sign = sorting.direction === "asc" ? 1 : -1;
  return rows
    .map((row) => ({ row, value: column.valueOf(row) }))
    .sort((a, b) => {
      if (a.value === undefined || b.value === undefined)
        return Number(a.value === undefined) - Number(b.value === undefined);
      return a.value === b.value ? 0 : a.value < b.value ? -sign : sign;
    })
    .map(({ row }) => row);
}

function addButton(column: Column, press: () => void): void {
  const button = document.createElement("button");
  button.type = "button";
  button.className = "sort";
  button.append(...column.head.childNodes);
  button.addEventListener("click", press);
  column.head.append(button);
}

function addShowButton(
  row: HTMLTableRowElement,
  showing: (technique: string) => (() => void) | undefined,
): void {
  const { technique } = row.dataset;
  const show = technique === undefined ? undefined : showing(technique);
  if (!show) return;
  const button = document.createElement("button");
  button.type = "button";
  button.className = "show";
  button.textContent = "view";
  button.setAttribute("aria-label", `View ${technique}`);
  button.addEventListener("click", show);
  row.cells[0].prepend(button);
}
