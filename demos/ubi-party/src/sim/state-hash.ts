/**
 * A hash of a game's state, 8 hexadecimal digits: equal on all machines that played the same. JSON writes each number
 * in the shortest way that reads back as the same bits (ECMA-262, Number::toString), so no bit is left out but the
 * sign of zero. FNV-1a, 32 bits (draft-eastlake-fnv).
 */
export function stateHash(state: unknown): string {
  const text = JSON.stringify(state);
  let hash = 0x811c9dc5;
  for (let i = 0; i < text.length; i += 1) {
    hash = Math.imul(hash ^ text.charCodeAt(i), 0x01000193);
  }
  return (hash >>> 0).toString(16).padStart(8, '0');
}
