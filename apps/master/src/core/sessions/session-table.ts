import type { Session } from './session.ts';
import type { SessionModule } from './session-module.ts';

/** Every session, and which module is in which. */
export class SessionTable {
  readonly #masterId: string;
  readonly #sessions = new Map<string, Session>();
  readonly #byModule = new Map<string, Session>();

  /** @param masterId of this master in a cluster; empty for one that is alone */
  constructor(masterId = '') {
    this.#masterId = masterId;
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
    session.masterId = this.#masterId;
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

  /** Modules of sessions a node runs now, or was told to run. */
  loadOf(nodeId: string): number {
    let load = 0;
    for (const { modules } of this.#sessions.values()) {
      for (const module of modules) if (module.nodeId === nodeId && module.isPlaced) load++;
    }
    return load;
  }

  /** Memory of modules on a node, bytes, as far as it was told. */
  memoryOn(nodeId: string): number {
    let bytes = 0;
    for (const session of this.#sessions.values()) bytes += session.memoryOn(nodeId);
    return bytes;
  }

  #unindex(session: Session): void {
    for (const [id, other] of this.#byModule) if (other === session) this.#byModule.delete(id);
  }
}
