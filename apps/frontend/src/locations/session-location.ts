import type { RouteLocationRaw } from 'vue-router';

/** A new session as text. */
export const NEW_TEXT_PATH = '/sessions/new/text';

/** Where a session is shown. */
export function sessionLocation(id: string): RouteLocationRaw {
  return { path: `/sessions/${encodeURIComponent(id)}` };
}

/** Where the text of a session is edited; at a line, to be shown there. */
export function sessionTextLocation(id: string, line?: number): RouteLocationRaw {
  const hash = line === undefined ? '' : `#L${line}`;
  return { path: `/sessions/${encodeURIComponent(id)}/text`, hash };
}

/**
 * Where a new session is written as text.
 * @param id of the new session on the graph page, if it was there before
 */
export function newTextLocation(id?: string): RouteLocationRaw {
  return { path: NEW_TEXT_PATH, query: id === undefined ? {} : { id } };
}
