import type { RouteLocationRaw } from 'vue-router';
import { randomUuid } from '../connection/random-uuid.ts';

/**
 * Where the graph of a session is edited.
 * @param isNew the master does not have it yet: the page starts with an empty graph
 */
export function graphLocation(id: string, isNew = false): RouteLocationRaw {
  const path = `/sessions/${encodeURIComponent(id)}/graph`;
  return isNew ? { path, state: { [NEW]: true } } : { path };
}

/** Where a new session with one module of the library is edited. */
export function newSessionWith(moduleName: string): RouteLocationRaw {
  const path = `/sessions/${encodeURIComponent(randomUuid())}/graph`;
  return { path, state: { [NEW]: true, [MODULE]: moduleName } };
}

/** History state of the page of a session that the master does not have yet. */
const NEW = 'newSession';
/** Name of the module it begins with. */
const MODULE = 'newSessionModule';

/** Returns whether the page was opened for a new session, also after a reload. */
export function isNewSession(): boolean {
  const { state } = history as { readonly state: Readonly<Record<string, unknown>> | null };
  return state?.[NEW] === true;
}

/** Name of the module that a new session begins with. */
export function newSessionModule(): string | undefined {
  const { state } = history as { readonly state: Readonly<Record<string, unknown>> | null };
  const name = state?.[MODULE];
  return typeof name === 'string' ? name : undefined;
}
