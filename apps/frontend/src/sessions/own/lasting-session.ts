import { SessionState, type Init, type Session } from '@ubii/proto';
import { computed, type ComputedRef, type ShallowRef } from 'vue';
import { refusalSentence, useAttempt } from '../../connection/useAttempt.ts';
import { useConnection } from '../../connection/useConnection.ts';
import type { SessionCalls } from '../actions/session-calls.ts';
import { isAlive, sessionState } from '../state/session-state.ts';

/** A session that continues after the page is left. All clients have the same one. */
interface Lasting {
  /** True for this session. */
  readonly isOwn: (session: Session) => boolean;
  /** Creates the session if there is none. */
  readonly spec: () => Init<Session> | Promise<Init<Session>>;
  /** Changes an existing session for this page before it is used. Default: it is used as it is. */
  readonly prepare?: (session: Session) => Promise<Session>;
}

/** In the memory of the master. */
export interface SharedLife extends Lasting {
  readonly life: 'shared';
}

/** On the disk of the master, under a free name. */
export interface StoredLife extends Lasting {
  readonly life: 'stored';
  /** Of `useSessionActions()`, which pages without stored sessions do not load. */
  readonly calls: SessionCalls;
}

export type LastingLife = SharedLife | StoredLife;

export interface LastingSession {
  readonly session: ComputedRef<Session | undefined>;
  /** True while its modules run. */
  readonly isRunning: ComputedRef<boolean>;
  /** True while a service request is pending. */
  readonly isBusy: ComputedRef<boolean>;
  /** Error of the last action, one sentence. */
  readonly trouble: Readonly<ShallowRef<string | undefined>>;
  /** Creates the session if there is none; a shared one starts then. @returns undefined like `start` */
  create(): Promise<Session | undefined>;
  /**
   * @param onReady called with the session before a stored one starts
   * @returns the session; undefined when that failed, or while another request is pending
   */
  start(onReady?: (session: Session) => void): Promise<Session | undefined>;
  stop(): Promise<void>;
}

/** True from its start on, also while its modules are not made yet. */
export const isLiving = (session: Session): boolean =>
  isAlive(session) || sessionState(session) === SessionState.SESSION_STARTING;

/** How a session is found, created, started and stopped at the master. */
interface SessionRequests {
  find(): Promise<Session | undefined>;
  /** Whether the master starts a session that it creates. */
  readonly isStartedAtOnce: boolean;
  create(): Promise<Session>;
  start(session: Session): Promise<Session>;
  stop(session: Session): Promise<void>;
}

/** Observes, starts and stops a session that outlives the page. */
export function followLastingSession(options: LastingLife): LastingSession {
  const { isOwn, prepare = async (session) => session } = options;
  const { sessions } = useConnection();
  const {
    problem: trouble,
    isBusy,
    attempt,
  } = useAttempt({ sentenceOf: refusalSentence, catchesAll: true });

  /** Prefers an active session, then the smallest id, so that all clients choose the same session. */
  function choose(list: readonly Session[]): Session | undefined {
    return list
      .filter(isOwn)
      .sort((a, b) => Number(isLiving(b)) - Number(isLiving(a)) || (a.id < b.id ? -1 : 1))[0];
  }
  const requests =
    options.life === 'shared'
      ? useSharedRequests(options, choose)
      : useStoredRequests(options, choose);

  async function change<T>(work: () => Promise<T>): Promise<T | undefined> {
    return isBusy.value ? undefined : attempt(work);
  }
  async function ready(): Promise<{ readonly session: Session; readonly isStarted: boolean }> {
    const found = await requests.find();
    if (found) return { session: await prepare(found), isStarted: isLiving(found) };
    return { session: await requests.create(), isStarted: requests.isStartedAtOnce };
  }
  const session = computed(() => choose(sessions.list.value ?? []));

  return {
    session,
    isRunning: computed(() => session.value !== undefined && isAlive(session.value)),
    isBusy,
    trouble,
    create: () => change(async () => (await ready()).session),
    start: (onReady = () => undefined) =>
      change(async () => {
        const { session: found, isStarted } = await ready();
        onReady(found);
        return isStarted ? found : requests.start(found);
      }),
    stop: () =>
      change(async () => {
        const found = await requests.find();
        if (found) await requests.stop(found);
      }).then(() => undefined),
  };
}

type Choose = (list: readonly Session[]) => Session | undefined;

function useSharedRequests({ spec }: SharedLife, choose: Choose): SessionRequests {
  const { client, sessions } = useConnection();
  async function find(): Promise<Session | undefined> {
    const found = choose((await client.call('sessionRuntimeGetList')).elements);
    if (found) sessions.take(found);
    return found;
  }
  async function start(wanted: Init<Session>): Promise<Session> {
    const mine = await client.call('sessionRuntimeStart', wanted);
    // Two clients may have started it at the same time. Both keep the same session.
    const first = await find();
    if (first && first.id !== mine.id && isLiving(first)) {
      await client.call('sessionRuntimeRemove', { id: mine.id });
      sessions.drop(mine.id);
      return first;
    }
    sessions.take(mine);
    return mine;
  }
  return {
    isStartedAtOnce: true,
    find,
    async create() {
      const session = await spec();
      // No page would start it again after a restart of the master. [SE-24]
      return start({ ...session, extension: { startWithMaster: true, ...session.extension } });
    },
    start: ({ id }) => start({ id }),
    stop: async ({ id }) => void (await client.call('sessionRuntimeStop', { id })),
  };
}

function useStoredRequests({ spec, calls }: StoredLife, choose: Choose): SessionRequests {
  const { sessions } = useConnection();
  return {
    isStartedAtOnce: false,
    find: async () => choose(sessions.list.value ?? []),
    create: async () => calls.create(await spec()),
    async start(session) {
      await calls.act(session, 'start');
      return session;
    },
    stop: (session) => calls.act(session, 'stop'),
  };
}
