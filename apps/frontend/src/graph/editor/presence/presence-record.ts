import * as v from 'valibot';
import { readStored } from '../../../json/read-stored.ts';
import { flag, validElements } from '../../../json/schemas.ts';

/** What one editor says of itself. */
export interface PresenceRecord {
  /** Id of the session that is open in it; empty: none any more. */
  readonly session: string;
  /** Ids of the nodes that are selected. */
  readonly nodes: readonly string[];
  /** It has changes that are not saved. */
  readonly isEditing: boolean;
  /** Its page is not seen now; until it says otherwise, it says nothing. */
  readonly isHidden: boolean;
  /** The newest revision that was saved in it; -1: none. */
  readonly savedRevision: number;
}

/** More are not drawn anyway. [EX-49] */
export const MAX_NODES = 64;
/** Longer texts are not presence records. [EX-49] */
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
