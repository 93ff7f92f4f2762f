// The values of a layer of a frame per pixel: each pixel has a value, or it is in a category that gives the
// reason why it has none. In some layers every pixel is in a category. Painting, legend, ranges and readout
// use this.
import type { LayerName, MapName } from "../data";
import type { FrameData } from "../frame_store";
import type { Layer } from "../layer_unpacking";
import type { Colors, Packed } from "./colors";
import type { LayerKey } from "./layers";

export type DepthUnit = "world" | "relief";

export interface Category {
  label: string;
  color: Packed;
  /** Listed in the legend even if no pixel is in it. */
  always?: boolean;
}

export interface Reading {
  layer: LayerKey;
  /** The color map of values; "picture": values are colors; "none": there are no values. */
  map: MapName | "picture" | "none";
  /** Unit of the values; "" for pictures and categories. */
  unit: string;
  /** A sentence for the legend. */
  note?: string;
  categories: Category[];
  /** Index into categories; -1 if the pixel has a value. */
  categoryAt(pixel: number): number;
  /** NaN if the pixel has none; for a picture the packed color. */
  valueAt(pixel: number): number;
}

export type Palette = Colors["palette"];
export const nothing = ({ nothing: color }: Palette): Category => ({ label: "nothing there", color });
export const invalid = ({ invalid: color }: Palette): Category => ({ label: "not a finite number", color });

export function plane(frame: FrameData, name: LayerName): Layer {
  const layer = frame.get(name);
  if (!layer) throw new Error(`${frame.label} has no plane '${name}'`);
  return layer;
}
