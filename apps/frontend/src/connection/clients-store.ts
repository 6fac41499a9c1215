import { ConnectionError, type UbiiClient } from '@ubii/client-web';
import { ClientState, ServiceError, type Client } from '@ubii/proto';
import { useTimeoutFn } from '@vueuse/core';
import { computed, shallowRef, watch, type Ref, type ShallowRef } from 'vue';
import { displayNames } from './display-names.ts';
import { createInterest } from './interest.ts';
import { perFrame } from './per-frame.ts';
import { usePoll } from './poll.ts';

const ANNOUNCEMENTS = '/ubii/client/*';
/** What was left out of announcements is asked for this long after the first one, for all of them. [EX-74] */
const SETTLE_MS = 2_000;

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
  let present = new Set<string>();
  /** Announced while a list was on its way: newer than the list. */
  const announced = new Set<string>();
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

  /** Answers may overtake each other; that of the last question counts. */
  let questions = 0;
  async function refresh(): Promise<void> {
    const question = ++questions;
    announced.clear();
    try {
      const { elements } = await client.call('clientGetList');
      if (question !== questions) return;
      const kept = [...announced].filter((id) => present.has(id));
      present = new Set([...elements.map(({ id }) => id), ...kept]);
      for (const element of elements) {
        if (!announced.has(element.id)) known.set(element.id, element);
      }
      draw();
    } catch (cause) {
      // Both show elsewhere, and the next refresh makes up for it.
      if (!(cause instanceof ConnectionError || cause instanceof ServiceError)) throw cause;
    }
  }

  /** Revision of the registration that was asked for last, of clients that are announced abridged. */
  const revisions = new Map<string, number>();
  const { start: startTimer, isPending } = useTimeoutFn(() => void refresh(), SETTLE_MS, {
    immediate: false,
  });

  /** The client as it is known with what is new of it. */
  function completed(value: Client): Client {
    const { extension, id, name, state, latency } = value;
    if (extension?.abridged !== true) return value;
    if (revisions.get(id) !== extension.registrationRevision) {
      revisions.set(id, extension.registrationRevision);
      if (!isPending.value) startTimer();
    }
    const before = known.get(id);
    return before === undefined ? value : { ...before, name, state, latency };
  }

  client.subscribe({ glob: ANNOUNCEMENTS }, { format: 'client' }).onRecord(({ value }) => {
    if (value.state === ClientState.UNAVAILABLE) {
      // Lost or removed: both are announced alike, the list tells. Until then nothing is shown of it.
      if (!known.has(value.id)) known.set(value.id, value);
      return void refresh();
    }
    known.set(value.id, completed(value));
    present.add(value.id);
    announced.add(value.id);
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
