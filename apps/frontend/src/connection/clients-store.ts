import type { UbiiClient } from '@ubii/client-web';
import { ClientState, type Client, type Mark } from '@ubii/proto';
import { useTimeoutFn } from '@vueuse/core';
import { computed, shallowRef, watch, type Ref, type ShallowRef } from 'vue';
import { displayNames } from './display-names.ts';
import { createInterest } from './interest.ts';
import { perFrame } from './per-frame.ts';
import { usePoll } from './poll.ts';
import { Recency } from './recency.ts';
import { tryRequest } from './useAttempt.ts';

const ANNOUNCEMENTS = '/ubii/client/*';
/** Delay after the first abridged announcement before the missing parts of all are requested, milliseconds. [EX-74] */
const SETTLE_MS = 2_000;
/** Most clients requested by id; above, the list is requested. */
const MAX_SINGLE = 20;

/** All clients of the master, from its announcements. [CL-31] Their names are display names: unique and not empty. */
export interface ClientsStore {
  /** In the order in which this page learned of them; `undefined` until the first list arrives. */
  readonly list: Readonly<ShallowRef<readonly Client[] | undefined>>;
  /** By id; includes disconnected clients, so that their topics keep a name. */
  find(id: string): Client | undefined;
  /** Name that a client gave itself, as stored on the master. */
  ownName(id: string): string | undefined;
  /** Keeps round trips (which are not announced) up to date while the calling component is mounted. */
  keepFresh(intervalMs: number): void;
}

export function createClientsStore(client: UbiiClient, isConnected: Ref<boolean>): ClientsStore {
  const list = shallowRef<readonly Client[]>();
  /** All clients since the page was opened; bounded by the master's limit on clients. */
  const known = new Map<string, Client>();
  const present = new Set<string>();
  const recency = new Recency();
  const interest = createInterest();

  /** Display names by id. */
  let names: ReadonlyMap<string, string> = new Map();
  /** Cache of clients with display names: the same object for the same client and name. */
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
  /** @param ids of the clients to request; default: all */
  async function refresh(ids?: readonly string[]): Promise<void> {
    const turn = recency.now();
    // Failures are shown elsewhere, and the next refresh replaces this one.
    const reply = await tryRequest(() =>
      ids === undefined
        ? client.call('clientGetList')
        : client.call('clientGetList', { elements: ids.map((id) => ({ id })) }),
    );
    if (reply) take(reply.elements, ids ?? [...present], turn);
  }

  /** Last requested revision of clients with abridged announcements. */
  const revisions = new Map<string, number>();
  /** Ids of clients whose announcement was abridged. */
  const unsure = new Set<string>();
  function refreshUnsure(): void {
    const ids = [...unsure];
    unsure.clear();
    if (ids.length > 0) void refresh(ids.length > MAX_SINGLE ? undefined : ids);
  }
  const later = useTimeoutFn(refreshUnsure, SETTLE_MS, { immediate: false });
  const atOnce = useTimeoutFn(refreshUnsure, 0, { immediate: false });

  /** Completes an abridged announcement with the known data of the client. */
  function completed(value: Client): Client {
    const { extension, id, name, state, latency } = value;
    if (extension?.abridged !== true) return value;
    if (revisions.get(id) !== extension.registrationRevision) {
      revisions.set(id, extension.registrationRevision);
      unsure.add(id);
      if (!later.isPending.value) later.start();
    }
    const before = known.get(id);
    if (before === undefined) return value;
    const after = { ...before, name, state, latency };
    const { masterId, mark } = extension;
    if (masterId === (before.extension?.masterId ?? '') && isSameMark(mark, before.extension?.mark))
      return after;
    const moved = { ...(before.extension ?? extension), abridged: false, masterId, mark };
    return { ...after, extension: moved };
  }

  client.subscribe({ glob: ANNOUNCEMENTS }, { format: 'client' }).onRecord(({ value }) => {
    if (value.state === ClientState.UNAVAILABLE) {
      // Lost and removed clients have the same announcement; only the reply distinguishes them. Until then, the client
      // is not shown.
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

function isSameMark(a: Mark | undefined, b: Mark | undefined): boolean {
  return a?.shape === b?.shape && a?.colour === b?.colour;
}
