// The techniques highlighted in every plot: A, and B for comparison; all others are gray.
import type { FrameEntry, ReportData } from "../data";
import { frameById, frameLabel, frameOfTechnique } from "../frames";
import { chosen, type Option } from "./controls";

/** Ids of frames; "" for none. */
export interface Highlight {
  a: string;
  b: string;
}
export const kStateA = "plot.a";
export const kStateB = "plot.b";

/** Techniques that drew a frame, and the reference on the proxy, whose errors are the base gap. */
export function highlightOptions(report: ReportData): Option[] {
  return report.frames
    .filter(({ kind }) => kind === "technique" || kind === "proxy")
    .map((frame) => ({ value: frame.id, text: curveLabel(frame) }));
}

/** The label of the frame's curve or bar. */
export function curveLabel(frame: FrameEntry): string {
  return frame.kind === "proxy" ? `${frameLabel(frame)} (base gap)` : frameLabel(frame);
}

/** A first. */
export function highlightedLabels(report: ReportData, { a, b }: Highlight): string[] {
  return [a, b].flatMap((id) => frameById(report, id) ?? []).map(curveLabel);
}

export function highlightOf(report: ReportData): Highlight {
  const options = highlightOptions(report);
  const a = chosen(kStateA, options, () => defaultA(report, options));
  const b = chosen(kStateB, options, () => "");
  return { a, b: b === a ? "" : b };
}

/** The technique with the lowest depth RMSE. */
export function defaultA(report: ReportData, options: Option[]): string {
  let best: { id: string; rmse: number } | undefined;
  for (const { name, depth, control } of report.results.techniques) {
    const rmse = depth?.rmse_relief;
    const id = frameOfTechnique(report, name)?.id;
    if (!control && id !== undefined && typeof rmse === "number" && (!best || rmse < best.rmse))
      best = { id, rmse };
  }
  return best?.id ?? options[0]?.value ?? "";
}

export type Role = "a" | "b" | "other";

/** `id`: undefined for a technique that drew no frame. */
export function roleOf(id: string | undefined, highlight: Highlight): Role {
  return id === undefined ? "other" : id === highlight.a ? "a" : id === highlight.b ? "b" : "other";
}

/**
 * Okabe and Ito's blue and vermilion (2008), lighter on dark; B is dashed or square as well. plots.css gives
 * the values.
 */
export const kColorOf: { [role in Role]: string } = {
  a: "var(--plot-a)",
  b: "var(--plot-b)",
  other: "var(--plot-other)",
};
