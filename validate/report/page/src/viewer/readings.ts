// Creates the reading of each layer.
import type { ReportData } from "../data";
import type { FrameData } from "../frame_store";
import { colorsOf, packColor } from "./colors";
import { readDepthError, readNormalAngle, readShadow, readSilhouette } from "./difference_readings";
import type { LayerKey } from "./layers";
import { invalid, nothing, plane, type DepthUnit, type Palette, type Reading } from "./reading";

/** Throws if a plane is missing. */
export function readLayer(
  report: ReportData,
  layer: LayerKey,
  frame: FrameData,
  reference: FrameData,
  unit: DepthUnit,
): Reading {
  const { palette } = colorsOf(report);
  switch (layer) {
    case "color":
      return readColor(frame, report.width * report.height);
    case "silhouette":
      return readSilhouette(palette, frame, reference);
    case "depth_error":
      return readDepthError(report, palette, frame, reference, unit);
    case "normal_angle":
      return readNormalAngle(palette, frame, reference);
    case "fetches":
      return readCovered(palette, layer, "lookups", frame, "sequential");
    case "iterations":
      return readCovered(palette, layer, "iterations", frame, "sequential");
    case "depth":
      return readCovered(palette, layer, "world units", frame, "gray");
    case "failing":
      return readFailing(report, palette, frame);
    default:
      return readShadow(report, palette, layer, frame, reference);
  }
}

function readColor(frame: FrameData, pixels: number): Reading {
  const codes = plane(frame, "color");
  const colorAt = (pixel: number) =>
    packColor(codes.at(pixel), codes.at(pixels + pixel), codes.at(2 * pixels + pixel));
  return { layer: "color", map: "picture", unit: "", categories: [], categoryAt: () => -1, valueAt: colorAt };
}

/** A plane at the pixels that the frame covers. */
function readCovered(
  palette: Palette,
  layer: "fetches" | "iterations" | "depth",
  unit: string,
  frame: FrameData,
  map: "sequential" | "gray",
): Reading {
  const id = plane(frame, "id");
  const values = plane(frame, layer);
  return {
    layer,
    map,
    unit,
    categories: [nothing(palette), invalid(palette)],
    categoryAt: (pixel) => (id.at(pixel) === 0 ? 0 : Number.isFinite(values.at(pixel)) ? -1 : 1),
    valueAt: (pixel) => (id.at(pixel) === 0 ? NaN : values.at(pixel)),
  };
}

function readFailing(report: ReportData, palette: Palette, frame: FrameData): Reading {
  const counts = plane(frame, "failing");
  return {
    layer: "failing",
    map: "sequential",
    unit: `of ${report.failing.of} techniques`,
    note: `Failing: ${report.failing.meaning}`,
    categories: [{ ...nothing(palette), label: "none fails" }],
    categoryAt: (pixel) => (counts.at(pixel) > 0 ? -1 : 0),
    valueAt: (pixel) => counts.at(pixel),
  };
}
