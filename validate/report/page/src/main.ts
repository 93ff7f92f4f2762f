// The interactive part of the report. The page is whole without it but for pictures and plots.
import "./page.css";
import { FrameStore, readReportData } from "./data";
import { drawPlots } from "./plots/plots";
import { setState } from "./state";
import { enhanceTable } from "./table";
import { startViewer } from "./viewer/viewer";

const report = readReportData();

function section(id: string): HTMLElement {
  const element = document.getElementById(id);
  if (!element) throw new Error(`the page has no section '${id}'`);
  return element;
}

function showInViewer(technique: string): void {
  setState("t", technique);
  section("viewer").scrollIntoView();
}

startViewer(report, new FrameStore(report), section("viewer"));
enhanceTable(section("techniques"), showInViewer);
drawPlots(report, section("plots"), () => section("viewer").scrollIntoView());
