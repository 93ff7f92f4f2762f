// The interactive part of the report: viewer, plots and sorting of the table. The rest of the page works
// without it.
import "./page.css";
import { readReportData, type FrameEntry } from "./data";
import { FrameStore } from "./frame_store";
import { frameOfTechnique } from "./frames";
import { kStateA } from "./plots/highlight";
import { drawPlots } from "./plots/plots";
import { listReasons } from "./reasons";
import { updateState } from "./state";
import { enhanceTable } from "./table";
import { startViewer } from "./viewer/viewer";

const report = readReportData();
const summary = report.frames.find(({ kind }) => kind === "summary");

function section(id: string): HTMLElement {
  const element = document.getElementById(id);
  if (!element) throw new Error(`the page has no section '${id}'`);
  return element;
}

/** Shows a technique in the standard panes, replacing what they showed, and highlights it in the plots. */
function showTechnique({ id }: FrameEntry): void {
  const chosen = ["view", "n", "vs", "f1", "f2", "f3", "f4", "l1", "l2", "l3", "l4"];
  updateState({ ...Object.fromEntries(chosen.map((key) => [key, undefined])), t: id, [kStateA]: id });
  section("viewer").scrollIntoView();
}

function showFailing({ id }: FrameEntry): void {
  updateState({ view: undefined, n: "1", f1: id, l1: "failing" });
  section("viewer").scrollIntoView();
}

startViewer(report, new FrameStore(report), section("viewer"));
enhanceTable(section("techniques"), (technique) => {
  const frame = frameOfTechnique(report, technique);
  return frame && (() => showTechnique(frame));
});
drawPlots(report, section("plots"), summary && (() => showFailing(summary)));
listReasons();
