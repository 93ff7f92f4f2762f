// The layers that a pane can show of a frame, and the reasons why others can't be shown.
import type { FrameEntry, LayerName, ReportData } from "../data";
import { referenceOf } from "../frames";

export type LayerKey =
  | "color"
  | "silhouette"
  | "depth_error"
  | `shadow.${string}`
  | "normal_angle"
  | "fetches"
  | "iterations"
  | "depth"
  | "failing";

export interface LayerInfo {
  key: LayerKey;
  label: string;
  /** Planes of the frame and of the reference that it requires. */
  ofFrame: LayerName[];
  ofReference: LayerName[];
  /** Planes of the reference that it uses if they exist. */
  uncertain?: LayerName[];
}

/** In the order of the menu, with a shadow layer for each light of the reference. */
export function layersOf(report: ReportData): LayerInfo[] {
  const lights = (referenceOf(report)?.layers ?? []).filter((layer): layer is `shadow.${string}` =>
    layer.startsWith("shadow."),
  );
  return [
    { key: "color", label: "Color", ofFrame: ["color"], ofReference: [] },
    {
      key: "silhouette",
      label: "Silhouette difference",
      ofFrame: ["id"],
      ofReference: ["id"],
      uncertain: ["uncertain"],
    },
    { key: "depth_error", label: "Depth error", ofFrame: ["id", "depth"], ofReference: ["id", "depth"] },
    ...lights.map((light): LayerInfo => ({
      key: light,
      label: `Shadow difference, ${light.slice("shadow.".length)}`,
      ofFrame: ["id", light],
      ofReference: ["id", light],
      uncertain: ["uncertain", `uncertain.${light}`],
    })),
    { key: "normal_angle", label: "Normal angle", ofFrame: ["id", "normal_angle"], ofReference: ["id"] },
    { key: "fetches", label: "Lookups", ofFrame: ["id", "fetches"], ofReference: [] },
    { key: "iterations", label: "Iterations", ofFrame: ["id", "iterations"], ofReference: [] },
    { key: "depth", label: "Depth", ofFrame: ["id", "depth"], ofReference: [] },
    { key: "failing", label: "Share of failing techniques", ofFrame: ["failing"], ofReference: [] },
  ];
}

const kPlaneWords: { [plane: string]: string } = {
  color: "no color",
  id: "no object ids",
  depth: "no depth",
  normal_angle: "no normals",
  fetches: "no count of lookups",
  iterations: "no count of iterations",
};

/** Why the frame's layer can't be shown; undefined if it can. */
export function reasonAgainst(report: ReportData, layer: LayerInfo, frame: FrameEntry): string | undefined {
  if (frame.kind === "summary" && layer.key !== "failing") return "not for all techniques together";
  if (frame.kind !== "summary" && layer.key === "failing") return "only for all techniques together";
  if (frame.kind === "reference" && layer.key === "depth_error") return "the reference compared with itself";
  const lacking = layer.ofFrame.find((plane) => !frame.layers.includes(plane));
  if (lacking) return kPlaneWords[lacking] ?? "no such shadow";
  const reference = referenceOf(report);
  const lackingThere = layer.ofReference.find((plane) => !reference?.layers.includes(plane));
  return lackingThere ? `${kPlaneWords[lackingThere] ?? "no such shadow"} in the reference` : undefined;
}
