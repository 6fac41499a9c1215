/** A source of the rotation: a phone, or a browser with a mouse. */
export interface TurnSource {
  readonly clientId: string;
  readonly name: string;
  readonly isPhone: boolean;
  readonly isOwn: boolean;
}

/** Returns a key of a source. A client can be two sources: a phone, and a browser with this page. */
export function keyOf({ clientId, isPhone }: Pick<TurnSource, 'clientId' | 'isPhone'>): string {
  return `${isPhone ? 'phone' : 'browser'} ${clientId}`;
}

/**
 * Returns the source of the rotation: the one that the user chose; otherwise the newest phone that publishes its
 * orientation; otherwise this browser.
 *
 * @param moving clients of phones that publish their orientation, the newest last
 */
export function chooseSource<T extends Omit<TurnSource, 'name'>>(
  sources: readonly T[],
  wanted: string | undefined,
  moving: readonly string[],
): T | undefined {
  const chosen = sources.find((one) => keyOf(one) === wanted);
  const phones = sources
    .filter(({ isPhone, clientId }) => isPhone && moving.includes(clientId))
    .sort((a, b) => moving.indexOf(b.clientId) - moving.indexOf(a.clientId));
  return chosen ?? phones[0] ?? sources.find(({ isOwn, isPhone }) => isOwn && !isPhone);
}
