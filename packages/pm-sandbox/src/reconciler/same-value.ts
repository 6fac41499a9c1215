/** Whether two values of decoded messages are equal, in whatever order their members were set. */
export function isSameValue(one: unknown, other: unknown): boolean {
  return one === other || textOf(one) === textOf(other);
}

/** JSON with sorted members; one that is undefined is left out. */
function textOf(value: unknown): string | undefined {
  return JSON.stringify(value, (_name, member: unknown) =>
    typeof member === 'object' && member !== null && !Array.isArray(member)
      ? Object.fromEntries(Object.entries(member).sort(([a], [b]) => (a < b ? -1 : 1)))
      : member,
  );
}
