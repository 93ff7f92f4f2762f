// Quality against cost: every technique a point, the Pareto front as a staircase, its members named and listed. Controls are drawn
// but don't compete.
import * as Plot from "@observablehq/plot";
import type { ReportData, TechniqueResult } from "../data";
import { frameOfTechnique } from "../frames";
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
  /** Of its frame; undefined if it drew none. */
  id: string | undefined;
  cost: number;
  quality: number;
  /** The quality where it is drawn: of what is better near nothing its size. */
  drawn: number;
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
    figure.notes.replaceChildren(...notesOf(report, quality, cost));
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

function pointsOf(report: ReportData, quality: PooledMetric, cost: PooledMetric): Point[] {
  return report.results.techniques.flatMap((technique) => {
    const [x, y] = [cost.valueOf(technique), quality.valueOf(technique)];
    if (x === undefined || y === undefined) return [];
    const { name, control = false } = technique;
    const id = frameOfTechnique(report, name)?.id;
    return [{ name, id, cost: x, quality: y, drawn: quality.better === "low" ? Math.abs(y) : y, merit: merit(quality, y), control }];
  });
}

function frontOf(points: Point[]): Point[] {
  return paretoFront(points.filter(({ control }) => !control));
}

/** Whether a sign is lost on the way: of a bias too near and too far are equally bad. */
function isDrawnBySize(points: Point[]): boolean {
  return points.some(({ quality, drawn }) => quality !== drawn);
}

function draw(points: Point[], quality: PooledMetric, cost: PooledMetric, highlight: Highlight, width: number): SVGSVGElement {
  const front = frontOf(points);
  const named = points.filter((point) => front.includes(point) || roleOf(point.id, highlight) !== "other");
  const color = (point: Point) => {
    const role = roleOf(point.id, highlight);
    return role === "other" && front.includes(point) ? "var(--text)" : kColorOf[role];
  };
  const labelColor = ({ id }: Point) => (roleOf(id, highlight) === "other" ? "var(--text)" : kColorOf[roleOf(id, highlight)]);
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
    ariaLabel: `${kTitle}: ${label} against ${cost.label} of ${points.length} techniques; the front is listed below.`,
    x: { ...scaleFor(points.map((point) => point.cost)), label: withUnit(cost.label, cost.unit), grid: true },
    y: {
      ...scaleFor(points.map((point) => point.drawn)),
      label: `${withUnit(label, quality.unit)}, ${quality.better} is good`,
      grid: true,
    },
    marks: [
      Plot.line(front, { x: "cost", y: "drawn", curve: "step-after", ...kUnspoken, stroke: "var(--quiet)", strokeWidth: 1.25 }),
      Plot.dot(points, {
        x: "cost",
        y: "drawn",
        r: 4,
        ...kUnspoken,
        symbol: ({ id, control }: Point) => (control ? "triangle" : roleOf(id, highlight) === "b" ? "square" : "circle"),
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

/** The front as text, then those that can't be on it and why. */
function notesOf(report: ReportData, quality: PooledMetric, cost: PooledMetric): HTMLElement[] {
  const points = pointsOf(report, quality, cost);
  const title = document.createElement("p");
  title.textContent = "Pareto front, no technique is as good in both and better in one:";
  const list = document.createElement("ol");
  list.className = "front";
  for (const { name, id, cost: x, quality: y } of frontOf(points)) {
    const entry = document.createElement("li");
    const button = document.createElement("button");
    button.type = "button";
    button.textContent = name;
    button.title = "Let it stand out in the plots";
    button.disabled = id === undefined;
    button.addEventListener("click", () => setState(kStateA, id));
    entry.append(button, ` ${quality.label} ${formatFigure(y)} at ${formatFigure(x)} ${cost.unit}`.trimEnd());
    list.append(entry);
  }
  const notes: HTMLElement[] = [title, list];
  if (isDrawnBySize(points)) notes.push(noteOf("by-size", `${quality.label} is drawn by its size, without its sign.`));
  const absent = leftOut(report.results.techniques, quality, cost);
  if (absent.length > 0) notes.push(noteOf("left-out", `Not on the front: ${absent.join("; ")}.`));
  return notes;
}

function noteOf(className: string, text: string): HTMLElement {
  const note = document.createElement("p");
  note.className = className;
  note.textContent = text;
  return note;
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
