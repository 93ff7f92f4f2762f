// The Pareto front: what no other beats. Kung, Luccio, Preparata (1975), "On finding the maxima of a set of vectors", in two
// dimensions: sorted by one, swept over the other.

export interface Rated {
  cost: number;
  /** The higher the better. */
  merit: number;
}

/** Those of which no other is as good in both and better in one; equals stay together. By ascending cost. */
export function paretoFront<T extends Rated>(points: readonly T[]): T[] {
  const front: T[] = [];
  for (const point of [...points].sort((a, b) => a.cost - b.cost || b.merit - a.merit)) {
    const last = front.at(-1);
    if (!last || point.merit > last.merit || (point.merit === last.merit && point.cost === last.cost)) front.push(point);
  }
  return front;
}
