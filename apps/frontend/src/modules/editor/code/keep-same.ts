import { isSameValue } from '@ubii/proto';

/**
 * Returns the previous value if the next one is equal, so that what depends on it is not drawn again with each key.
 * @param plain returns a value as plain data, for comparison
 */
export function keepSame<T>(
  before: T | undefined,
  next: T,
  plain: (value: T) => unknown = (value) => value,
): T {
  return before !== undefined && isSameValue(plain(before), plain(next)) ? before : next;
}
