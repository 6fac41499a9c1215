import * as v from 'valibot';
import { readStored } from '../../../json/read-stored.ts';
import { flag, validElements } from '../../../json/schemas.ts';

/** State of one editor, published for other users. */
export interface PresenceRecord {
  /** Id of the open session; empty: none any more. */
  readonly session: string;
  /** Ids of the selected nodes. */
  readonly nodes: readonly string[];
  /** True with unsaved changes. */
  readonly isEditing: boolean;
  /** True while the page is hidden; it sends no records until it is visible again. */
  readonly isHidden: boolean;
  /** Newest revision saved by this editor; -1: none. */
  readonly savedRevision: number;
}

/** Most node ids in a record. [EX-49] */
export const MAX_NODES = 64;
/** Longest presence record, characters. [EX-49] */
const MAX_LENGTH = 16_384;

export function presenceText(record: PresenceRecord): string {
  const { session, nodes, isEditing, isHidden, savedRevision } = record;
  return JSON.stringify({
    session,
    ...(nodes.length > 0 && { nodes: nodes.slice(0, MAX_NODES) }),
    ...(isEditing && { editing: true }),
    ...(isHidden && { hidden: true }),
    ...(savedRevision >= 0 && { saved: savedRevision }),
  });
}

const RECORD = v.pipe(
  v.object({
    session: v.string(),
    nodes: v.fallback(validElements(v.string(), MAX_NODES), []),
    editing: flag,
    hidden: flag,
    saved: v.fallback(v.number(), -1),
  }),
  v.transform(({ session, nodes, editing, hidden, saved }): PresenceRecord => ({
    session,
    nodes,
    isEditing: editing,
    isHidden: hidden,
    savedRevision: saved,
  })),
);

/** Parses a presence record; undefined for other texts, because any client may publish there. */
export const parsePresence = (text: string): PresenceRecord | undefined =>
  readStored(RECORD, text, MAX_LENGTH);
