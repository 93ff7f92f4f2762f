// The data that the program passes to the page: JSON in the page, written by validate/report/report_data.cpp.

/**
 * The part of results.json that the page reads. Groups contain numbers and, in `absent`, the reasons why
 * others are missing. /
 */
export interface Results {
  schema: number;
  program: string;
  base: string | null;
  scene: { name: string; purpose: string; hash: string; width: number; height: number; changes?: string[] };
  techniques: TechniqueResult[];
}
export type Group = { [key: string]: unknown; absent?: { [key: string]: string } };
export interface TechniqueResult {
  name: string;
  parameters: { [key: string]: string };
  gl: { backend: string; renderer: string };
  error: string | null;
  /** A control shows how much of an error isn't caused by a technique; it isn't ranked. */
  control?: boolean;
  silhouette?: Group;
  depth?: Group;
  shadow?: { [light: string]: Group };
  normal?: Group;
  st?: Group;
  image?: Group;
  cost?: Group;
}

/** A row of the program's table of metrics (`plumbline list metrics`). */
export interface MetricInfo {
  /** "depth.rmse_relief"; a shadow key such as "shadow.agreement" stands for those of every light. */
  key: string;
  label: string;
  unit: string;
  meaning: string;
  /** Whether high or low values are better; "" if neither. */
  better: "high" | "low" | "";
}

/** Planes a frame may have. */
export type LayerName =
  | "color" // sRGB codes, three planes: r, g, b
  | "id" // visible object, 0 for none
  | "depth" // planar camera depth, world units; NaN or infinite where there is no surface
  | "normal_angle" // angle to the reference's normal, in degrees after multiplication by `scale`
  | "fetches" // texture lookups
  | "iterations" // of the search
  | "uncertain" // 1: the visible object is uncertain (reference only)
  | "failing" // number of techniques that fail at the pixel (summary only)
  | `shadow.${string}` // 1 in shadow of that light, 0 lit
  | `uncertain.shadow.${string}`; // 1: the shadow is uncertain (reference only)

/** A frame that the page can show. */
export interface FrameEntry {
  /** Unique. */
  id: string;
  /** Of a technique: its name in the results, unique among techniques. */
  name: string;
  kind: "reference" | "proxy" | "technique" | "summary";
  /** Relative to the page; absent if the report is a single file. */
  file: string;
  layers: LayerName[];
  /** Share of the domain with a depth error above curves.thresholds[i]; absent without depth or relief. */
  badpix?: number[];
  /**
   * Number of pixels by signed depth error: counts[i] with edges[i] <= e < edges[i+1] of curves.edges; below
   * and above: those beyond the ends. /
   */
  histogram?: { counts: number[]; below: number; above: number };
}

export interface ReportData {
  schema: 1;
  width: number;
  height: number;
  results: Results;
  metrics: MetricInfo[];
  /** The reference first; none if nothing could be drawn. */
  frames: FrameEntry[];
  /** Objects by id - 1; their relief depth in world units, null if unknown or none. */
  objects: { id: number; name: string; relief_depth: number | null }[];
  /** Default range of signed depth errors, world units, and how it was chosen. */
  depth_range: { world: number; note: string };
  /** The number of techniques that the layer "failing" counts, and the definition of failing. */
  failing: { of: number; meaning: string };
  /** In relief depths. `named`: the thresholds of the metrics badpix_…pct. */
  curves: { thresholds: number[]; named: number[]; edges: number[] };
  /** The tables of validate/report/colors.h as "#rrggbb": classes of pixels, and the stops of color maps. */
  colors: {
    palette: { [color in PaletteColor]: string };
    maps: { [map in MapName]: { low: number; stops: string[] } };
  };
  /** Shadow values from this one on are dark. */
  shadow_threshold: number;
}
export type PaletteColor =
  | "nothing"
  | "agree"
  | "missing"
  | "extra"
  | "other"
  | "dark"
  | "invalid"
  | "unshared"
  | "uncertain_agrees"
  | "uncertain_differs";
export type MapName = "diverging" | "sequential" | "gray";

/** Whether a value of an uncertainty plane is uncertain, as in validate/metrics/frame_pair.h; NaN is. */
export function saysUncertain(value: number): boolean {
  return !(value < 0.5);
}

export function readReportData(): ReportData {
  const element = document.getElementById("report-data");
  if (!element) throw new Error("the page has no element report-data");
  return JSON.parse(element.textContent ?? "") as ReportData;
}
