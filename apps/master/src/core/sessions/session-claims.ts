import { ServiceError } from '@ubii/proto';
import type { Log } from '../ports/log.ts';
import type { OwnerStore } from '../ports/owner-store.ts';

/** Dependencies of claims. */
export interface ClaimsContext {
  readonly masterId: string;
  /** Undefined: there are no other masters. */
  readonly owners: OwnerStore | undefined;
  readonly log: Log;
}

/** Sessions of this master, as agreed in the cluster; without a cluster, all. [CU-31] */
export class SessionClaims {
  readonly #context: ClaimsContext;
  /** Removed sessions that are still owned in the cluster. */
  readonly #releasing = new Set<string>();

  constructor(context: ClaimsContext) {
    this.#context = context;
  }

  /** Open sessions are known to other masters. */
  get isShared(): boolean {
    return this.#context.owners !== undefined;
  }

  /**
   * Claims a session before it is opened.
   *
   * @throws ServiceError when another master was faster
   */
  async claim(sessionId: string): Promise<void> {
    const { masterId, owners, log } = this.#context;
    if (owners === undefined || owners.owners().get(sessionId) === masterId) return;
    let isClaimed: boolean;
    try {
      isClaimed = await owners.claim(sessionId, masterId, undefined);
    } catch (error) {
      // Each side of a divided cluster continues. [CU-34]
      log.warn('a session could not be claimed', { session: sessionId, reason: String(error) });
      return;
    }
    if (isClaimed || owners.owners().get(sessionId) === masterId) return;
    throw new ServiceError(
      'unavailable',
      'Another master is opening this session. Send the request again.',
    );
  }

  /** The session is removed. */
  release(sessionId: string): void {
    const { masterId, owners, log } = this.#context;
    if (owners === undefined) return;
    this.#releasing.add(sessionId);
    owners.release(sessionId, masterId).then(
      () => this.#releasing.delete(sessionId),
      (error: unknown) => {
        log.warn('a session could not be given up', { session: sessionId, reason: String(error) });
      },
    );
  }

  /** The session is removed here, and this master is still its owner in the cluster. */
  isReleasing(sessionId: string): boolean {
    return this.#releasing.has(sessionId);
  }

  /** Claims sessions that could not be claimed, and gives up those that could not be given up. [CU-34] */
  retry(sessionIds: Iterable<string>): void {
    const { masterId, owners, log } = this.#context;
    if (owners === undefined) return;
    for (const id of this.#releasing) this.release(id);
    for (const id of sessionIds) {
      if (owners.owners().has(id)) continue;
      owners.claim(id, masterId, undefined).catch((error: unknown) => {
        log.warn('a session could not be claimed', { session: id, reason: String(error) });
      });
    }
  }
}
