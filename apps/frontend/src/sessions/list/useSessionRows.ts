import type { Session } from '@ubii/proto';
import { computed, toValue, type ComputedRef, type MaybeRefOrGetter } from 'vue';
import { useRouter } from 'vue-router';
import { useConnection } from '../../connection/useConnection.ts';
import { useSessionActions, type SessionActions } from '../actions/useSessionActions.ts';
import { useSessionMenu, type SessionMenu } from '../actions/useSessionMenu.ts';
import { useSessionStatistics } from '../live/useSessionStatistics.ts';
import { sessionLocation } from '../routes.ts';
import { useStoredSessions } from '../useStoredSessions.ts';
import { nodeName } from '../words/node-words.ts';
import { sharedTopics } from '../words/shared-topics.ts';
import {
  filterRows,
  sessionRow,
  withStored,
  type SessionFilter,
  type SessionRow,
} from './session-rows.ts';
import { useDraftIds } from './useDraftIds.ts';

/** All sessions as rows, and what can be done with them. */
export interface SessionRows {
  /** Those the master has, and those that are only stored. */
  readonly all: ComputedRef<readonly Session[]>;
  readonly rows: ComputedRef<readonly SessionRow[]>;
  readonly actions: SessionActions;
  readonly menu: SessionMenu;
  readonly takenNames: ComputedRef<ReadonlySet<string>>;
  /** Names of nodes, as people know them. */
  nodeNames(ids: readonly string[]): string[];
  /** Makes one that is only stored, and goes there. */
  open(session: Session): Promise<void>;
  remove(session: Session): Promise<void>;
}

const NODES_INTERVAL_MS = 3000;

export function useSessionRows(
  search: MaybeRefOrGetter<string> = '',
  filter: MaybeRefOrGetter<SessionFilter> = 'all',
): SessionRows {
  const router = useRouter();
  const { client, sessions, nodes } = useConnection();
  nodes.watch(NODES_INTERVAL_MS);
  const statistics = useSessionStatistics();
  const stored = useStoredSessions();
  const actions = useSessionActions();
  const drafts = useDraftIds();
  const all = computed(() => withStored(sessions.list.value ?? [], stored.list.value));
  const rows = computed(() => {
    const each = all.value.map((one) =>
      sessionRow(one, statistics.value.get(one.id), {
        shared: sharedTopics(one, all.value),
        hasDraft: drafts.value.has(one.id),
      }),
    );
    return filterRows(each, toValue(search), toValue(filter));
  });
  return {
    all,
    rows,
    actions,
    menu: useSessionMenu(actions, () => void stored.refresh()),
    takenNames: computed(() => new Set(all.value.map(({ name }) => name))),
    nodeNames(ids) {
      void nodes.list.value;
      return ids.map((id) => nodeName(id, (other) => nodes.find(other), client.id));
    },
    async open(session) {
      const made = await actions.open(session);
      if (made) await router.push(sessionLocation(made.id));
    },
    async remove(session) {
      await actions.remove(session);
      await stored.refresh();
    },
  };
}
