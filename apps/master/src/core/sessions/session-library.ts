import {
  isUuid,
  ServiceError,
  SessionStatus,
  toJson,
  type Session as SessionMessage,
} from '@ubii/proto';
import type { GrantId } from '../access/grant.ts';
import type { IdSource } from '../ports/id-source.ts';
import type { Log } from '../ports/log.ts';
import type { Session } from './session.ts';
import { quote } from '../texts/quote.ts';
import type { StoredMessages } from '../library/stored-messages.ts';

/** Alias of the master as a node in documents, because its own id changes with each start. [SE-30] */
export const MASTER_ALIAS = 'master';

/** Stored sessions, and those that come back with the next master. */
export class SessionLibrary {
  readonly stored: StoredMessages<'ubii.sessions.Session'>;
  readonly #running: StoredMessages<'ubii.sessions.Session'>;
  readonly #masterId: string;
  readonly #log: Log;
  readonly #ids: Pick<IdSource, 'named'>;
  /** Every open session is remembered, for other masters: which run, their status says. [CU-33] */
  readonly remembersAll: boolean;
  /** Cache of `list`, valid while the documents are unchanged. */
  #listed: { readonly documents: unknown; readonly byId: ReadonlyMap<string, SessionMessage> } = {
    documents: undefined,
    byId: new Map(),
  };
  /** The newest write of each session that is under way, by id. */
  readonly #remembering = new Map<string, Promise<void>>();
  /** Failed writes, by id. */
  readonly #unsaved = new Map<
    string,
    { readonly session: Session; readonly shouldStart: boolean }
  >();
  #isClosed = false;

  constructor(parts: {
    readonly stored: StoredMessages<'ubii.sessions.Session'>;
    readonly running: StoredMessages<'ubii.sessions.Session'>;
    readonly masterId: string;
    readonly log: Log;
    readonly ids: Pick<IdSource, 'named'>;
    readonly remembersAll: boolean;
  }) {
    this.stored = parts.stored;
    this.#running = parts.running;
    this.#masterId = parts.masterId;
    this.#log = parts.log;
    this.#ids = parts.ids;
    this.remembersAll = parts.remembersAll;
  }

  list(): SessionMessage[] {
    return [...this.#byId().values()].map((message) => withRevision(message, 0));
  }

  get(name: string): SessionMessage | undefined {
    return name === '' ? undefined : this.list().find((message) => message.name === name);
  }

  /** The stored session of this id, else of this name. */
  find({ id, name }: Pick<SessionMessage, 'id' | 'name'>): SessionMessage | undefined {
    const byId = this.#byId().get(id);
    return byId === undefined ? this.get(name) : withRevision(byId, 0);
  }

  /** A stored session, by its id, as it is opened: opening counts as a change [SE-27]. */
  toOpen(id: string): SessionMessage | undefined {
    const message = this.#byId().get(id);
    return message && withRevision(message, (message.extension?.revision ?? 0) + 1);
  }

  /** Stored sessions by the ids under which they are opened [SE-27]. */
  #byId(): ReadonlyMap<string, SessionMessage> {
    const documents = this.stored.store.documents();
    if (documents === this.#listed.documents) return this.#listed.byId;
    const byId = new Map<string, SessionMessage>();
    for (const { message } of this.stored.list().values()) {
      const isOwn = isUuid(message.id) && !byId.has(message.id);
      const id = isOwn ? message.id : this.#ids.named(message.name);
      byId.set(id, withStored({ ...message, id }));
    }
    this.#listed = { documents, byId };
    return byId;
  }

  /** The stored session of this id, else of this name. @throws ServiceError when there is none. */
  require(id: string, name: string): SessionMessage {
    const found = this.find({ id, name });
    if (found !== undefined) return found;
    if (id === '' && name === '') {
      throw new ServiceError(
        'invalid_argument',
        'The request names no session. Set its id or its name.',
      );
    }
    throw new ServiceError(
      'not_found',
      `No stored session has the id ${quote(id)} or the name ${quote(name)}; /services/session/database/get_list lists those there are.`,
    );
  }

  async save(session: Session): Promise<void> {
    const { name } = session.description;
    await this.stored.store.write(this.stored.keyOf(name), this.#toJson(session));
  }

  /** Stored sessions are no longer those of a grant [AC-92]. */
  async handOver(grantId: GrantId): Promise<void> {
    for (const { key, message } of this.stored.entries()) {
      const { extension } = message;
      if (extension?.grantIds.includes(grantId) !== true) continue;
      const grantIds = extension.grantIds.filter((id) => id !== grantId);
      const changed = { ...message, extension: { ...extension, grantIds } };
      await this.stored.store.write(key, toJson('ubii.sessions.Session', changed));
    }
  }

  async delete(name: string): Promise<void> {
    await this.stored.store.delete(this.stored.keyOf(name));
  }

  /** Sessions that ran when the master ended [SE-24]. */
  interrupted(): SessionMessage[] {
    return this.#running.entries().map(({ key, message }) => ({ ...message, id: key }));
  }

  /** The master ends: remembered sessions stay stored. */
  close(): void {
    this.#isClosed = true;
  }

  /** Stores, or removes, that a session starts with the next master [SE-24], or at another one. */
  remember(session: Session, shouldStart: boolean): void {
    if (this.#isClosed) return;
    const { store } = this.#running;
    const done = shouldStart
      ? store.write(
          session.id,
          this.#toJson(session, this.remembersAll && session.isLive && !session.isPaused),
        )
      : this.remembersAll || store.documents().has(session.id)
        ? store.delete(session.id)
        : Promise.resolve();
    this.#remembering.set(session.id, done);
    done
      .then(() => this.#unsaved.delete(session.id))
      .catch((error: unknown) => {
        this.#unsaved.set(session.id, { session, shouldStart });
        this.#log.error('the list of running sessions could not be saved', {
          session: session.label,
          reason: String(error),
        });
      })
      .finally(() => {
        if (this.#remembering.get(session.id) === done) this.#remembering.delete(session.id);
      });
  }

  /** Repeats failed writes. [CU-33] */
  rememberUnsaved(): void {
    const unsaved = [...this.#unsaved.values()];
    this.#unsaved.clear();
    for (const { session, shouldStart } of unsaved) this.remember(session, shouldStart);
  }

  /** Resolves when the last state passed to `remember` is on disk. @throws ServiceError when it could not be written */
  async remembered(sessionId: string): Promise<void> {
    try {
      await this.#remembering.get(sessionId);
    } catch (error) {
      throw new ServiceError(
        'unavailable',
        `The change applies now, but could not be saved: the next start of the master uses the previous setting. ${String(error)}`,
      );
    }
  }

  /** The specification alone, without the state. */
  #toJson(session: Session, isRunning = false): ReturnType<typeof toJson> {
    const message = session.toMessage();
    const { startWithMaster, lockstepHertz, editorJson } = session.description;
    return toJson('ubii.sessions.Session', {
      ...message,
      status: isRunning ? SessionStatus.RUNNING : SessionStatus.CREATED,
      processingModules: session.modules.map(({ spec, requestedNodeId }) => ({
        ...spec,
        nodeId: requestedNodeId === this.#masterId ? MASTER_ALIAS : (requestedNodeId ?? ''),
        sessionId: '',
        status: 0,
      })),
      extension: {
        startWithMaster,
        lockstepHertz,
        editorJson,
        revision: session.revision,
        grantIds: [...session.grantIds],
      },
    });
  }
}

function withStored(message: SessionMessage): SessionMessage {
  const extension = message.extension ?? {
    startWithMaster: false,
    lockstepHertz: 0,
    editorJson: '',
    revision: 0,
    grantIds: [],
  };
  return {
    ...message,
    status: 0,
    extension: {
      ...extension,
      state: 0,
      problems: [],
      stored: true,
      masterId: '',
      movedFrom: '',
      movedMs: 0,
    },
  };
}

function withRevision(message: SessionMessage, revision: number): SessionMessage {
  return { ...message, extension: { ...message.extension!, revision } };
}
