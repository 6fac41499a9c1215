import type { AccessSecrets } from '../ports/access-secrets.ts';

/** Crockford's letters and digits: none is taken for another. https://www.crockford.com/base32.html */
const ALPHABET = '0123456789ABCDEFGHJKMNPQRSTVWXYZ';
const LENGTH = 8;

/** A new code as people see it: `K7QF-2MXR`, 40 random bits [AC-11]. */
export function createJoinCode(secrets: AccessSecrets): string {
  const letters = secrets.numbers(LENGTH, ALPHABET.length).map((number) => ALPHABET[number]);
  return `${letters.slice(0, 4).join('')}-${letters.slice(4).join('')}`;
}

/** Normalises a typed code; undefined for a text that is not a code. */
export function readJoinCode(typed: string): string | undefined {
  if (typed.length > 4 * LENGTH) return undefined;
  const code = typed
    .toUpperCase()
    .replace(/[\s_.-]/g, '')
    .replace(/O/g, '0')
    .replace(/[IL]/g, '1');
  const isCode = code.length === LENGTH && [...code].every((letter) => ALPHABET.includes(letter));
  return isCode ? code : undefined;
}
