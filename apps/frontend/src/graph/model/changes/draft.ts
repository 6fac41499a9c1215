import { toJson, type Session } from '@ubii/proto';
import * as v from 'valibot';
import { readStored } from '../../../json/read-stored.ts';
import { message } from '../../../json/schemas.ts';

const SESSION = 'ubii.sessions.Session';
const PREFIX = 'ubii.graph.draft.';
const VERSION = 1;

/** Unsaved changes of a session. */
export interface Draft {
  readonly sessionId: string;
  /** Revision of the session that the changes are based on. */
  readonly revision: number;
  /** Session that the changes are based on, for merging with later changes of others. */
  readonly base: Session;
  readonly edited: Session;
  /** Epoch milliseconds. */
  readonly savedMs: number;
}

/** Storage for drafts, such as `localStorage`. */
export type DraftStorage = Pick<Storage, 'getItem' | 'setItem' | 'removeItem' | 'key' | 'length'>;

/** Serialises a draft. */
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

/** Parses a draft; undefined for other texts. */
export const parseDraft = (text: string): Draft | undefined => readStored(DRAFT, text);

/** @returns false when the storage is full or not allowed; the user must be told */
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
    // Nothing to remove when storing is not allowed.
  }
}

/** Returns the names of sessions that exist only as drafts. */
export function newDraftNames(storage: DraftStorage): readonly string[] {
  return [...draftIds(storage)].flatMap((id) => {
    const draft = findDraft(storage, id);
    return draft?.revision === 0 ? [draft.edited.name] : [];
  });
}

/** Returns the ids of sessions with drafts. */
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
