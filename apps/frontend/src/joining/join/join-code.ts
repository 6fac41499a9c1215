/** Length of a short code, letters and digits; O, I and L are read as 0 and 1. [AC-11] */
const CODE_LENGTH = 8;

/** Formats typed or pasted text as a code: `K7QF-2MXR`. Returns the token of a pasted address. */
export function formatCode(typed: string): string {
  const plain = typed
    .toUpperCase()
    .replace(/[^A-Z0-9]/g, '')
    .slice(0, CODE_LENGTH);
  return plain.length > 4 ? `${plain.slice(0, 4)}-${plain.slice(4)}` : plain;
}

/** True when the code is complete. */
export function isWholeCode(code: string): boolean {
  return code.replaceAll('-', '').length === CODE_LENGTH;
}

/** Returns the token in a join URL, as in the QR code; `undefined` without one. */
export function tokenOf(text: string): string | undefined {
  const fragment = /#(.+)$/.exec(text.trim())?.[1];
  if (fragment === undefined) return undefined;
  try {
    return decodeURIComponent(fragment);
  } catch {
    return fragment;
  }
}
