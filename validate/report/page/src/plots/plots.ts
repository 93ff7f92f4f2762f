// The section of plots: the controls of the techniques to highlight in all plots, then a figure for each
// plot.
import "./plots.css";
import type { ReportData } from "../data";
import { onStateChange } from "../state";
import { addBadpixPlot } from "./badpix_plot";
import { chooser } from "./controls";
import { addCostPlot } from "./cost_plot";
import { defaultA, highlightOptions, kStateA, kStateB } from "./highlight";
import { addHistogramPlot } from "./histogram_plot";

/** Keys of the state that affect a plot. */
const kKeys = [kStateA, kStateB, "plot.quality", "plot.cost", "plot.badpix", "plot.histogram"];

/**
 * `showFailing`: shows the number of failing techniques per pixel in the viewer; undefined if it is unknown.
 */
export function drawPlots(report: ReportData, root: HTMLElement, showFailing?: () => void): void {
  const heading = document.createElement("h2");
  heading.textContent = "Plots";
  const grid = document.createElement("div");
  grid.className = "plots";
  root.append(heading, ...highlightBar(report), grid);
  const redraws = [
    addCostPlot(report, grid),
    addBadpixPlot(report, grid, showFailing),
    addHistogramPlot(report, grid),
  ];
  if (!grid.hasChildNodes()) {
    root.replaceChildren(heading, "There are no figures to plot.");
    return;
  }
  const redraw = () => {
    for (const each of redraws) each();
  };

  onStateChange((changed) => {
    if (kKeys.some((key) => changed.has(key))) redraw();
  });
  redraw();
}

/** Empty if no technique drew a frame. */
function highlightBar(report: ReportData): HTMLElement[] {
  const options = highlightOptions(report);
  if (options.length === 0) return [];
  const bar = document.createElement("div");
  bar.className = "plot-controls";
  const a = chooser("Highlight A", kStateA, options, () => defaultA(report, options));
  const b = chooser("compared with B", kStateB, [{ value: "", text: "none" }, ...options], () => "");
  a.classList.add("is-a");
  b.classList.add("is-b");
  bar.append(a, b);
  return [bar];
}
