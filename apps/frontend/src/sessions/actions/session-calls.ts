import type { UbiiClient } from '@ubii/client-web';
import { ServiceError, type Init, type ProcessingModule, type Session } from '@ubii/proto';
import type { SessionsStore } from '../../connection/sessions-store.ts';
import { copyName, freeName, sessionCopy, sessionSpec } from '../text/session-spec.ts';
import { isAlive, type LifeAction } from '../state/session-state.ts';

/** What is needed to bring a removed session back. */
export interface RemovedSession {
  readonly id: string;
  readonly spec: Init<Session>;
  readonly wasAlive: boolean;
  readonly wasStored: boolean;
}

/** What people do with sessions, as calls of the master. Every promise rejects with what the call rejects with. */
export interface SessionCalls {
  act(session: Session, action: LifeAction): Promise<void>;
  /** Names of all sessions, open or stored. */
  takenNames(): Promise<ReadonlySet<string>>;
  /**
   * Creates a session under a free name and stores it, under the given id if it has one. When the
   * specification does not say otherwise, it runs again after a restart of the master. [SE-1, SE-21, SE-24]
   */
  create(spec: Init<Session>): Promise<Session>;
  /** Stores a session under the id and the name it has. [SE-21] */
  store(spec: Init<Session>): Promise<Session>;
  /** Opens a stored session by its id, without starting it. [SE-27] */
  open(id: string): Promise<Session>;
  /** Replaces the specification, on the disk too when it is stored. [SE-15, SE-21] */
  update(session: Session, changes: Init<Session>): Promise<Session>;
  duplicate(session: Session): Promise<Session>;
  rename(session: Session, name: string): Promise<Session>;
  /** Stops it if need be, and deletes it, on the disk too. [SE-16] */
  remove(session: Session): Promise<RemovedSession>;
  restore(removed: RemovedSession): Promise<Session>;
}

/** Where the master had a choice, it keeps it: the place it chose is not people's wish. [SE-30] */
function asWished(module: Init<ProcessingModule>): Init<ProcessingModule> {
  return module.extension?.replaceable === true ? { ...module, nodeId: '' } : module;
}

/** What is gone already need not be removed. */
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
 * @param uuid gives a new UUID
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

  /** Sessions are stored by name, and the newer replaces the older: a taken name gets a number. */
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
    // A stored one is changed on the disk, too
    if (session.extension?.stored === true) return keep(next);
    return taken(client.call('sessionRuntimeUpdate', next));
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
      // The file goes first: pages that show the session would open it again.
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
    remove,
    restore,
    open: (id) => taken(client.call('sessionRuntimeAdd', { id })),
    async duplicate(session) {
      const name = copyName(session.name, await takenNames());
      return create({ ...sessionCopy(sessionSpec(session), uuid), name });
    },
    async rename(session, name) {
      const renamed = await update(session, { name });
      if (session.extension?.stored !== true) return renamed;
      // Its file goes by the name: the old one would come back as another session
      await unlessGone(client.call('sessionDatabaseDelete', { name: session.name }));
      return renamed;
    },
  };
}
