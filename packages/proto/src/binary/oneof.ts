/** The member of a oneof that is set. */
export function setMember<K extends string>(
  message: { readonly [P in K]?: unknown },
  members: readonly K[],
): string | undefined {
  return members.find((member) => message[member] !== undefined);
}

/** Unsets the member of a oneof that was set before, when it is another one; returns the new one. */
export function only(message: object, before: string | undefined, now: string): string {
  if (before !== undefined && before !== now) {
    delete (message as Record<string, unknown>)[before];
  }
  return now;
}
