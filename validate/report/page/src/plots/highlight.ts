// The techniques that stand out in every plot: A, and B to hold it against; all others are grey.
import type { ReportData } from "../data";
import { chosen, type Option } from "./controls";

export interface Highlight {
  a: string;
  /** "" for none. */
  b: string;
}
export const kStateA = "plot.a";
export const kStateB = "plot.b";

/** Techniques that drew, and the displaced proxy, which stands for the base gap. */
export function highlightOptions(report: ReportData): Option[] {
  return report.frames
    .filter(({ kind }) => kind === "technique" || kind === "proxy")
    .map(({ name, kind }) => ({ value: name, text: kind === "proxy" ? `${name} (base gap)` : name }));
}

export function highlightOf(report: ReportData): Highlight {
  const options = highlightOptions(report);
  const a = chosen(kStateA, options, () => defaultA(report, options));
  const b = chosen(kStateB, options, () => "");
  return { a, b: b === a ? "" : b };
}

/** The technique whose depth is best. */
export function defaultA(report: ReportData, options: Option[]): string {
  let best: { name: string; rmse: number } | undefined;
  for (const { name, depth, control } of report.results.techniques) {
    const rmse = depth?.rmse_relief;
    if (!control && typeof rmse === "number" && (!best || rmse < best.rmse)) best = { name, rmse };
  }
  return best?.name ?? options[0]?.value ?? "";
}

export type Role = "a" | "b" | "other";

export function roleOf(name: string, highlight: Highlight): Role {
  return name === highlight.a ? "a" : name === highlight.b ? "b" : "other";
}

/** Okabe and Ito's blue and vermilion (2008), lighter on dark; B is dashed or square as well. plots.css gives the values. */
export const kColorOf: { [role in Role]: string } = {
  a: "var(--plot-a)",
  b: "var(--plot-b)",
  other: "var(--plot-other)",
};
