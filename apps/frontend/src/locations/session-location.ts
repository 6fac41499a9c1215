import type { RouteLocationRaw } from 'vue-router';

/** Path of a new session as text. */
export const NEW_TEXT_PATH = '/sessions/new/text';

/** Location of a session. */
export function sessionLocation(id: string): RouteLocationRaw {
  return { path: `/sessions/${encodeURIComponent(id)}` };
}

/** Location of the text editor of a session, optionally at a line. */
export function sessionTextLocation(id: string, line?: number): RouteLocationRaw {
  const hash = line === undefined ? '' : `#L${line}`;
  return { path: `/sessions/${encodeURIComponent(id)}/text`, hash };
}

/**
 * Location of the text editor of a new session.
 * @param id of the new session, when coming from its graph page
 */
export function newTextLocation(id?: string): RouteLocationRaw {
  return { path: NEW_TEXT_PATH, query: id === undefined ? {} : { id } };
}
