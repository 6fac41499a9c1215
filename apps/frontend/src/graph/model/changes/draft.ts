import { toJson, type Session } from '@ubii/proto';
import * as v from 'valibot';
import { readStored } from '../../../json/read-stored.ts';
import { message } from '../../../json/schemas.ts';

const SESSION = 'ubii.sessions.Session';
const PREFIX = 'ubii.graph.draft.';
const VERSION = 1;

/** Work on a session that is not saved. */
export interface Draft {
  readonly sessionId: string;
  /** Revision of the session it began with. */
  readonly revision: number;
  /** The session it began with: what others did since can be merged. */
  readonly base: Session;
  readonly edited: Session;
  /** Epoch milliseconds. */
  readonly savedMs: number;
}

/** Where drafts are kept; `localStorage` is one. */
export type DraftStorage = Pick<Storage, 'getItem' | 'setItem' | 'removeItem' | 'key' | 'length'>;

/** A draft as text. */
export function draftText({ sessionId, revision, base, edited, savedMs }: Draft): string {
  return JSON.stringify({
    version: VERSION,
    sessionId,
    revision,
    savedMs,
    base: toJson(SESSION, base),
    edited: toJson(SESSION, edited),
  });
}

const DRAFT = v.pipe(
  v.object({
    version: v.literal(VERSION),
    sessionId: v.string(),
    revision: v.number(),
    savedMs: v.number(),
    base: message(SESSION),
    edited: message(SESSION),
  }),
  v.transform(({ version: _, ...draft }): Draft => draft),
);

/** A draft of its text; undefined when it is none of ours. */
export const parseDraft = (text: string): Draft | undefined => readStored(DRAFT, text);

/** @returns false when there is no room, or storing is not allowed: people have to know */
export function saveDraft(storage: DraftStorage, draft: Draft): boolean {
  try {
    storage.setItem(`${PREFIX}${draft.sessionId}`, draftText(draft));
    return true;
  } catch {
    return false;
  }
}

export function findDraft(storage: DraftStorage, sessionId: string): Draft | undefined {
  try {
    const text = storage.getItem(`${PREFIX}${sessionId}`);
    const draft = text === null ? undefined : parseDraft(text);
    return draft?.sessionId === sessionId ? draft : undefined;
  } catch {
    return undefined;
  }
}

export function removeDraft(storage: DraftStorage, sessionId: string): void {
  try {
    storage.removeItem(`${PREFIX}${sessionId}`);
  } catch {
    // Where nothing can be stored there is nothing to remove.
  }
}

/** The sessions that drafts are kept of, by their ids. */
export function draftIds(storage: DraftStorage): ReadonlySet<string> {
  try {
    const keys = Array.from({ length: storage.length }, (_, index) => storage.key(index) ?? '');
    return new Set(
      keys.filter((key) => key.startsWith(PREFIX)).map((key) => key.slice(PREFIX.length)),
    );
  } catch {
    return new Set();
  }
}
