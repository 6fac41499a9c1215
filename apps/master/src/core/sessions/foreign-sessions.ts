import type { Session as SessionMessage } from '@ubii/proto';

interface ForeignSession {
  readonly masterId: string;
  readonly message: SessionMessage;
}

/** Sessions of other masters, as last announced. [CU-30] */
export class ForeignSessions {
  readonly #sessions = new Map<string, ForeignSession>();

  list(): SessionMessage[] {
    return [...this.#sessions.values()].map(({ message }) => message);
  }

  get(sessionId: string): SessionMessage | undefined {
    return this.#sessions.get(sessionId)?.message;
  }

  /** Ids of sessions, with the master that runs each. */
  masters(): [sessionId: string, masterId: string][] {
    return [...this.#sessions].map(([id, { masterId }]) => [id, masterId]);
  }

  /** Removes a session that this master owns now, or that has no owner. */
  forget(sessionId: string): void {
    this.#sessions.delete(sessionId);
  }

  /** Id of the master that runs this session; undefined for sessions that none does. */
  masterOf(sessionId: string): string | undefined {
    return this.#sessions.get(sessionId)?.masterId;
  }

  /** The same of a session that has this module. */
  masterOfModule(moduleId: string): string | undefined {
    for (const { masterId, message } of this.#sessions.values()) {
      if (message.processingModules.some(({ id }) => id === moduleId)) return masterId;
    }
    return undefined;
  }

  /** Masters with a session that has modules on this node. */
  mastersUsing(nodeId: string): Set<string> {
    const masters = new Set<string>();
    for (const { masterId, message } of this.#sessions.values()) {
      if (message.processingModules.some((module) => module.nodeId === nodeId)) {
        masters.add(masterId);
      }
    }
    return masters;
  }

  idsOf(masterId: string): string[] {
    return [...this.#sessions].flatMap(([id, session]) =>
      session.masterId === masterId ? [id] : [],
    );
  }

  set(masterId: string, message: SessionMessage): void {
    this.#sessions.set(message.id, { masterId, message });
  }

  /** Removes a session of a master, unless another master runs it meanwhile. */
  delete(masterId: string, id: string): void {
    if (this.masterOf(id) === masterId) this.#sessions.delete(id);
  }
}
