import type { UbiiClient } from '@ubii/client-web';
import { ServiceError, type Init, type ProcessingModule, type Session } from '@ubii/proto';
import type { SessionsStore } from '../../connection/sessions-store.ts';
import { copyName, freeName, sessionCopy, sessionSpec } from '../text/session-spec.ts';
import { isAlive, type LifeAction } from '../state/session-state.ts';

/** Data for restoring a removed session. */
export interface RemovedSession {
  readonly id: string;
  readonly spec: Init<Session>;
  readonly wasAlive: boolean;
  readonly wasStored: boolean;
}

/** Operations on sessions as service requests. Every promise rejects with the error of the request. */
export interface SessionCalls {
  act(session: Session, action: LifeAction): Promise<void>;
  /** Names of all sessions, open or stored. */
  takenNames(): Promise<ReadonlySet<string>>;
  /**
   * Creates a session under a free name and stores it, under the given id if it has one. By default, it runs again
   * after a restart of the master. [SE-1, SE-21, SE-24]
   */
  create(spec: Init<Session>): Promise<Session>;
  /** Stores a session under its own id and name. [SE-21] */
  store(spec: Init<Session>): Promise<Session>;
  /** Opens a stored session by its id, without starting it. [SE-27] */
  open(id: string): Promise<Session>;
  /** Replaces the specification, on disk, too, if it is stored. [SE-15, SE-21] */
  update(session: Session, changes: Init<Session>): Promise<Session>;
  duplicate(session: Session): Promise<Session>;
  /** @param changes further changes of the session, saved with its name */
  rename(session: Session, name: string, changes?: Init<Session>): Promise<Session>;
  /** Stops the session if necessary, and deletes it, on disk, too. [SE-16] */
  remove(session: Session): Promise<RemovedSession>;
  restore(removed: RemovedSession): Promise<Session>;
}

/** Leaves the node to the master where the master chose it: its choice is not the user's. [SE-30] */
function asWished(module: Init<ProcessingModule>): Init<ProcessingModule> {
  return module.extension?.replaceable === true ? { ...module, nodeId: '' } : module;
}

/** Ignores the error for objects that were removed already. */
async function unlessGone(removal: Promise<unknown>): Promise<void> {
  try {
    await removal;
  } catch (cause) {
    if (!(cause instanceof ServiceError && cause.code === 'not_found')) throw cause;
  }
}

type Services = Pick<UbiiClient, 'call'>;

/**
 * @param whenStopped resolves when the session has stopped
 * @param uuid returns a new UUID
 */
export function createSessionCalls(
  client: Services,
  store: Pick<SessionsStore, 'list' | 'take' | 'drop'>,
  whenStopped: (id: string) => Promise<void>,
  uuid: () => string,
): SessionCalls {
  const taken = async (answer: Promise<Session>): Promise<Session> => {
    const session = await answer;
    store.take(session);
    return session;
  };

  async function act({ id }: Session, action: LifeAction): Promise<void> {
    switch (action) {
      case 'start':
        await taken(client.call('sessionRuntimeStart', { id }));
        return;
      case 'pause':
        await taken(client.call('sessionPause', { id }));
        return;
      case 'resume':
        await taken(client.call('sessionResume', { id }));
        return;
      case 'stop':
        await client.call('sessionRuntimeStop', { id });
        return;
      case 'restart':
        await client.call('sessionRuntimeStop', { id });
        await whenStopped(id);
        await taken(client.call('sessionRuntimeStart', { id }));
    }
  }

  const keep = async (session: Init<Session>): Promise<Session> => {
    const { elements } = await client.call('sessionDatabaseSave', session);
    const [saved] = elements;
    if (saved === undefined)
      throw new ServiceError('internal', 'The master did not store the session.');
    store.take(saved);
    return saved;
  };

  async function takenNames(): Promise<ReadonlySet<string>> {
    const { elements } = await client.call('sessionDatabaseGetList');
    return new Set([...(store.list.value ?? []), ...elements].map(({ name }) => name));
  }

  /** Sessions are stored by name, and a new one would replace another: a number makes the name unique. */
  async function create(spec: Init<Session>): Promise<Session> {
    const name = freeName(spec.name || 'Session', await takenNames());
    return keep({ ...spec, name, extension: { startWithMaster: true, ...spec.extension } });
  }

  function update(session: Session, changes: Init<Session>): Promise<Session> {
    const { id } = session;
    const modules = changes.processingModules ?? session.processingModules;
    const next = {
      ...session,
      ...changes,
      id,
      processingModules: modules.map(asWished),
      extension: { ...session.extension, ...changes.extension },
    };
    // A stored session is changed on disk, too.
    if (session.extension?.stored === true) return keep(next);
    return taken(client.call('sessionRuntimeUpdate', next));
  }

  const turns = new Map<string, Promise<unknown>>();
  /** Changes of one session take turns: each gets the session as the one before left it. */
  async function inTurn<T>(given: Session, change: (newest: Session) => Promise<T>): Promise<T> {
    const { id } = given;
    const before = turns.get(id);
    const turn = (async () => {
      await before?.catch(() => undefined);
      return change(store.list.value?.find((one) => one.id === id) ?? given);
    })();
    turns.set(id, turn);
    try {
      return await turn;
    } finally {
      if (turns.get(id) === turn) turns.delete(id);
    }
  }

  async function rename(session: Session, name: string, changes: Init<Session>): Promise<Session> {
    const renamed = await update(session, { ...changes, name });
    if (session.extension?.stored !== true) return renamed;
    // Files are named after sessions: the old one would be loaded as another session.
    await unlessGone(client.call('sessionDatabaseDelete', { name: session.name }));
    return renamed;
  }

  async function remove(session: Session): Promise<RemovedSession> {
    const { id } = session;
    const removed = {
      id,
      spec: sessionSpec(session),
      wasAlive: isAlive(session),
      wasStored: session.extension?.stored === true,
    };
    if (removed.wasStored) {
      // Delete the file first: pages that show the session would open it again.
      if (removed.wasAlive) await client.call('sessionRuntimeStop', { id });
      await client.call('sessionDatabaseDelete', { id, name: session.name });
    }
    await unlessGone(client.call('sessionRuntimeRemove', { id }));
    store.drop(id);
    return removed;
  }

  async function restore({ id, spec, wasAlive, wasStored }: RemovedSession): Promise<Session> {
    const session = wasStored
      ? await create({ ...spec, id })
      : await taken(client.call('sessionRuntimeAdd', spec));
    if (wasAlive) await act(session, 'start');
    return session;
  }

  return {
    act,
    takenNames,
    create,
    store: keep,
    update,
    remove: (session) => inTurn(session, remove),
    restore,
    open: (id) => taken(client.call('sessionRuntimeAdd', { id })),
    async duplicate(session) {
      const name = copyName(session.name, await takenNames());
      return create({ ...sessionCopy(sessionSpec(session), uuid), name });
    },
    rename: (session, name, changes = {}) =>
      inTurn(session, (newest) => rename(newest, name, changes)),
  };
}
