// The share of pixels whose depth error exceeds a threshold, as a curve over thresholds for each technique.
// At one threshold it is the metric of Scharstein and Szeliski (2002), "A taxonomy and evaluation of dense
// two-frame stereo correspondence algorithms".
import * as Plot from "@observablehq/plot";
import { selectAll } from "d3-selection";
import type { ReportData } from "../data";
import { getState, setState } from "../state";
import { formatFigure, formatPercent, kPlotStyle, kUnspoken, logScale } from "./axes";
import { toggle } from "./controls";
import {
  curveLabel,
  type Highlight,
  highlightedLabels,
  highlightOf,
  kColorOf,
  kStateA,
  roleOf,
} from "./highlight";
import { plotFigure } from "./plot_figure";

interface Sample {
  /** Of its frame. */
  id: string;
  label: string;
  threshold: number;
  share: number;
}

const kTitle = "Pixels with a depth error above a threshold";
const kLogKey = "plot.badpix";
const kOthers = "others";

export function addBadpixPlot(report: ReportData, root: HTMLElement, showFailing?: () => void): () => void {
  const samples = samplesOf(report);
  if (samples.length === 0) return () => {};
  const figure = plotFigure(root, kTitle, "badpix.svg", (width) =>
    draw(report, samples, highlightOf(report), width),
  );
  figure.controls.append(toggle("Logarithmic share", kLogKey));
  figure.notes.append("Depth errors in relief depths, of pixels that show the same object in both frames. ");
  if (showFailing) figure.notes.append(failingButton(report, showFailing));
  return figure.redraw;
}

function samplesOf(report: ReportData): Sample[] {
  return report.frames.flatMap((frame) =>
    (frame.badpix ?? []).map((share, index) => ({
      id: frame.id,
      label: curveLabel(frame),
      threshold: report.curves.thresholds[index],
      share,
    })),
  );
}

function failingButton(report: ReportData, showFailing: () => void): HTMLElement {
  const button = document.createElement("button");
  button.type = "button";
  button.className = "inline";
  button.textContent = "View how many techniques fail at each pixel";
  button.title = report.failing.meaning;
  button.addEventListener("click", showFailing);
  return button;
}

function draw(report: ReportData, samples: Sample[], highlight: Highlight, width: number): SVGSVGElement {
  const logarithmic = getState(kLogKey) === "1";
  const shown = logarithmic ? samples.filter(({ share }) => share > 0) : samples;
  const { thresholds } = report.curves;
  const lowest = Math.min(1, ...shown.map(({ share }) => share));
  const of = (role: string) => shown.filter(({ id }) => roleOf(id, highlight) === role);
  const curve = (
    role: "a" | "b" | "other",
    strokeWidth: number,
    strokeDasharray?: string,
    className?: string,
  ) =>
    Plot.line(of(role), {
      x: "threshold",
      y: "share",
      z: "id",
      stroke: kColorOf[role],
      strokeWidth,
      strokeDasharray,
      className,
      ...kUnspoken,
    });
  const svg = Plot.plot({
    width,
    height: Math.round(Math.min(380, Math.max(280, 0.55 * width))),
    marginLeft: 58,
    marginBottom: 40,
    style: kPlotStyle,
    ariaLabel: `${kTitle}: share of pixels by threshold of the depth error, ${highlightedLabels(report, highlight).join(" and ")} highlighted.`,
    x: {
      ...logScale(thresholds[0], thresholds[thresholds.length - 1]),
      label: "threshold of |depth error| (relief depths)",
      grid: true,
    },
    y: logarithmic
      ? {
          ...logScale(lowest, 1),
          tickFormat: formatPercent,
          label: "share of pixels, lower is better",
          grid: true,
        }
      : { domain: [0, 1], tickFormat: formatPercent, label: "share of pixels, lower is better", grid: true },
    marks: [
      Plot.ruleX(report.curves.named, { stroke: "var(--quiet)", strokeDasharray: "2,3", ...kUnspoken }),
      curve("other", 1, undefined, kOthers),
      curve("b", 2.25, "6,3"),
      curve("a", 2.25),
      Plot.tip(
        shown,
        Plot.pointer({
          x: "threshold",
          y: "share",
          className: "transient",
          ...kUnspoken,
          fill: "var(--card)",
          title: ({ label, threshold, share }: Sample) =>
            `${label}\n${formatPercent(share)} with an error above ${formatFigure(threshold)}`,
        }),
      ),
    ],
  }) as SVGSVGElement & { value: Sample | null };
  const others = of("other");
  svg.addEventListener("input", () => {
    // Plot binds to each path the indices of its samples.
    selectAll<SVGPathElement, number[]>(svg.querySelectorAll<SVGPathElement>(`.${kOthers} path`)).classed(
      "hovered",
      (indices) => others[indices[0]].id === svg.value?.id,
    );
  });
  svg.addEventListener("click", () => {
    if (svg.value) setState(kStateA, svg.value.id);
  });
  return svg;
}
