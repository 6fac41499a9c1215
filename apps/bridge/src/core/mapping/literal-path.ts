import type { AddressPath } from './address-path.ts';

/** A path of exactly this text, whatever characters it has. */
export function literalPath(text: string): AddressPath {
  const levels = text
    .split('/')
    .map((before) => ({ before, capture: undefined, after: '', isRest: false }));
  return { text, levels };
}
