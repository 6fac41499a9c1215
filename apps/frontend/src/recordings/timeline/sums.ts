/** Sums of counts in fewer parts of equal length; a count at an edge is shared. */
export function sumsOf(counts: ArrayLike<number>, parts: number): number[] {
  const sums = Array.from({ length: parts }, () => 0);
  const partsEach = parts / counts.length;
  for (let index = 0; index < counts.length; index += 1) {
    const from = index * partsEach;
    const until = from + partsEach;
    for (let part = Math.floor(from); part < parts && part < until; part += 1) {
      const covered = Math.min(until, part + 1) - Math.max(from, part);
      sums[part]! += (counts[index]! * covered) / partsEach;
    }
  }
  return sums;
}
