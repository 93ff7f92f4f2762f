// Places labels next to points so that none overlaps another label, a point or the edge of the plot.

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
  /** Whether it is so far from its point that it needs a leader line. */
  needsLine: boolean;
}

const kLineHeightPx = 14;
const kGapPx = 7;
/**
 * Vertical distance from a point to the nearest label, which stays clear of a horizontal line through the
 * point.
 */
const kFirstRisePx = 10;
/** Number of rings of candidate places around a point, at a spacing of one line height. */
const kRings = 9;

/** A place within `inside` for each label, clear of `points`; undefined if there is no space for it. */
export function placeLabels(
  labels: { x: number; y: number; widthPx: number }[],
  points: { x: number; y: number }[],
  inside: Box,
): (LabelPlace | undefined)[] {
  const used: Box[] = points.map(({ x, y }) => ({ left: x - 4, top: y - 4, right: x + 4, bottom: y + 4 }));
  return labels.map((label) => {
    for (const { x, y, needsLine } of placesAround(label)) {
      const box = {
        left: x,
        top: y - kLineHeightPx / 2,
        right: x + label.widthPx,
        bottom: y + kLineHeightPx / 2,
      };
      if (!within(box, inside) || used.some((other) => overlap(box, other))) continue;
      used.push(box);
      return { x, y, needsLine };
    }
    return undefined;
  });
}

function* placesAround(label: { x: number; y: number; widthPx: number }): Generator<LabelPlace> {
  const lefts = [label.x + kGapPx, label.x - kGapPx - label.widthPx, label.x - label.widthPx / 2];
  for (let ring = 0; ring < kRings; ++ring)
    for (const side of [-1, 1])
      for (const x of lefts)
        yield { x, y: label.y + side * (kFirstRisePx + ring * kLineHeightPx), needsLine: ring > 0 };
}

function within(box: Box, frame: Box): boolean {
  return (
    box.left >= frame.left && box.right <= frame.right && box.top >= frame.top && box.bottom <= frame.bottom
  );
}

function overlap(a: Box, b: Box): boolean {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}
