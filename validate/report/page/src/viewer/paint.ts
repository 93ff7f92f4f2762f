// Converts layers to pixels of a canvas.
import { colorAt, type Colors, type Packed } from "./colors";
import type { Range } from "./ranges";
import type { Reading } from "./reading";

export interface Painting {
  /** Packed, row 0 = top. */
  pixels: Uint32Array<ArrayBuffer>;
  /** Number of pixels in each category of the reading. */
  counts: number[];
}

/** `value`: not NaN. */
function colorOfValue(
  { palette, maps }: Colors,
  map: Reading["map"],
  value: number,
  [low, high]: Range,
): Packed {
  switch (map) {
    case "picture":
      return value;
    case "none":
      return palette.invalid;
    case "diverging":
      return colorAt(maps[map], value / high);
    case "sequential":
    case "gray":
      return colorAt(maps[map], (value - low) / (high - low));
  }
}

export function paintLayer(colors: Colors, reading: Reading, range: Range, pixelCount: number): Painting {
  const pixels = new Uint32Array(pixelCount);
  const counts = reading.categories.map(() => 0);
  const categoryColors = reading.categories.map((category) => category.color);
  for (let pixel = 0; pixel < pixelCount; ++pixel) {
    const category = reading.categoryAt(pixel);
    if (category >= 0) {
      pixels[pixel] = categoryColors[category];
      ++counts[category];
    } else {
      pixels[pixel] = colorOfValue(colors, reading.map, reading.valueAt(pixel), range);
    }
  }
  return { pixels, counts };
}
