// Quality over cost: a point for each technique, and the Pareto front as a staircase with labeled points.
// Controls are drawn, but they can't be on the front.
import * as Plot from "@observablehq/plot";
import type { ReportData } from "../data";
import { setState } from "../state";
import { formatFigure, kPlotStyle, kUnspoken, scaleFor, withUnit } from "./axes";
import { chosen, chooser, type Option } from "./controls";
import { frontOf, isDrawnBySize, pointsOf, type Point } from "./cost_points";
import { frontNotes } from "./front_notes";
import { type Highlight, highlightOf, kColorOf, kStateA, roleOf } from "./highlight";
import { pointLabels } from "./point_labels";
import { plotFigure } from "./plot_figure";
import { metricsWithValues, type PooledMetric, pooledMetrics, withoutIntervals } from "./pooled_metrics";

const kTitle = "Quality over cost";
const kQualityKey = "plot.quality";
const kCostKey = "plot.cost";
const kFirstQuality = "silhouette.iou";
const kFirstCost = "cost.fetches_mean";

/** Returns a function that redraws it. */
export function addCostPlot(report: ReportData, root: HTMLElement): () => void {
  const metrics = metricsWithValues(withoutIntervals(pooledMetrics(report)), report);
  const qualities = metrics.filter(({ key, better }) => better !== "" && !key.startsWith("cost."));
  const costs = metrics.filter(({ key }) => key.startsWith("cost."));
  if (qualities.length === 0 || costs.length === 0) return () => {};
  const qualityOptions = qualities.map(toOption);
  const costOptions = costs.map(({ key, label, unit }) => ({ value: key, text: withUnit(label, unit) }));
  const first = (options: Option[], key: string) => () =>
    (options.find(({ value }) => value === key) ?? options[0]).value;
  const selected = () => ({
    quality: byKey(qualities, chosen(kQualityKey, qualityOptions, first(qualityOptions, kFirstQuality))),
    cost: byKey(costs, chosen(kCostKey, costOptions, first(costOptions, kFirstCost))),
  });

  const figure = plotFigure(root, kTitle, "quality-over-cost.svg", (width) => {
    const { quality, cost } = selected();
    const points = pointsOf(report, quality, cost);
    return points.length === 0 ? undefined : draw(points, quality, cost, highlightOf(report), width);
  });
  figure.controls.append(
    chooser("Quality", kQualityKey, qualityOptions, first(qualityOptions, kFirstQuality)),
    chooser("Cost", kCostKey, costOptions, first(costOptions, kFirstCost)),
  );
  return () => {
    figure.redraw();
    const { quality, cost } = selected();
    figure.notes.replaceChildren(...frontNotes(report, quality, cost));
  };
}

function toOption({ key, label, unit, better }: PooledMetric): Option {
  return {
    value: key,
    text: `${withUnit(label, unit)} – ${better}er is better`,
    group: key.split(".")[0],
  };
}

function byKey(metrics: PooledMetric[], key: string): PooledMetric {
  return metrics.find((metric) => metric.key === key) ?? metrics[0];
}

function draw(
  points: Point[],
  quality: PooledMetric,
  cost: PooledMetric,
  highlight: Highlight,
  width: number,
): SVGSVGElement {
  const front = frontOf(points);
  const named = points.filter((point) => front.includes(point) || roleOf(point.id, highlight) !== "other");
  const color = (point: Point) => {
    const role = roleOf(point.id, highlight);
    return role === "other" && front.includes(point) ? "var(--text)" : kColorOf[role];
  };
  const labelColor = ({ id }: Point) =>
    roleOf(id, highlight) === "other" ? "var(--text)" : kColorOf[roleOf(id, highlight)];
  const label = isDrawnBySize(points) ? `|${quality.label}|` : quality.label;
  const svg = Plot.plot({
    width,
    height: Math.round(Math.min(460, Math.max(320, 0.62 * width))),
    marginLeft: 58,
    marginBottom: 40,
    insetTop: 24,
    insetBottom: 12,
    insetLeft: 12,
    insetRight: 12,
    style: kPlotStyle,
    ariaLabel: `${kTitle}: ${label} over ${cost.label} of ${points.length} techniques; the front is listed below.`,
    x: { ...scaleFor(points.map((point) => point.cost)), label: withUnit(cost.label, cost.unit), grid: true },
    y: {
      ...scaleFor(points.map((point) => point.drawn)),
      label: `${withUnit(label, quality.unit)}, ${quality.better}er is better`,
      grid: true,
    },
    marks: [
      Plot.line(front, {
        x: "cost",
        y: "drawn",
        curve: "step-after",
        ...kUnspoken,
        stroke: "var(--quiet)",
        strokeWidth: 1.25,
      }),
      Plot.dot(points, {
        x: "cost",
        y: "drawn",
        r: 4,
        ...kUnspoken,
        symbol: ({ id, control }: Point) =>
          control ? "triangle" : roleOf(id, highlight) === "b" ? "square" : "circle",
        stroke: color,
        strokeWidth: 1.5,
        fill: (point: Point) =>
          front.includes(point) || roleOf(point.id, highlight) !== "other" ? color(point) : "var(--card)",
      }),
      pointLabels(
        named.map((point) => ({ x: point.cost, y: point.drawn, text: point.name, color: labelColor(point) })),
        points.map((point) => ({ x: point.cost, y: point.drawn })),
      ),
      Plot.tip(
        points,
        Plot.pointer({
          x: "cost",
          y: "drawn",
          className: "transient",
          ...kUnspoken,
          fill: "var(--card)",
          title: ({ name, cost: x, quality: y }: Point) => `${name}\n${formatFigure(x)}, ${formatFigure(y)}`,
        }),
      ),
    ],
    color: { type: "identity" },
    symbol: { type: "identity" },
  }) as SVGSVGElement & { value: Point | null };
  svg.addEventListener("click", () => {
    if (svg.value?.id !== undefined) setState(kStateA, svg.value.id);
  });
  return svg;
}
