/** Longer names are not compared, because they are not typed by hand. */
const MAX_LENGTH = 64;

/** The name that was probably meant; undefined when none is near. */
export function nearestName(wrong: string, names: readonly string[]): string | undefined {
  if (wrong.length > MAX_LENGTH) return undefined;
  let nearest: string | undefined;
  let least = Math.max(1, Math.floor(wrong.length / 3)) + 1;
  for (const name of names) {
    if (name.length > MAX_LENGTH) continue;
    const distance = editDistance(wrong.toLowerCase(), name.toLowerCase());
    if (distance >= least) continue;
    least = distance;
    nearest = name;
  }
  return nearest;
}

/** Sentence about a name that is not declared. */
export function undeclaredName(
  kind: 'Input' | 'Output',
  name: string,
  declared: readonly string[],
): string {
  const sentence = `${kind} "${name.slice(0, MAX_LENGTH)}" is not declared.`;
  const nearest = nearestName(name, declared);
  if (nearest !== undefined) return `${sentence} Did you mean "${nearest}"?`;
  const kinds = `${kind.toLowerCase()}s`;
  if (declared.length === 0) return `${sentence} The module declares no ${kinds}.`;
  return `${sentence} Declared ${kinds}: ${declared.map((one) => `"${one}"`).join(', ')}.`;
}

/** Letters to insert, delete, replace or swap with the next one (optimal string alignment). */
function editDistance(a: string, b: string): number {
  let before: number[] = [];
  let row = Array.from({ length: b.length + 1 }, (_, j) => j);
  for (let i = 1; i <= a.length; i++) {
    const next = [i];
    for (let j = 1; j <= b.length; j++) {
      const replaced = row[j - 1]! + (a[i - 1] === b[j - 1] ? 0 : 1);
      let least = Math.min(replaced, row[j]! + 1, next[j - 1]! + 1);
      const isSwap = j > 1 && a[i - 1] === b[j - 2] && a[i - 2] === b[j - 1];
      if (isSwap) least = Math.min(least, before[j - 2]! + 1);
      next.push(least);
    }
    before = row;
    row = next;
  }
  return row[b.length]!;
}
