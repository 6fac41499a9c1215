const NUMBERED = /^(.*?)(\d+)$/;

/**
 * The code for the next participant: one more than the largest with the letters of the newest code.
 * @param codes that are used, the newest first
 */
export function nextCode(codes: readonly string[]): string {
  const newest = codes.map((code) => NUMBERED.exec(code)).find((match) => match !== null);
  if (!newest) return 'P01';
  const letters = newest[1]!;
  const digits = codes
    .map((code) => NUMBERED.exec(code))
    .filter((match) => match?.[1] === letters)
    .map((match) => match![2]!);
  const next = Math.max(...digits.map(Number)) + 1;
  const width = Math.max(...digits.map(({ length }) => length));
  return `${letters}${String(next).padStart(width, '0')}`;
}
