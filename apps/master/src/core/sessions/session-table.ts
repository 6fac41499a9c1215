import type { Session } from './session.ts';
import type { SessionModule } from './session-module.ts';

/** All sessions, also by the ids of their modules. */
export class SessionTable {
  /** This master in a cluster; undefined for one that is alone. */
  readonly masterId: string | undefined;
  readonly #sessions = new Map<string, Session>();
  readonly #byModule = new Map<string, Session>();

  constructor(masterId: string | undefined) {
    this.masterId = masterId;
  }

  get size(): number {
    return this.#sessions.size;
  }

  /** Encoded bytes of all sessions. */
  get byteLength(): number {
    let sum = 0;
    for (const { byteLength } of this.#sessions.values()) sum += byteLength;
    return sum;
  }

  values(): Iterable<Session> {
    return this.#sessions.values();
  }

  get(id: string): Session | undefined {
    return this.#sessions.get(id);
  }

  findModule(id: string): { session: Session; module: SessionModule } | undefined {
    const session = this.#byModule.get(id);
    const module = session?.module(id);
    return session === undefined || module === undefined ? undefined : { session, module };
  }

  add(session: Session): void {
    this.#sessions.set(session.id, session);
    this.reindex(session);
  }

  delete(session: Session): void {
    this.#sessions.delete(session.id);
    this.#unindex(session);
  }

  /** Its modules changed. */
  reindex(session: Session): void {
    this.#unindex(session);
    for (const { id } of session.modules) this.#byModule.set(id, session);
  }

  /** Number of modules that a node runs, or was asked to run. */
  loadOf(nodeId: string): number {
    let load = 0;
    for (const { modules } of this.#sessions.values()) {
      for (const module of modules) if (module.nodeId === nodeId && module.isPlaced) load++;
    }
    return load;
  }

  /** Reported memory of modules on a node, bytes. */
  memoryOn(nodeId: string): number {
    let bytes = 0;
    for (const session of this.#sessions.values()) bytes += session.memoryOn(nodeId);
    return bytes;
  }

  #unindex(session: Session): void {
    for (const [id, other] of this.#byModule) if (other === session) this.#byModule.delete(id);
  }
}
