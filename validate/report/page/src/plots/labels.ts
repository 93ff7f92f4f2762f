// Names beside points, moved apart so that none covers another, a point or the plot's edge.

export interface Box {
  left: number;
  top: number;
  right: number;
  bottom: number;
}
export interface LabelPlace {
  /** Middle of the left edge, pixels. */
  x: number;
  y: number;
  /** Far enough from its point to need a line to it. */
  apart: boolean;
}

const kLineHeightPx = 14;
const kGapPx = 7;
/** From a point up or down to the nearest label: clear of a horizontal line through the point. */
const kFirstRisePx = 10;
/** Rings of places to try around a point, a line height apart. */
const kRings = 9;

/** A place inside of `inside` for each label, clear of `points`; undefined for one that fits nowhere. */
export function placeLabels(
  labels: { x: number; y: number; widthPx: number }[],
  points: { x: number; y: number }[],
  inside: Box,
): (LabelPlace | undefined)[] {
  const taken: Box[] = points.map(({ x, y }) => ({ left: x - 4, top: y - 4, right: x + 4, bottom: y + 4 }));
  return labels.map((label) => {
    for (const { x, y, apart } of placesAround(label)) {
      const box = {
        left: x,
        top: y - kLineHeightPx / 2,
        right: x + label.widthPx,
        bottom: y + kLineHeightPx / 2,
      };
      if (!within(box, inside) || taken.some((other) => overlap(box, other))) continue;
      taken.push(box);
      return { x, y, apart };
    }
    return undefined;
  });
}

function* placesAround(label: { x: number; y: number; widthPx: number }): Generator<LabelPlace> {
  const lefts = [label.x + kGapPx, label.x - kGapPx - label.widthPx, label.x - label.widthPx / 2];
  for (let ring = 0; ring < kRings; ++ring)
    for (const side of [-1, 1])
      for (const x of lefts)
        yield { x, y: label.y + side * (kFirstRisePx + ring * kLineHeightPx), apart: ring > 0 };
}

function within(box: Box, frame: Box): boolean {
  return (
    box.left >= frame.left && box.right <= frame.right && box.top >= frame.top && box.bottom <= frame.bottom
  );
}

function overlap(a: Box, b: Box): boolean {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}
