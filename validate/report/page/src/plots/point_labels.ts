// A mark for Observable Plot: labels next to points, with lines to those that are placed farther away.
import type { Markish } from "@observablehq/plot";
import { placeLabels } from "./labels";

/** In the plot's own units. */
interface At {
  x: number;
  y: number;
}
interface PointLabel extends At {
  text: string;
  color: string;
}

const kFontPx = 11;
/**
 * Maximum number of letters of a name, in a plot narrower than kNarrowPx and in wider ones. The list below
 * the plot contains the full name. /
 */
const kNarrowPx = 500;
const kMostLetters = { narrow: 26, wide: 44 };

/** `points`: all points of the plot, which labels must not overlap. */
export function pointLabels(labels: PointLabel[], points: At[]): Markish {
  return (_index, scales, _values, { width, height, marginLeft, marginTop, marginBottom }) => {
    const toPixels = ({ x, y }: At) => ({ x: scales.x?.(x) as number, y: scales.y?.(y) as number });
    const texts = labels.map(({ text }) =>
      shortened(text, width < kNarrowPx ? kMostLetters.narrow : kMostLetters.wide),
    );
    const widths = texts.map(textWidthPx);
    const places = placeLabels(
      labels.map((label, index) => ({ ...toPixels(label), widthPx: widths[index] })),
      points.map(toPixels),
      { left: marginLeft, top: marginTop, right: width, bottom: height - marginBottom },
    );
    const group = svgElement("g", {
      "font-size": kFontPx,
      "text-anchor": "start",
      "stroke-linejoin": "round",
    });
    labels.forEach((label, index) => {
      const place = places[index];
      if (!place) return;
      if (place.needsLine) {
        const { x, y } = toPixels(label);
        const x2 = Math.min(Math.max(x, place.x), place.x + widths[index]);
        group.append(
          svgElement("line", {
            x1: x,
            y1: y,
            x2,
            y2: place.y,
            stroke: "var(--plot-other)",
            "stroke-width": 0.75,
          }),
        );
      }
      const halo = { stroke: "var(--card)", "stroke-width": 3, "paint-order": "stroke" };
      const text = svgElement("text", { x: place.x, y: place.y, dy: "0.35em", fill: label.color, ...halo });
      text.textContent = texts[index];
      group.append(text);
    });
    return group;
  };
}

function shortened(name: string, letters: number): string {
  return name.length > letters ? `${name.slice(0, letters - 1)}…` : name;
}

let ruler: CanvasRenderingContext2D | null | undefined;
function textWidthPx(text: string): number {
  ruler ??= document.createElement("canvas").getContext("2d");
  if (!ruler) return 0.65 * kFontPx * text.length;
  ruler.font = `${kFontPx}px system-ui, sans-serif`;
  return ruler.measureText(text).width;
}

function svgElement(name: string, attributes: { [name: string]: string | number }): SVGElement {
  const element = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, String(value));
  return element;
}
