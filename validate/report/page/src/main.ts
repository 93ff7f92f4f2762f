// The interactive part of the report. The page is whole without it but for pictures and plots.
import "./page.css";
import { FrameStore, readReportData } from "./data";
import { kStateA } from "./plots/highlight";
import { drawPlots } from "./plots/plots";
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

/** Panes that somebody chose give way to those that belong to the technique. */
function showTechnique(name: string): void {
  const panes = ["f1", "f2", "f3", "f4", "l1", "l2", "l3", "l4"];
  updateState({ ...Object.fromEntries(panes.map((key) => [key, undefined])), vs: undefined, t: name, [kStateA]: name });
  section("viewer").scrollIntoView();
}

function showFailing(): void {
  updateState({ view: undefined, n: "1", f1: summary?.name, l1: "failing" });
  section("viewer").scrollIntoView();
}

startViewer(report, new FrameStore(report), section("viewer"));
enhanceTable(section("techniques"), showTechnique);
drawPlots(report, section("plots"), summary && showFailing);
