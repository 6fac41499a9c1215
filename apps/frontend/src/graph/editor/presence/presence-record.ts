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

/** Parses a presence record; undefined for other texts, because any client may publish there. */
export function parsePresence(text: string): PresenceRecord | undefined {
  if (text.length > MAX_LENGTH) return undefined;
  try {
    const json = JSON.parse(text) as Readonly<Record<string, unknown>> | null;
    if (typeof json?.session !== 'string') return undefined;
    const nodes: readonly unknown[] = Array.isArray(json.nodes) ? json.nodes : [];
    return {
      session: json.session,
      nodes: nodes.filter((id) => typeof id === 'string').slice(0, MAX_NODES),
      isEditing: json.editing === true,
      isHidden: json.hidden === true,
      savedRevision: typeof json.saved === 'number' ? json.saved : -1,
    };
  } catch {
    return undefined;
  }
}
