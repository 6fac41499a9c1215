import { ServiceError } from '@ubii/proto';
import type { Caller } from '../access/caller.ts';
import type { LimitName, Limits } from '../limits/index.ts';
import type { LimitWatch } from '../counters/limit-watch.ts';

/** Part of `bodyBytes` that this machine may have, and that all others together may have. */
const SIDE_SHARE = 0.75;

/** Seconds after which a refused request may be tried again. */
const RETRY_AFTER_S = 1;

/** One account that bytes in flight are charged to. */
interface Account {
  readonly key: string;
  readonly limit: LimitName;
  readonly maxBytes: number;
  /** One request that is alone in it always fits: it has limits of its own. */
  readonly fitsOne: boolean;
  /** Owner of the bytes, for people. */
  readonly whose: string;
}

/**
 * Bytes of service requests in flight, from the moment they are declared until they are decoded and
 * answered [SV-46]. Each is charged to its caller, its kind of caller, its side and all.
 */
export class BodyAccounts {
  readonly #limits: Limits;
  readonly #limitWatch: LimitWatch;
  readonly #used = new Map<string, number>();
  #connections = 0;
  readonly #connectionKeys = new WeakMap<object, string>();

  constructor(limits: Limits, limitWatch: LimitWatch) {
    this.#limits = limits;
    this.#limitWatch = limitWatch;
  }

  get totalBytes(): number {
    return this.#used.get('all') ?? 0;
  }

  /** Bytes of all callers of a kind. */
  bytesOf(limit: 'bodyBytesOfStrangers' | 'bodyBytesOfJoining'): number {
    return this.#used.get(limit) ?? 0;
  }

  /** Bytes in the account that has most, of those with this limit. */
  mostOf(limit: LimitName): number {
    let most = 0;
    for (const [key, bytes] of this.#used) {
      if (key.startsWith(`${limit} `)) most = Math.max(most, bytes);
    }
    return most;
  }

  /**
   * Opens what one request is charged to.
   *
   * @param place where the caller is, as wrong codes are counted
   * @param connection the same object for all requests of a connection
   */
  open(caller: Caller, place: string, connection: object): BodyCharge {
    const limits = this.#limits;
    const account = (
      limit: LimitName,
      key: string,
      whose: string,
      fitsOne = false,
      maxBytes = limits[limit],
    ): Account => ({ key, limit, maxBytes, fitsOne, whose });
    const isLocal = caller.kind === 'local';
    const accounts = [
      account('bodyBytes', 'all', 'all callers'),
      account(
        'bodyBytes',
        isLocal ? 'local' : 'remote',
        isLocal ? 'this machine' : 'other machines',
        false,
        Math.floor(limits.bodyBytes * SIDE_SHARE),
      ),
      account(
        'bodyBytesPerConnection',
        `bodyBytesPerConnection ${this.#connectionKey(connection)}`,
        'this connection',
        true,
      ),
    ];
    if (caller.kind === 'stranger' || caller.kind === 'joining') {
      const kind = caller.kind === 'stranger' ? 'bodyBytesOfStrangers' : 'bodyBytesOfJoining';
      accounts.push(
        account(kind, kind, 'callers that have not joined'),
        account('bodyBytesPerAddress', `bodyBytesPerAddress ${place}`, 'this address', true),
      );
    } else if (caller.kind !== 'local') {
      const id = caller.kind === 'client' ? caller.clientId : place;
      const key = `bodyBytesPerClient ${caller.kind} ${id}`;
      accounts.push(account('bodyBytesPerClient', key, 'this client', true));
    }
    return new BodyCharge(
      accounts.at(-1)!.key,
      (from, to) => this.#charge(accounts, from, to),
      (limit, message) => {
        this.#limitWatch.count(limit, caller.kind === 'client' ? caller.clientId : undefined);
        return new ServiceError('resource_exhausted', message, {
          details: { limit, max: limits[limit], retryAfterS: RETRY_AFTER_S },
        });
      },
    );
  }

  /** Changes the bytes of one request. @returns the account that has no room */
  #charge(accounts: readonly Account[], from: number, to: number): Account | undefined {
    if (to > from) {
      for (const one of accounts) {
        const { key, maxBytes, fitsOne } = one;
        const others = (this.#used.get(key) ?? 0) - from;
        if (others + to > maxBytes && !(fitsOne && others === 0)) return one;
      }
    }
    for (const { key } of accounts) {
      const bytes = (this.#used.get(key) ?? 0) + to - from;
      if (bytes === 0) this.#used.delete(key);
      else this.#used.set(key, bytes);
    }
    return undefined;
  }

  #connectionKey(connection: object): string {
    let key = this.#connectionKeys.get(connection);
    if (key === undefined) {
      key = String(++this.#connections);
      this.#connectionKeys.set(connection, key);
    }
    return key;
  }
}

/** Charge of one request. */
export class BodyCharge {
  readonly account: string;
  readonly #charge: (from: number, to: number) => Account | undefined;
  readonly #refuse: (limit: LimitName, message: string) => ServiceError;
  #bytes = 0;

  /**
   * @param account key of the caller's own account; of this machine's callers that of the connection
   */
  constructor(
    account: string,
    charge: (from: number, to: number) => Account | undefined,
    refuse: (limit: LimitName, message: string) => ServiceError,
  ) {
    this.account = account;
    this.#charge = charge;
    this.#refuse = refuse;
  }

  /** @throws ServiceError when there is no room for so many bytes */
  reserve(bytes: number): void {
    if (bytes <= this.#bytes) return;
    const full = this.#charge(this.#bytes, bytes);
    if (full !== undefined) {
      const { limit, maxBytes, whose } = full;
      throw this.#refuse(
        limit,
        `Requests of ${whose} that are not answered yet would have more than ${maxBytes} bytes (limit ${limit}). Wait for their replies, then send this request again.`,
      );
    }
    this.#bytes = bytes;
  }

  /** Gives everything back. May be called more than once. */
  release(): void {
    this.#charge(this.#bytes, 0);
    this.#bytes = 0;
  }
}
