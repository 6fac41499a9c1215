import { ConnectionError, type UbiiClient } from '@ubii/client-web';
import { ServiceError, type Session } from '@ubii/proto';
import { useTimeoutFn } from '@vueuse/core';
import { shallowRef, watch, type Ref, type ShallowRef } from 'vue';
import { KnownSessions, type SessionQuestion } from './known-sessions.ts';
import { perFrame } from './per-frame.ts';

const ANNOUNCEMENTS = '/info/session/*';
/** Delay after the first doubtful announcement before all open questions are requested, milliseconds. */
const SETTLE_MS = 100;
/** Delay before a question is requested again when no reply came, milliseconds. */
const RETRY_MS = 1000;

/** All sessions of the master, from its announcements. [SE-8] */
export interface SessionsStore {
  /** In the order of the master's list; `undefined` until the first list arrives. */
  readonly list: Readonly<ShallowRef<readonly Session[] | undefined>>;
  /** Error of the list, when the master refused it: an original master may have no sessions. */
  readonly error: Readonly<ShallowRef<ServiceError | undefined>>;
  find(id: string): Session | undefined;
  /** Applies the reply of a service at once, before its announcement arrives. */
  take(session: Session): void;
  /** Removes a session that a service has removed. */
  drop(id: string): void;
}

export function createSessionsStore(client: UbiiClient, isConnected: Ref<boolean>): SessionsStore {
  const list = shallowRef<readonly Session[]>();
  const error = shallowRef<ServiceError>();
  const sessions = new KnownSessions();
  const draw = perFrame(() => (list.value = sessions.list));

  async function askForList(): Promise<void> {
    const turn = sessions.now();
    const { elements } = await client.call('sessionRuntimeGetList');
    sessions.answerList(elements, turn);
    error.value = undefined;
    askSoon(); // Announcements received before the list.
  }
  async function askForOne(id: string): Promise<void> {
    const turn = sessions.now();
    const session = await client.call('sessionRuntimeGet', { id }).catch((cause: unknown) => {
      if (cause instanceof ServiceError && cause.code === 'not_found') return undefined;
      throw cause;
    });
    sessions.answerOne(id, session, turn);
  }
  async function ask(question: SessionQuestion): Promise<void> {
    try {
      if (question === 'list') await askForList();
      else await Promise.all(question.map(askForOne));
      draw();
    } catch (cause) {
      // Shown elsewhere. The connection may stay open without this reply; after reconnecting the list is requested.
      if (cause instanceof ConnectionError)
        return isConnected.value ? askLater(question) : undefined;
      if (!(cause instanceof ServiceError)) throw cause;
      if (question !== 'list') return ask('list');
      error.value = cause;
    }
  }
  const { start, isPending } = useTimeoutFn(
    () => {
      const question = sessions.takeQuestion();
      if (question !== undefined) void ask(question);
    },
    SETTLE_MS,
    { immediate: false },
  );
  const { start: waitForRetry } = useTimeoutFn(askSoon, RETRY_MS, { immediate: false });
  function askSoon(): void {
    if (!isPending.value) start();
  }
  function askLater(question: SessionQuestion): void {
    sessions.putBack(question);
    waitForRetry();
  }

  client.subscribe({ glob: ANNOUNCEMENTS }, { format: 'session' }).onRecord(({ topic, value }) => {
    sessions.announce(topic, value);
    draw();
    askSoon();
  });
  watch(
    isConnected,
    (connected) => {
      if (connected) void ask('list');
      else sessions.handleDisconnected();
    },
    { immediate: true },
  );

  function set(id: string, session: Session | undefined): void {
    sessions.set(id, session);
    draw();
  }
  return {
    list,
    error,
    find: (id) => sessions.find(id),
    take(session) {
      sessions.takeReply(session);
      draw();
      askSoon();
    },
    drop: (id) => set(id, undefined),
  };
}
