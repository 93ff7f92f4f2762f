// The Pareto front in two dimensions: sorted by one, swept over the other. Kung, Luccio, Preparata (1975),
// "On finding the maxima of a set of vectors".

export interface Rated {
  cost: number;
  /** Higher is better. */
  merit: number;
}

/**
 * The points for which no other is at least as good in both and better in one; with all of equal points. By
 * ascending cost.
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
