// Scales, ticks and number formats of all plots.
import type { ScaleOptions } from "@observablehq/plot";

/** A scale is logarithmic from this ratio of largest to smallest value on. */
const kSpansDecades = 10;
/** From this number of decades on, only powers of ten have ticks. */
const kManyDecades = 2.5;

export const kPlotStyle = "font-size: 12px; overflow: visible";

/** For every mark, because screen readers should read the label of the whole plot, not of its parts. */
export const kUnspoken = { ariaHidden: "true" };

export function formatFigure(value: number): string {
  if (value !== 0 && (Math.abs(value) < 1e-4 || Math.abs(value) >= 1e6)) return value.toExponential(2);
  return String(Number(value.toPrecision(4)));
}

export function formatPercent(share: number): string {
  return `${formatFigure(100 * share)} %`;
}

export function withUnit(label: string, unit: string): string {
  return unit === "" || unit === "1" ? label : `${label} (${unit})`;
}

/** Logarithmic if the values are positive and span a decade or more. */
export function scaleFor(values: number[]): ScaleOptions {
  const [low, high] = [Math.min(...values), Math.max(...values)];
  if (!(low > 0 && high / low >= kSpansDecades))
    return { type: "linear", nice: true, tickFormat: formatFigure };
  return logScale(low / 1.15, high * 1.15);
}

export function logScale(low: number, high: number): ScaleOptions {
  return { type: "log", domain: [low, high], ticks: logTicks(low, high), tickFormat: formatFigure };
}

/** 1, 2, 5 in each decade, or only powers of ten if there are many decades. */
function logTicks(low: number, high: number): number[] {
  const steps = Math.log10(high / low) > kManyDecades ? [1] : [1, 2, 5];
  const ticks: number[] = [];
  for (let decade = Math.floor(Math.log10(low)); decade <= Math.log10(high); ++decade)
    for (const step of steps) ticks.push(Number(`${step}e${decade}`));
  return ticks.filter((tick) => tick >= low && tick <= high);
}
