import type { RouteLocationRaw } from 'vue-router';
import { randomUuid } from '../connection/random-uuid.ts';

/** Path that opens a new session with its JSON. */
export const NEW_TEXT_PATH = '/sessions/new/text';

/** Drawers below the graph of a session, as they are called in its address. */
export const SESSION_DRAWERS = ['log', 'statistics', 'text'] as const;
export type SessionDrawer = (typeof SESSION_DRAWERS)[number];

const pathOf = (id: string): string => `/sessions/${encodeURIComponent(id)}`;

/**
 * Location of a session: its graph.
 * @param isNew the master does not have it yet: the editor starts with an empty graph
 */
export function sessionLocation(id: string, isNew = false): RouteLocationRaw {
  return isNew ? { path: pathOf(id), state: { [NEW]: true } } : { path: pathOf(id) };
}

/** Location of a session with one of its drawers open. */
export function sessionDrawerLocation(id: string, drawer: SessionDrawer): RouteLocationRaw {
  return { path: `${pathOf(id)}/${drawer}` };
}

/** Location of the JSON of a session, optionally at a line. */
export function sessionTextLocation(id: string, line?: number): RouteLocationRaw {
  const hash = line === undefined ? '' : `#L${line}`;
  return { path: `${pathOf(id)}/text`, hash };
}

/**
 * Location of a new session with its JSON open; the JSON starts with the text of `useSessionDraft()`.
 * @param isChecked the master checks that text at once
 */
export function newTextLocation(isChecked = false): RouteLocationRaw {
  const state = { [NEW]: true, [TEXT]: isChecked ? 'checked' : 'open' };
  return { path: `${pathOf(randomUuid())}/text`, state };
}

/** Location of a new session with one module of the library. */
export function newSessionWith(moduleName: string): RouteLocationRaw {
  return { path: pathOf(randomUuid()), state: { [NEW]: true, [MODULE]: moduleName } };
}

/** Id of the session whose page was open before this one; undefined when another page was. */
export function sessionBefore(): string | undefined {
  const path = historyState('back');
  const id = typeof path === 'string' ? /^\/sessions\/([^/?#]+)/.exec(path)?.[1] : undefined;
  return id === undefined ? undefined : decodeURIComponent(id);
}

/** State of the history after the first save of a new session. */
export const SAVED_STATE = { newSession: false, newSessionModule: null, newSessionText: null };

/** History state that marks the page of a session that the master does not have yet. */
const NEW = 'newSession';
/** History state with the name of the initial module. */
const MODULE = 'newSessionModule';
/** History state of a session that begins as a text. */
const TEXT = 'newSessionText';

function historyState(name: string): unknown {
  const { state } = history as { readonly state: Readonly<Record<string, unknown>> | null };
  return state?.[name];
}

/** Returns whether the page was opened for a new session, also after a reload. */
export function isNewSession(): boolean {
  return historyState(NEW) === true;
}

/** Name of the initial module of a new session. */
export function newSessionModule(): string | undefined {
  const name = historyState(MODULE);
  return typeof name === 'string' ? name : undefined;
}

/** How a new session begins as a text; undefined when it does not. */
export function newSessionText(): 'open' | 'checked' | undefined {
  const text = historyState(TEXT);
  return text === 'open' || text === 'checked' ? text : undefined;
}
