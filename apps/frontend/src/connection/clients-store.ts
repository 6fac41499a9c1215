import { ConnectionError, type UbiiClient } from '@ubii/client-web';
import { ClientState, ServiceError, type Client } from '@ubii/proto';
import { useTimeoutFn } from '@vueuse/core';
import { computed, shallowRef, watch, type Ref, type ShallowRef } from 'vue';
import { displayNames } from './display-names.ts';
import { createInterest } from './interest.ts';
import { perFrame } from './per-frame.ts';
import { usePoll } from './poll.ts';
import { Recency } from './recency.ts';

const ANNOUNCEMENTS = '/ubii/client/*';
/** What was left out of announcements is asked for this long after the first one, for all of them. [EX-74] */
const SETTLE_MS = 2_000;
/** More clients than these are not asked for by their ids. */
const MAX_SINGLE = 20;

/**
 * Every client the master knows, as it announces them. [CL-31] Their names are display names: no two clients have the
 * same one, and none is empty.
 */
export interface ClientsStore {
  /** In the order in which this page learned of them; `undefined` until the first list. */
  readonly list: Readonly<ShallowRef<readonly Client[] | undefined>>;
  /** By id; works for clients that are gone, so that their topics keep a name. */
  find(id: string): Client | undefined;
  /** The name that a client gave itself, as the master has it. */
  ownName(id: string): string | undefined;
  /** Keeps round trips fresh (they are not announced) while the calling component lives. */
  keepFresh(intervalMs: number): void;
}

export function createClientsStore(client: UbiiClient, isConnected: Ref<boolean>): ClientsStore {
  const list = shallowRef<readonly Client[]>();
  /** Grows by the clients of this page's life; bounded by the master's own limit on clients. */
  const known = new Map<string, Client>();
  const present = new Set<string>();
  const recency = new Recency();
  const interest = createInterest();

  /** Names that this page shows, by id. */
  let names: ReadonlyMap<string, string> = new Map();
  /** A client with its display name; the same object for the same client and name. */
  const named = new Map<string, { readonly from: Client; readonly to: Client }>();

  function show(client: Client): Client {
    const name = names.get(client.id) ?? client.name;
    const last = named.get(client.id);
    if (last?.from === client && last.to.name === name) return last.to;
    const to = client.name === name ? client : { ...client, name };
    named.set(client.id, { from: client, to });
    return to;
  }

  const draw = perFrame(() => {
    const all = [...known.values()];
    names = displayNames(
      all.map(({ id, name }) => ({ id, name, isPresent: present.has(id) })),
      names,
    );
    list.value = all.filter(({ id }) => present.has(id)).map(show);
  });

  function find(id: string): Client | undefined {
    const client = known.get(id);
    return client && show(client);
  }

  function take(elements: readonly Client[], asked: Iterable<string>, turn: number): void {
    const listed = new Set(elements.map(({ id }) => id));
    for (const id of asked) {
      if (!listed.has(id) && recency.accepts(id, turn)) present.delete(id);
    }
    for (const element of elements) {
      if (!recency.accepts(element.id, turn)) continue;
      known.set(element.id, element);
      present.add(element.id);
    }
    draw();
  }
  /** @param ids of the clients to ask for; all without them */
  async function refresh(ids?: readonly string[]): Promise<void> {
    const turn = recency.now();
    try {
      const { elements } = await (ids === undefined
        ? client.call('clientGetList')
        : client.call('clientGetList', { elements: ids.map((id) => ({ id })) }));
      take(elements, ids ?? [...present], turn);
    } catch (cause) {
      // Both show elsewhere, and the next refresh makes up for it.
      if (!(cause instanceof ConnectionError || cause instanceof ServiceError)) throw cause;
    }
  }

  /** Revision of the registration that was asked for last, of clients that are announced abridged. */
  const revisions = new Map<string, number>();
  /** Announced, but not with all there is to know. */
  const unsure = new Set<string>();
  function refreshUnsure(): void {
    const ids = [...unsure];
    unsure.clear();
    if (ids.length > 0) void refresh(ids.length > MAX_SINGLE ? undefined : ids);
  }
  const later = useTimeoutFn(refreshUnsure, SETTLE_MS, { immediate: false });
  const atOnce = useTimeoutFn(refreshUnsure, 0, { immediate: false });

  /** The client as it is known with what is new of it. */
  function completed(value: Client): Client {
    const { extension, id, name, state, latency } = value;
    if (extension?.abridged !== true) return value;
    if (revisions.get(id) !== extension.registrationRevision) {
      revisions.set(id, extension.registrationRevision);
      unsure.add(id);
      if (!later.isPending.value) later.start();
    }
    const before = known.get(id);
    return before === undefined ? value : { ...before, name, state, latency };
  }

  client.subscribe({ glob: ANNOUNCEMENTS }, { format: 'client' }).onRecord(({ value }) => {
    if (value.state === ClientState.UNAVAILABLE) {
      // Lost or removed: both are announced alike, its answer tells. Until then nothing is shown of it.
      if (!known.has(value.id)) known.set(value.id, value);
      unsure.add(value.id);
      return atOnce.start();
    }
    recency.accepts(value.id, recency.now());
    known.set(value.id, completed(value));
    present.add(value.id);
    draw();
  });

  watch(isConnected, (connected) => connected && void refresh(), { immediate: true });
  usePoll(
    refresh,
    () => interest.intervalMs.value ?? 0,
    computed(() => isConnected.value && interest.intervalMs.value !== undefined),
  );

  return {
    list,
    find,
    ownName: (id) => known.get(id)?.name,
    keepFresh: (ms) => interest.express(ms),
  };
}
