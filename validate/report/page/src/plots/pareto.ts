// The Pareto front in two dimensions, by sorting along one and a sweep over the other. Kung, Luccio,
// Preparata (1975), "On finding the maxima of a set of vectors".

export interface Rated {
  cost: number;
  /** Higher is better. */
  merit: number;
}

/**
 * The Pareto-optimal points: no other point is at least as good in both dimensions and better in one. Equal
 * points are all included. Sorted by ascending cost. /
 */
export function paretoFront<T extends Rated>(points: readonly T[]): T[] {
  const front: T[] = [];
  for (const point of [...points].sort((a, b) => a.cost - b.cost || b.merit - a.merit)) {
    const last = front.at(-1);
    if (!last || point.merit > last.merit || (point.merit === last.merit && point.cost === last.cost))
      front.push(point);
  }
  return front;
}
