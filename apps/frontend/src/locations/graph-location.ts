import type { RouteLocationRaw } from 'vue-router';
import { randomUuid } from '../connection/random-uuid.ts';

/**
 * Location of a session's graph editor.
 * @param isNew the master does not have it yet: the editor starts with an empty graph
 */
export function graphLocation(id: string, isNew = false): RouteLocationRaw {
  const path = `/sessions/${encodeURIComponent(id)}/graph`;
  return isNew ? { path, state: { [NEW]: true } } : { path };
}

/** Location of the graph editor for a new session with one module of the library. */
export function newSessionWith(moduleName: string): RouteLocationRaw {
  const path = `/sessions/${encodeURIComponent(randomUuid())}/graph`;
  return { path, state: { [NEW]: true, [MODULE]: moduleName } };
}

/** History state that marks the page of a session that the master does not have yet. */
const NEW = 'newSession';
/** History state with the name of the initial module. */
const MODULE = 'newSessionModule';

/** Returns whether the page was opened for a new session, also after a reload. */
export function isNewSession(): boolean {
  const { state } = history as { readonly state: Readonly<Record<string, unknown>> | null };
  return state?.[NEW] === true;
}

/** Name of the initial module of a new session. */
export function newSessionModule(): string | undefined {
  const { state } = history as { readonly state: Readonly<Record<string, unknown>> | null };
  const name = state?.[MODULE];
  return typeof name === 'string' ? name : undefined;
}
