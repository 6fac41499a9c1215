import { brokenImport, type Imported } from '../../../json/read-imported.ts';
import type { Layout } from './layout.ts';
import { layoutJson, linkedLayout } from './layout-json.ts';

/** Longest link, characters: messengers and mail clients cut longer ones. */
export const MAX_LINK = 6000;
const PREFIX = '#layout=';

/**
 * Encodes the whole layout as the hash of a URL, which browsers do not send to servers.
 * @returns `undefined` when it would be too long
 */
export function layoutHash(layout: Layout): string | undefined {
  const bytes = new TextEncoder().encode(JSON.stringify(layoutJson(layout)));
  const letters = btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(''));
  const hash = PREFIX + letters.replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
  return hash.length > MAX_LINK ? undefined : hash;
}

/** @returns `undefined` for an address without a layout */
export function layoutOfHash(hash: string): Imported<Layout> | undefined {
  if (!hash.startsWith(PREFIX)) return undefined;
  if (hash.length > MAX_LINK) return brokenImport('This link is too long for a layout.');
  const letters = hash.slice(PREFIX.length).replaceAll('-', '+').replaceAll('_', '/');
  let json: unknown;
  try {
    const bytes = Uint8Array.from(atob(letters), (letter) => letter.charCodeAt(0));
    json = JSON.parse(new TextDecoder('utf-8', { fatal: true }).decode(bytes));
  } catch {
    return brokenImport('The layout in this link cannot be read. It may be cut off.');
  }
  return linkedLayout(json);
}
