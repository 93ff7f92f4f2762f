// Marks the pixel whose values are shown.
import { make } from "./dom";
import type { Pixel, Placement } from "./zoom";

/** Smallest size of the box around the pixel, CSS pixels. */
const kBoxPx = 11;

export class Crosshair {
  readonly element = make("div", { class: "crosshair", hidden: true }, ...[1, 2, 3, 4].map(() => make("i")));

  draw(pixel: Pixel | null, { scale, left, top }: Placement): void {
    this.element.hidden = pixel === null;
    if (!pixel) return;
    const size = Math.max(scale, kBoxPx);
    const x = left + (pixel.x + 0.5) * scale - size / 2;
    const y = top + (pixel.y + 0.5) * scale - size / 2;
    this.element.style.transform = `translate(${x}px, ${y}px)`;
    this.element.style.width = this.element.style.height = `${size}px`;
  }
}
