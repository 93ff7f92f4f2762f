// Quality against cost: every technique a point, the Pareto front as a staircase, its members named and listed. Controls are drawn
// but don't compete.
import * as Plot from "@observablehq/plot";
import type { ReportData, TechniqueResult } from "../data";
import { setState } from "../state";
import { formatFigure, kPlotStyle, kUnspoken, scaleFor, withUnit } from "./axes";
import { chosen, chooser, type Option } from "./controls";
import { type Highlight, highlightOf, kColorOf, kStateA, roleOf } from "./highlight";
import { pointLabels } from "./point_labels";
import { paretoFront } from "./pareto";
import { plotFigure } from "./plot_figure";
import { merit, metricsWithValues, type PooledMetric, pooledMetrics, withoutIntervals } from "./pooled_metrics";

interface Point {
  name: string;
  cost: number;
  quality: number;
  merit: number;
  control: boolean;
}

const kTitle = "Quality against cost";
const kQualityKey = "plot.quality";
const kCostKey = "plot.cost";
const kFirstQuality = "silhouette.iou";
const kFirstCost = "cost.fetches_mean";

/** Returns what redraws it. */
export function addCostPlot(report: ReportData, root: HTMLElement): () => void {
  const metrics = metricsWithValues(withoutIntervals(pooledMetrics(report)), report);
  const qualities = metrics.filter(({ key, better }) => better !== "" && !key.startsWith("cost."));
  const costs = metrics.filter(({ key }) => key.startsWith("cost."));
  if (qualities.length === 0 || costs.length === 0) return () => {};
  const qualityOptions = qualities.map(toOption);
  const costOptions = costs.map(({ key, label, unit }) => ({ value: key, text: withUnit(label, unit) }));
  const first = (options: Option[], key: string) => () => (options.find(({ value }) => value === key) ?? options[0]).value;
  const selected = () => ({
    quality: byKey(qualities, chosen(kQualityKey, qualityOptions, first(qualityOptions, kFirstQuality))),
    cost: byKey(costs, chosen(kCostKey, costOptions, first(costOptions, kFirstCost))),
  });

  const figure = plotFigure(root, kTitle, "quality-against-cost.svg", (width) => {
    const { quality, cost } = selected();
    const points = pointsOf(report.results.techniques, quality, cost);
    return points.length === 0 ? undefined : draw(points, quality, cost, highlightOf(report), width);
  });
  figure.controls.append(
    chooser("Quality", kQualityKey, qualityOptions, first(qualityOptions, kFirstQuality)),
    chooser("Cost", kCostKey, costOptions, first(costOptions, kFirstCost)),
  );
  return () => {
    figure.redraw();
    const { quality, cost } = selected();
    figure.notes.replaceChildren(...notesOf(report.results.techniques, quality, cost));
  };
}

function toOption({ key, label, unit, better }: PooledMetric): Option {
  return {
    value: key,
    text: `${withUnit(label, unit)} – ${better === "high" ? "high" : "low"} is good`,
    group: key.split(".")[0],
  };
}

function byKey(metrics: PooledMetric[], key: string): PooledMetric {
  return metrics.find((metric) => metric.key === key) ?? metrics[0];
}

function pointsOf(techniques: TechniqueResult[], quality: PooledMetric, cost: PooledMetric): Point[] {
  return techniques.flatMap((technique) => {
    const [x, y] = [cost.valueOf(technique), quality.valueOf(technique)];
    if (x === undefined || y === undefined) return [];
    return [{ name: technique.name, cost: x, quality: y, merit: merit(quality, y), control: technique.control ?? false }];
  });
}

function frontOf(points: Point[]): Point[] {
  return paretoFront(points.filter(({ control }) => !control));
}

function draw(points: Point[], quality: PooledMetric, cost: PooledMetric, highlight: Highlight, width: number): SVGSVGElement {
  const front = frontOf(points);
  const named = points.filter((point) => front.includes(point) || roleOf(point.name, highlight) !== "other");
  const color = (point: Point) => {
    const role = roleOf(point.name, highlight);
    return role === "other" && front.includes(point) ? "var(--text)" : kColorOf[role];
  };
  const labelColor = ({ name }: Point) =>
    roleOf(name, highlight) === "other" ? "var(--text)" : kColorOf[roleOf(name, highlight)];
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
    ariaLabel: `${kTitle}: ${quality.label} against ${cost.label} of ${points.length} techniques; the front is listed below.`,
    x: { ...scaleFor(points.map((point) => point.cost)), label: withUnit(cost.label, cost.unit), grid: true },
    y: {
      ...scaleFor(points.map((point) => point.quality)),
      label: `${withUnit(quality.label, quality.unit)}, ${quality.better} is good`,
      grid: true,
    },
    marks: [
      Plot.line(front, { x: "cost", y: "quality", curve: "step-after", ...kUnspoken, stroke: "var(--quiet)", strokeWidth: 1.25 }),
      Plot.dot(points, {
        x: "cost",
        y: "quality",
        r: 4,
        ...kUnspoken,
        symbol: ({ name, control }: Point) => (control ? "triangle" : roleOf(name, highlight) === "b" ? "square" : "circle"),
        stroke: color,
        strokeWidth: 1.5,
        fill: (point: Point) =>
          front.includes(point) || roleOf(point.name, highlight) !== "other" ? color(point) : "var(--card)",
      }),
      pointLabels(
        named.map((point) => ({ x: point.cost, y: point.quality, text: point.name, color: labelColor(point) })),
        points.map((point) => ({ x: point.cost, y: point.quality })),
      ),
      Plot.tip(
        points,
        Plot.pointer({
          x: "cost",
          y: "quality",
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
    if (svg.value) setState(kStateA, svg.value.name);
  });
  return svg;
}

/** The front as text, then those that can't be on it and why. */
function notesOf(techniques: TechniqueResult[], quality: PooledMetric, cost: PooledMetric): HTMLElement[] {
  const front = frontOf(pointsOf(techniques, quality, cost));
  const title = document.createElement("p");
  title.textContent = "Pareto front, no technique is as good in both and better in one:";
  const list = document.createElement("ol");
  list.className = "front";
  for (const { name, cost: x, quality: y } of front) {
    const entry = document.createElement("li");
    const button = document.createElement("button");
    button.type = "button";
    button.textContent = name;
    button.title = "Let it stand out in the plots";
    button.addEventListener("click", () => setState(kStateA, name));
    entry.append(button, ` ${quality.label} ${formatFigure(y)} at ${formatFigure(x)} ${cost.unit}`.trimEnd());
    list.append(entry);
  }
  const absent = leftOut(techniques, quality, cost);
  if (absent.length === 0) return [title, list];
  const note = document.createElement("p");
  note.className = "left-out";
  note.textContent = `Not on the front: ${absent.join("; ")}.`;
  return [title, list, note];
}

function leftOut(techniques: TechniqueResult[], quality: PooledMetric, cost: PooledMetric): string[] {
  return techniques.flatMap((technique) => {
    if (technique.control) return [`${technique.name} is a control and doesn't compete`];
    const missing = [quality, cost].find((metric) => metric.valueOf(technique) === undefined);
    if (!missing) return [];
    return [
      technique.error ? `${technique.name} failed` : `${technique.name} has no ${missing.label} (${missing.reasonOf(technique)})`,
    ];
  });
}
