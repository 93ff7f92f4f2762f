// Histogram of the signed depth errors of one or two techniques, in relief depths.
import * as Plot from "@observablehq/plot";
import type { FrameEntry, ReportData } from "../data";
import { frameById } from "../frames";
import { getState } from "../state";
import { formatFigure, formatPercent, kPlotStyle, kUnspoken, logScale } from "./axes";
import { toggle } from "./controls";
import { curveLabel, highlightOf, kColorOf } from "./highlight";
import { plotFigure } from "./plot_figure";

interface Outline {
  role: "a" | "b";
  frame: FrameEntry;
  /** Corners of the staircase: bin edges with the share of pixels. */
  steps: { error: number; share: number }[];
}

const kTitle = "Histogram of signed depth errors";
const kLogKey = "plot.histogram";

export function addHistogramPlot(report: ReportData, root: HTMLElement): () => void {
  if (!report.frames.some(({ histogram }) => histogram)) return () => {};
  const figure = plotFigure(root, kTitle, "depth-errors.svg", (width) => {
    const outlines = outlinesOf(report);
    return outlines.length === 0 ? undefined : draw(report, outlines, width);
  });
  figure.controls.append(toggle("Logarithmic share", kLogKey));
  return () => {
    figure.redraw();
    figure.notes.replaceChildren(...outlinesOf(report).map(({ role, frame }) => noteOf(report, role, frame)));
  };
}

function outlinesOf(report: ReportData): Outline[] {
  const highlight = highlightOf(report);
  return (["a", "b"] as const).flatMap((role) => {
    const frame = frameById(report, highlight[role]);
    return frame?.histogram ? [{ role, frame, steps: stepsOf(report, frame.histogram) }] : [];
  });
}

/** Shares are scaled to the width of the narrowest bin, so that bins of different widths are comparable. */
function stepsOf(report: ReportData, histogram: NonNullable<FrameEntry["histogram"]>): Outline["steps"] {
  const { edges } = report.curves;
  const all = pixelsOf(histogram);
  const steps = histogram.counts.map((count, bin) => ({
    error: edges[bin],
    share: ((count / all) * binWidth(edges)) / (edges[bin + 1] - edges[bin]),
  }));
  return [...steps, { error: edges[edges.length - 1], share: steps[steps.length - 1].share }];
}

function pixelsOf({ counts, below, above }: NonNullable<FrameEntry["histogram"]>): number {
  return Math.max(
    1,
    counts.reduce((sum, count) => sum + count, below + above),
  );
}

function binWidth(edges: number[]): number {
  return Math.min(...edges.slice(1).map((edge, index) => edge - edges[index]));
}

function draw(report: ReportData, outlines: Outline[], width: number): SVGSVGElement {
  const { edges } = report.curves;
  const shares = outlines
    .flatMap(({ steps }) => steps.map(({ share }) => share))
    .filter((share) => share > 0);
  const logarithmic = getState(kLogKey) === "1" && shares.length > 0;
  // A logarithmic axis has no zero, so empty bins are drawn at its lower end, half the smallest share.
  const foot = logarithmic ? Math.min(...shares) / 2 : 0;
  const raised = (steps: Outline["steps"]) =>
    steps.map(({ error, share }) => ({ error, share: Math.max(share, foot) }));
  const label = `share of pixels in ${formatFigure(binWidth(edges))} relief depths`;
  return Plot.plot({
    width,
    height: Math.round(Math.min(380, Math.max(280, 0.55 * width))),
    marginLeft: 58,
    marginBottom: 40,
    style: kPlotStyle,
    ariaLabel: `${kTitle} of ${outlines.map(({ frame }) => curveLabel(frame)).join(" and ")}.`,
    x: {
      domain: [edges[0], edges[edges.length - 1]],
      label: "depth error (relief depths): too near < 0 < too far",
      tickFormat: formatFigure,
    },
    y: logarithmic
      ? { ...logScale(foot, Math.max(...shares)), tickFormat: formatPercent, label, grid: true }
      : { tickFormat: formatPercent, nice: true, zero: true, label, grid: true },
    marks: [
      Plot.ruleX([0], { stroke: "var(--quiet)", strokeDasharray: "2,3", ...kUnspoken }),
      ...outlines.flatMap(({ role, steps }) => [
        Plot.areaY(raised(steps), {
          x: "error",
          y1: foot,
          y2: "share",
          curve: "step-after",
          ...kUnspoken,
          fill: kColorOf[role],
          fillOpacity: role === "a" ? 0.25 : 0.12,
        }),
        Plot.line(raised(steps), {
          x: "error",
          y: "share",
          curve: "step-after",
          ...kUnspoken,
          stroke: kColorOf[role],
          strokeWidth: 1.75,
          strokeDasharray: role === "b" ? "6,3" : undefined,
        }),
      ]),
    ],
  }) as SVGSVGElement;
}

function noteOf(report: ReportData, role: "a" | "b", frame: FrameEntry): HTMLElement {
  const note = document.createElement("p");
  const { edges } = report.curves;
  const histogram = frame.histogram as NonNullable<FrameEntry["histogram"]>;
  const all = pixelsOf(histogram);
  const beyond = `${formatPercent(histogram.below / all)} nearer than ${formatFigure(edges[0])} and ${formatPercent(histogram.above / all)} farther than ${formatFigure(edges[edges.length - 1])}`;
  note.textContent = `${role.toUpperCase()}, ${curveLabel(frame)}: ${all} pixels, ${beyond} beyond the ends.`;
  return note;
}
