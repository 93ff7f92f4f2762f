// The metrics that plots can show: pooled over objects, and shadow metrics for each light.
import type { Group, MetricInfo, ReportData, TechniqueResult } from "../data";

export interface PooledMetric {
  /** For example "depth.rmse_relief" or "shadow.sun.agreement". */
  key: string;
  label: string;
  unit: string;
  better: MetricInfo["better"];
  valueOf(technique: TechniqueResult): number | undefined;
  /** The reason why there is no value. */
  reasonOf(technique: TechniqueResult): string;
}

export function pooledMetrics(report: ReportData): PooledMetric[] {
  const lights = [...new Set(report.results.techniques.flatMap(({ shadow }) => Object.keys(shadow ?? {})))];
  return report.metrics.flatMap((info) => {
    const [group, ...path] = info.key.split(".");
    if (group !== "shadow")
      return [pooledMetric(info, info.key, info.label, path, (technique) => groupOf(technique, group))];
    return lights.map((light) =>
      pooledMetric(
        info,
        ["shadow", light, ...path].join("."),
        `${info.label}, ${light}`,
        path,
        ({ shadow }) => shadow?.[light],
      ),
    );
  });
}

/** The metrics that have a value for at least one technique. */
export function metricsWithValues(metrics: PooledMetric[], report: ReportData): PooledMetric[] {
  return metrics.filter((metric) =>
    report.results.techniques.some((technique) => metric.valueOf(technique) !== undefined),
  );
}

/** Leaves out the ends of intervals. */
export function withoutIntervals(metrics: PooledMetric[]): PooledMetric[] {
  const keys = new Set(metrics.map(({ key }) => key));
  return metrics.filter(({ key }) => !/_(low|high)$/.test(key) || !keys.has(key.replace(/_(low|high)$/, "")));
}

/**
 * A value whose higher values are better. If low is better: the negative magnitude, as a bias may be
 * negative.
 */
export function merit(metric: PooledMetric, value: number): number {
  return metric.better === "high" ? value : -Math.abs(value);
}

function groupOf(technique: TechniqueResult, group: string): Group | undefined {
  return (technique as unknown as { [group: string]: Group | undefined })[group];
}

function pooledMetric(
  info: MetricInfo,
  key: string,
  label: string,
  path: string[],
  group: (technique: TechniqueResult) => Group | undefined,
): PooledMetric {
  const { unit, better } = info;
  return {
    key,
    label,
    unit,
    better,
    valueOf(technique) {
      let value: unknown = group(technique);
      for (const step of path) value = (value as Group | undefined)?.[step];
      return typeof value === "number" && Number.isFinite(value) ? value : undefined;
    },
    reasonOf(technique) {
      if (technique.error) return "failed";
      return group(technique)?.absent?.[path.join(".")] ?? "not in the results";
    },
  };
}
