// The points of the plot of quality over cost.
import type { ReportData } from "../data";
import { frameOfTechnique } from "../frames";
import { paretoFront } from "./pareto";
import { merit, type PooledMetric } from "./pooled_metrics";

export interface Point {
  name: string;
  /** Id of its frame; undefined if it drew none. */
  id: string | undefined;
  cost: number;
  quality: number;
  /** The quality as drawn: its magnitude, if values near 0 are better. */
  drawn: number;
  merit: number;
  control: boolean;
}

export function pointsOf(report: ReportData, quality: PooledMetric, cost: PooledMetric): Point[] {
  return report.results.techniques.flatMap((technique) => {
    const [x, y] = [cost.valueOf(technique), quality.valueOf(technique)];
    if (x === undefined || y === undefined) return [];
    const { name, control = false } = technique;
    const id = frameOfTechnique(report, name)?.id;
    return [
      {
        name,
        id,
        cost: x,
        quality: y,
        drawn: quality.better === "low" ? Math.abs(y) : y,
        merit: merit(quality, y),
        control,
      },
    ];
  });
}

export function frontOf(points: Point[]): Point[] {
  return paretoFront(points.filter(({ control }) => !control));
}

/** Whether the plot shows magnitudes of signed values, because both signs of a bias are equally bad. */
export function isDrawnBySize(points: Point[]): boolean {
  return points.some(({ quality, drawn }) => quality !== drawn);
}
