// The text below the plot of quality over cost: the Pareto front, and the techniques left out with their
// reasons.
import type { ReportData, TechniqueResult } from "../data";
import { setState } from "../state";
import { make } from "../viewer/dom";
import { formatFigure } from "./axes";
import { frontOf, isDrawnBySize, pointsOf, type Point } from "./cost_points";
import { kStateA } from "./highlight";
import type { PooledMetric } from "./pooled_metrics";

export function frontNotes(report: ReportData, quality: PooledMetric, cost: PooledMetric): HTMLElement[] {
  const points = pointsOf(report, quality, cost);
  const title = "Pareto-optimal: no other technique is at least as good in both and better in one.";
  const entries = frontOf(points).map((point) => frontEntry(point, quality, cost));
  const notes: HTMLElement[] = [make("p", {}, title), make("ol", { class: "front" }, ...entries)];
  if (isDrawnBySize(points))
    notes.push(
      make("p", { class: "by-size" }, `${quality.label} is drawn as its magnitude.`),
    );
  const reasons = leftOut(report.results.techniques, quality, cost);
  if (reasons.length > 0) notes.push(make("p", { class: "left-out" }, `Left out: ${reasons.join("; ")}.`));
  return notes;
}

function frontEntry(
  { name, id, cost: x, quality: y }: Point,
  quality: PooledMetric,
  cost: PooledMetric,
): HTMLElement {
  const highlight = () => setState(kStateA, id);
  const attributes = {
    type: "button",
    title: "Highlight in the plots",
    disabled: id === undefined,
    click: highlight,
  };
  const figures = ` ${quality.label} ${formatFigure(y)} at ${formatFigure(x)} ${cost.unit}`.trimEnd();
  return make("li", {}, make("button", attributes, name), figures);
}

function leftOut(techniques: TechniqueResult[], quality: PooledMetric, cost: PooledMetric): string[] {
  return techniques.flatMap((technique) => {
    if (technique.control) return [`${technique.name} is a control`];
    const missing = [quality, cost].find((metric) => metric.valueOf(technique) === undefined);
    if (!missing) return [];
    return [
      technique.error
        ? `${technique.name} failed`
        : `${technique.name} has no ${missing.label} (${missing.reasonOf(technique)})`,
    ];
  });
}
