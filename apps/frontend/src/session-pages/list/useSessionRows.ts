import type { Session } from '@ubii/proto';
import { computed, toValue, type ComputedRef, type MaybeRefOrGetter } from 'vue';
import { findDraft, type Draft } from '../../graph/model/changes/draft.ts';
import { useMasters } from '../../connection/useMasters.ts';
import { useConnection } from '../../connection/useConnection.ts';
import {
  useSessionActions,
  type SessionActions,
} from '../../sessions/actions/useSessionActions.ts';
import { useSessionMenu, type SessionMenu } from '../../sessions/actions/useSessionMenu.ts';
import { useSessionStatistics } from '../../sessions/live/useSessionStatistics.ts';
import type { StoredSessions } from '../../sessions/useStoredSessions.ts';
import { sessionMaster } from '../../sessions/words/master-words.ts';
import { nodeName } from '../../sessions/words/node-words.ts';
import { sharedTopics } from '../../sessions/words/shared-topics.ts';
import {
  filterRows,
  sessionRow,
  withStored,
  type SessionFilter,
  type SessionRow,
} from '../../sessions/list/session-rows.ts';
import { useDraftIds } from './useDraftIds.ts';

/** All sessions as rows, and what can be done with them. */
export interface SessionRows {
  /** All sessions, stored ones that are not open included. */
  readonly all: ComputedRef<readonly Session[]>;
  readonly rows: ComputedRef<readonly SessionRow[]>;
  /** Work in this browser on sessions that the master does not have: never saved, or deleted since. */
  readonly unsaved: ComputedRef<readonly Draft[]>;
  discard(draft: Draft): void;
  readonly actions: SessionActions;
  readonly menu: SessionMenu;
  readonly takenNames: ComputedRef<ReadonlySet<string>>;
  /** Names of nodes, as people know them. */
  nodeNames(ids: readonly string[]): string[];
  remove(session: Session): Promise<void>;
}

const NODES_INTERVAL_MS = 3000;

/** @param stored the sessions on the master's disk, refreshed here after a change */
export function useSessionRows(
  stored: StoredSessions,
  search: MaybeRefOrGetter<string> = '',
  filter: MaybeRefOrGetter<SessionFilter> = 'all',
): SessionRows {
  const { client, sessions, nodes } = useConnection();
  nodes.watch(NODES_INTERVAL_MS);
  const statistics = useSessionStatistics();
  const masters = useMasters();
  const actions = useSessionActions();
  const drafts = useDraftIds();
  const all = computed(() => withStored(sessions.list.value ?? [], stored.list.value));
  const rows = computed(() => {
    const each = all.value.map((one) =>
      sessionRow(one, statistics.value.get(one.id), {
        shared: sharedTopics(one, all.value),
        hasDraft: drafts.ids.value.has(one.id),
        master: sessionMaster(one, masters),
      }),
    );
    return filterRows(each, toValue(search), toValue(filter));
  });
  const unsaved = computed(() => {
    if (sessions.list.value === undefined || !stored.isKnown.value) return [];
    const known = new Set(all.value.map(({ id }) => id));
    const ids = [...drafts.ids.value].filter((id) => !known.has(id));
    return ids.flatMap((id) => findDraft(localStorage, id) ?? []);
  });
  return {
    all,
    rows,
    unsaved,
    discard: ({ sessionId }) => drafts.discard(sessionId),
    actions,
    menu: useSessionMenu(actions, () => void stored.refresh()),
    takenNames: computed(() => new Set(all.value.map(({ name }) => name))),
    nodeNames(ids) {
      void nodes.list.value;
      return ids.map(
        (id) => masters.labelOfKnown(id) || nodeName(id, (other) => nodes.find(other), client.id),
      );
    },
    async remove(session) {
      await actions.remove(session);
      await stored.refresh();
    },
  };
}
