import { ClientState } from '@ubii/proto';
import { useDocumentVisibility, useEventListener, useIntervalFn } from '@vueuse/core';
import { computed, onScopeDispose, shallowRef, watch, type ComputedRef } from 'vue';
import { useTopic } from '../../../connection/live/useTopic.ts';
import { useConnection } from '../../../connection/useConnection.ts';
import { useMarks } from '../../../marks/useMarks.ts';
import type { PlayerIdentity } from '../../../players/player-identity.ts';
import { PRESENCE_GLOB, presenceTopic } from '../../../topics/names/presence-topic.ts';
import { useToastsOf } from '../../../ui/toasts/toasts.ts';
import type { GraphEditor } from '../../editing/graph-editor.ts';
import type { Saving } from '../useSave.ts';
import { PresenceBoard, type BoardChange, type Present } from './presence-board.ts';
import { presenceText, type PresenceRecord } from './presence-record.ts';

/** Another user who has this session open, with the look of their mark. */
export interface Peer extends Present {
  readonly name: string;
  /** Device and browser: `iPhone, Safari`. */
  readonly kind: string;
  readonly look: PlayerIdentity;
}

export interface Presence {
  readonly peers: ComputedRef<readonly Peer[]>;
  /** Returns the user who saved a revision; undefined when unknown. */
  savedBy(revision: number): string | undefined;
}

/** Shortest interval between records, milliseconds. [EX-49] */
const PUBLISH_MS = 200;
/** Interval of repeated records while other users are present, milliseconds. [EX-49] */
const REPEAT_MS = 15_000;
const EXPIRE_MS = 5_000;

/** Publishes that this session is open here, and receives the records of other users. [EX-49] */
export function usePresence(editor: GraphEditor, saving: Saving): Presence {
  const { client, clients, isConnected } = useConnection();
  const { markOf } = useMarks();
  const toasts = useToastsOf('presence');
  const visibility = useDocumentVisibility();
  const isSeen = computed(() => visibility.value === 'visible');
  const sessionId = editor.session.value.id;
  const board = new PresenceBoard(sessionId, () => client.id);
  const present = shallowRef<readonly Present[]>([]);
  const hasOthers = computed(() => present.value.length > 0);
  /** Names of users by the revision they saved, also after they left. */
  const savers = shallowRef<ReadonlyMap<number, string>>(new Map());
  const nameOf = (id: string): string => clients.find(id)?.name ?? 'Another client';

  function show({ arrived, left }: BoardChange, isSaid: boolean): void {
    present.value = board.list;
    if (!isSaid) return;
    for (const id of arrived) toasts.show(`${nameOf(id)} opened this session`);
    for (const id of left) toasts.show(`${nameOf(id)} left this session`);
  }

  const own = computed((): PresenceRecord => ({
    session: sessionId,
    nodes: [...editor.selection.value.nodes],
    isEditing: editor.changes.value > 0,
    isHidden: !isSeen.value,
    savedRevision: saving.savedRevision.value,
  }));
  function publish(record: PresenceRecord = own.value): void {
    if (!isConnected.value) return;
    client.publish(presenceTopic(client.id), 'string', presenceText(record));
  }
  let lastMs = -Infinity;
  let timer: ReturnType<typeof setTimeout> | undefined;
  /** Publishes now, or as soon as the rate limit allows. */
  function publishSoon(): void {
    clearTimeout(timer);
    const waitMs = Math.max(0, lastMs + PUBLISH_MS - performance.now());
    timer = setTimeout(() => {
      lastMs = performance.now();
      publish();
    }, waitMs);
  }

  watch(
    [isConnected, isSeen],
    ([connected]) => {
      if (!connected) {
        board.clear();
        present.value = [];
        return;
      }
      // Announces that the page became visible or hidden.
      publish();
    },
    { immediate: true },
  );
  let isSaid = false;
  const { status } = useTopic(() => (isConnected.value ? { glob: PRESENCE_GLOB } : undefined), {
    format: 'string',
    keep: 0,
    onRecord({ topic, value, clientId }) {
      // Ignore records that name another client
      if (clientId !== '' && !topic.startsWith(`/${clientId}/`)) return;
      const change = board.hear(topic, value, performance.now());
      for (const { clientId: id, savedRevision } of board.list) {
        if (savedRevision < 0 || savers.value.has(savedRevision)) continue;
        savers.value = new Map(savers.value).set(savedRevision, id);
      }
      show(change, isSaid);
      // Send new users the current state, with the selection.
      if (change.arrived.length > 0) publishSoon();
    },
  });
  // Users who were present before count as known.
  watch(status, (now, _before, onCleanup) => {
    isSaid = false;
    if (now !== 'live') return;
    const said = setTimeout(() => (isSaid = true), PUBLISH_MS);
    onCleanup(() => clearTimeout(said));
  });
  watch(own, () => {
    if (hasOthers.value && isSeen.value) publishSoon();
  });
  useIntervalFn(() => hasOthers.value && isSeen.value && publishSoon(), REPEAT_MS);
  useIntervalFn(() => hasOthers.value && show(board.expire(performance.now()), true), EXPIRE_MS);
  watch(clients.list, (list) => {
    const gone = new Set(present.value.map(({ clientId }) => clientId));
    for (const { id, state } of list ?? []) if (state !== ClientState.UNAVAILABLE) gone.delete(id);
    if (list !== undefined && gone.size > 0) show(board.drop(...gone), true);
  });

  const leave = (): void => {
    publish({ session: '', nodes: [], isEditing: false, isHidden: false, savedRevision: -1 });
  };
  useEventListener(window, 'pagehide', leave);
  onScopeDispose(() => {
    clearTimeout(timer);
    leave();
  });

  return {
    peers: computed(() => {
      void clients.list.value;
      return present.value.map((one) => ({
        ...one,
        name: nameOf(one.clientId),
        kind: clients.find(one.clientId)?.description ?? '',
        look: markOf(one.clientId, nameOf(one.clientId)),
      }));
    }),
    savedBy(revision) {
      const id = savers.value.get(revision);
      return id === undefined ? undefined : nameOf(id);
    },
  };
}
