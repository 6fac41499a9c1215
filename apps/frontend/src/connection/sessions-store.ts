import { ConnectionError, type UbiiClient } from '@ubii/client-web';
import { INFO_TOPICS, ServiceError, type Session } from '@ubii/proto';
import { useTimeoutFn } from '@vueuse/core';
import { shallowRef, watch, type Ref, type ShallowRef } from 'vue';
import { perFrame } from './per-frame.ts';

const ANNOUNCEMENTS = '/info/session/*';
/** After an announcement the list is asked for again: what was retained of long ago may have come, too. */
const SETTLE_MS = 300;

/** Every session the master knows, as it announces them. [SE-8] */
export interface SessionsStore {
  /** In the order in which the master lists them; `undefined` until the first list. */
  readonly list: Readonly<ShallowRef<readonly Session[] | undefined>>;
  /** Why there is no list, when the master refused it: an original master may know no sessions. */
  readonly error: Readonly<ShallowRef<ServiceError | undefined>>;
  find(id: string): Session | undefined;
  /** Applies the reply of a service at once, before its announcement arrives. */
  take(session: Session): void;
  /** Takes one out that a service has removed. */
  drop(id: string): void;
}

const revisionOf = (session: Session | undefined): number => session?.extension?.revision ?? 0;

export function createSessionsStore(client: UbiiClient, isConnected: Ref<boolean>): SessionsStore {
  const list = shallowRef<readonly Session[]>();
  const error = shallowRef<ServiceError>();
  const known = new Map<string, Session>();
  /** Heard of while a list was on its way. `undefined` for one that is gone. */
  const heard = new Map<string, Session | undefined>();
  let hasList = false;

  const draw = perFrame(() => {
    if (hasList) list.value = [...known.values()];
  });

  function apply(id: string, session: Session | undefined): void {
    if (session === undefined) known.delete(id);
    else known.set(id, session);
  }
  /** Retained announcements can be older than the list, which would make its sessions look changed twice. */
  const isOld = (id: string, session: Session | undefined): boolean =>
    session !== undefined && revisionOf(session) < revisionOf(known.get(id));

  async function refresh(): Promise<void> {
    heard.clear();
    try {
      const { elements } = await client.call('sessionRuntimeGetList');
      known.clear();
      for (const element of elements) known.set(element.id, element);
      for (const [id, session] of heard) if (!isOld(id, session)) apply(id, session);
      error.value = undefined;
      hasList = true;
      draw();
    } catch (cause) {
      if (cause instanceof ConnectionError) return; // shown elsewhere, and asked again after it
      if (!(cause instanceof ServiceError)) throw cause;
      error.value = cause;
    }
  }
  const { start: refreshSoon } = useTimeoutFn(() => void refresh(), SETTLE_MS, {
    immediate: false,
  });

  function hear(id: string, session: Session | undefined): void {
    if (id === '') return;
    heard.set(id, session);
    apply(id, session);
    draw();
  }

  client.subscribe({ glob: ANNOUNCEMENTS }, { format: 'session' }).onRecord(({ topic, value }) => {
    const session = topic === INFO_TOPICS.deleteSession ? undefined : value;
    if (!isOld(value.id, session)) hear(value.id, session);
    refreshSoon();
  });
  watch(isConnected, (connected) => connected && void refresh(), { immediate: true });

  return {
    list,
    error,
    find: (id) => known.get(id),
    take: (session) => hear(session.id, session),
    drop: (id) => hear(id, undefined),
  };
}
