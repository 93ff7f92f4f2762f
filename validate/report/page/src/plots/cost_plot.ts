// Quality against cost: every technique a point, the Pareto front as a staircase, its members named and listed.
import * as Plot from "@observablehq/plot";
import type { ReportData, TechniqueResult } from "../data";
import { setState } from "../state";
import { formatFigure, kPlotStyle, scaleFor, withUnit } from "./axes";
import { chosen, chooser, type Option } from "./controls";
import { type Highlight, highlightOf, kColorOf, kStateA, roleOf } from "./highlight";
import { placeLabels } from "./labels";
import { paretoFront } from "./pareto";
import { plotFigure } from "./plot_figure";
import { merit, metricsWithValues, type PooledMetric, pooledMetrics } from "./pooled_metrics";

interface Point {
  name: string;
  cost: number;
  quality: number;
  merit: number;
}

const kTitle = "Quality against cost";
const kQualityKey = "plot.quality";
const kCostKey = "plot.cost";
const kFirstQuality = "silhouette.iou";
const kFirstCost = "cost.fetches_mean";

/** Returns what redraws it. */
export function addCostPlot(report: ReportData, root: HTMLElement): () => void {
  const metrics = metricsWithValues(pooledMetrics(report), report);
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
    return [{ name: technique.name, cost: x, quality: y, merit: merit(quality, y) }];
  });
}

function draw(points: Point[], quality: PooledMetric, cost: PooledMetric, highlight: Highlight, width: number): SVGSVGElement {
  const front = paretoFront(points);
  const named = points.filter((point) => front.includes(point) || roleOf(point.name, highlight) !== "other");
  const color = (point: Point) => {
    const role = roleOf(point.name, highlight);
    return role === "other" && front.includes(point) ? "var(--text)" : kColorOf[role];
  };
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
      Plot.line(front, { x: "cost", y: "quality", curve: "step-after", stroke: "var(--quiet)", strokeWidth: 1.25 }),
      Plot.dot(points, {
        x: "cost",
        y: "quality",
        r: 4,
        symbol: ({ name }: Point) => (roleOf(name, highlight) === "b" ? "square" : "circle"),
        stroke: color,
        strokeWidth: 1.5,
        fill: (point: Point) =>
          front.includes(point) || roleOf(point.name, highlight) !== "other" ? color(point) : "var(--card)",
      }),
      labelMark(named, points, highlight, width),
      Plot.tip(
        points,
        Plot.pointer({
          x: "cost",
          y: "quality",
          className: "transient",
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

/** Names of points, with a line to those that had to go further off. */
function labelMark(named: Point[], points: Point[], highlight: Highlight, width: number): Plot.Markish {
  return (_index, scales, _values, dimensions) => {
    const group = svgElement("g", { "font-size": "11", "text-anchor": "start", "stroke-linejoin": "round" });
    const at = ({ cost, quality }: Point) => ({ x: scales.x?.(cost) as number, y: scales.y?.(quality) as number });
    const texts = named.map(({ name }) => shortened(name, width));
    const places = placeLabels(
      named.map((point, index) => ({ ...at(point), widthPx: textWidthPx(texts[index]) })),
      points.map(at),
      {
        left: dimensions.marginLeft,
        top: dimensions.marginTop,
        right: dimensions.width,
        bottom: dimensions.height - dimensions.marginBottom,
      },
    );
    named.forEach((point, index) => {
      const place = places[index];
      if (!place) return;
      const { x, y } = at(point);
      const nearest = Math.min(Math.max(x, place.x), place.x + textWidthPx(texts[index]));
      if (place.apart)
        group.append(
          svgElement("line", {
            x1: `${x}`,
            y1: `${y}`,
            x2: `${nearest}`,
            y2: `${place.y}`,
            stroke: "var(--plot-other)",
            "stroke-width": "0.75",
          }),
        );
      const role = roleOf(point.name, highlight);
      const text = svgElement("text", {
        x: `${place.x}`,
        y: `${place.y}`,
        dy: "0.35em",
        fill: role === "other" ? "var(--text)" : kColorOf[role],
        stroke: "var(--card)",
        "stroke-width": "3",
        "paint-order": "stroke",
      });
      text.textContent = texts[index];
      group.append(text);
    });
    return group;
  };
}

function shortened(name: string, width: number): string {
  const letters = width < 500 ? 26 : 44;
  return name.length > letters ? `${name.slice(0, letters - 1)}…` : name;
}

let ruler: CanvasRenderingContext2D | null | undefined;
function textWidthPx(text: string): number {
  ruler ??= document.createElement("canvas").getContext("2d");
  if (!ruler) return 7 * text.length;
  ruler.font = "11px system-ui, sans-serif";
  return ruler.measureText(text).width;
}

function svgElement(name: string, attributes: { [name: string]: string }): SVGElement {
  const element = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  return element;
}

/** The front as text, then those left out and why. */
function notesOf(techniques: TechniqueResult[], quality: PooledMetric, cost: PooledMetric): HTMLElement[] {
  const front = paretoFront(pointsOf(techniques, quality, cost));
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
  note.textContent = `Left out: ${absent.join("; ")}.`;
  return [title, list, note];
}

function leftOut(techniques: TechniqueResult[], quality: PooledMetric, cost: PooledMetric): string[] {
  return techniques.flatMap((technique) => {
    const missing = [quality, cost].find((metric) => metric.valueOf(technique) === undefined);
    if (!missing) return [];
    return [
      technique.error ? `${technique.name} failed` : `${technique.name} has no ${missing.label} (${missing.reasonOf(technique)})`,
    ];
  });
}
