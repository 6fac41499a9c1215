import { ServiceError } from '@ubii/proto';
import type { Clock } from '@ubii/timing';
import { Hook } from '../hooks/hook.ts';
import type { LimitName } from '../limits/index.ts';
import type { LimitWatch } from '../counters/limit-watch.ts';
import { Account } from './account.ts';
import { describeShortage, limitOf, type Shortage } from './shortage.ts';
import { RESOURCE, RESOURCE_INFO, RESOURCES, type Resource } from './resources.ts';
import { CLASS_SHARES, type ShareClass } from './share-classes.ts';

/** Time until the next search for a client that could free resources, after a search without a result, milliseconds. */
const BARREN_MS = 500;

/** Class and invitation of a client, which determine its account. */
export interface Share {
  readonly shareClass: ShareClass;
  /** Undefined for clients that came without one. */
  readonly invitation: { readonly id: string; readonly label: string } | undefined;
}

/** Dependencies of accounts. */
export interface AccountsContext {
  readonly clock: Clock;
  readonly limits: LimitWatch;
}

/** The accounts of the whole master, its classes, invitations, clients and sessions [AC-80]. */
export class Accounts {
  /** Called when there is no room: each listener frees resources until there is [TD-44] [AC-84]. */
  readonly onShortage = new Hook<[shortage: Shortage, hasRoom: () => boolean]>();
  /** Everything together. */
  readonly all: Account;
  /** Use by the master itself, without a limit. */
  readonly master: Account;
  readonly #context: AccountsContext;
  readonly #classes = new Map<ShareClass, Account>();
  /** Limits of a client, by its class and whether it has an invitation. */
  readonly #clientMaxima = new Map<string, Float64Array>();
  readonly #invitations = new Map<string, Account>();

  constructor(context: AccountsContext) {
    this.#context = context;
    this.all = new Account({
      kind: 'all',
      id: '',
      max: this.#maxOf(({ all }) => this.#limit(all)),
    });
    for (const shareClass of Object.keys(CLASS_SHARES) as ShareClass[]) {
      const { ofAll, untilFilled } = CLASS_SHARES[shareClass];
      const part = (fraction: number): Float64Array =>
        this.#maxOf(({ all }) => partOf(this.#limit(all), fraction));
      const account = new Account({
        kind: 'class',
        id: shareClass,
        parent: this.all,
        // The master can always publish its own messages, however full it is.
        // A class with a share of 1 is limited by the total only.
        max: ofAll === 1 ? unlimited() : part(ofAll),
        untilFilled: shareClass === 'master' ? unlimited() : part(untilFilled),
      });
      this.#classes.set(shareClass, account);
    }
    const parent = this.#classes.get('master')!;
    this.master = new Account({ kind: 'master', id: '', parent, max: unlimited() });
  }

  /** All of a class together. */
  ofClass(shareClass: ShareClass): Account {
    return this.#classes.get(shareClass)!;
  }

  /** Everybody who came with one invitation together, or all of a class that came without. */
  ofShare({ shareClass, invitation }: Share): Account {
    const parent = this.ofClass(shareClass);
    if (invitation === undefined) return parent;
    const known = this.#invitations.get(invitation.id);
    if (known !== undefined) return known;
    const { perInvitation } = CLASS_SHARES[shareClass];
    const max = this.#maxOf(({ all }) => partOf(this.#limit(all), perInvitation));
    const account = new Account({ ...invitation, kind: 'invitation', parent, max });
    this.#invitations.set(invitation.id, account);
    return account;
  }

  /** An account for a client that came in like this. */
  createClient(id: string, share: Share): Account {
    return new Account({
      kind: 'client',
      id,
      parent: this.ofShare(share),
      max: this.#maxOfClient(share),
    });
  }

  /** An account for a client of another master, or that master. It is bounded there, but for what it makes here. [CU-20] */
  createForeign(id: string): Account {
    const max = unlimited();
    const bounded = this.#maxOfClient({ shareClass: 'participant', invitation: undefined });
    for (const resource of [RESOURCE.topics, RESOURCE.retainedBytes, RESOURCE.queueBytes]) {
      max[resource] = bounded[resource]!;
    }
    return new Account({ kind: 'client', id, max });
  }

  /** An account for a session. @param max its limits; what is left out has none of its own */
  createSession(id: string, max: { readonly [R in Resource]?: number } = {}): Account {
    return new Account({
      kind: 'session',
      id,
      parent: this.ofClass('session'),
      max: Float64Array.from(RESOURCES, (resource) => max[resource] ?? Number.POSITIVE_INFINITY),
    });
  }

  /** The client came in another way: it counts for others now [AC-18]. */
  move(account: Account, share: Share): void {
    const before = account.parent;
    account.moveTo(this.ofShare(share), this.#maxOfClient(share));
    if (before !== undefined) this.#forgetIfIdle(before);
  }

  /** The client is at another master now, which counts what it costs. [CU-22] */
  moveOut(account: Account): void {
    const before = account.parent;
    account.moveTo(undefined, unlimited());
    if (before !== undefined) this.#forgetIfIdle(before);
  }

  /** The owner of this account is gone, and with it all it used. */
  close(account: Account): void {
    if (account.parent !== undefined) this.#forgetIfIdle(account.parent);
  }

  /**
   * Returns the shortage, if there is one, after trying to evict clients that are away. May remove clients, and their
   * resources.
   * @param from The account that pays for it now.
   */
  shortage(
    account: Account,
    resource: Resource,
    amount: number,
    from?: Account,
  ): Shortage | undefined {
    const level = account.shortage(resource, amount, from);
    if (level === undefined) return undefined;
    const shortage = { account, resource, level };
    const nowMs = this.#context.clock.monotonicMs();
    // Resources of one client cannot be freed by another client.
    if (level === account) return shortage;
    const searched = level.kind === 'invitation' ? level : classOf(account);
    if (nowMs < searched.barrenUntilMs(resource)) return shortage;
    const find = (): Account | undefined => account.shortage(resource, amount, from);
    this.onShortage.emit(shortage, () => find() !== level);
    const after = find();
    if (after === undefined) return undefined;
    searched.setBarren(resource, nowMs + BARREN_MS);
    return { ...shortage, level: after };
  }

  /** @throws ServiceError when there is no room for so much more [AC-83]. */
  require(account: Account, resource: Resource, amount: number, from?: Account): void {
    const shortage = this.shortage(account, resource, amount, from);
    if (shortage !== undefined) throw this.refusal(shortage);
  }

  /** Counts a hit of the limit behind a shortage, and gives the error for it [AC-83]. */
  refusal(shortage: Shortage): ServiceError {
    const { limits } = this.#context;
    const limit = limitOf(shortage, limits.limits);
    const { kind, id } = shortage.account;
    limits.count(limit, kind === 'client' ? id : undefined);
    return new ServiceError(
      'resource_exhausted',
      `This would be ${describeShortage(shortage, limits.limits)}`,
      { details: { limit, max: limits.limits[limit] } },
    );
  }

  #forgetIfIdle(account: Account): void {
    if (account.kind === 'invitation' && account.isIdle) this.#invitations.delete(account.id);
  }

  /** The same for all clients that came in alike. */
  #maxOfClient(share: Share): Float64Array {
    const key = `${share.shareClass} ${share.invitation !== undefined}`;
    let max = this.#clientMaxima.get(key);
    if (max === undefined) this.#clientMaxima.set(key, (max = this.#computeMaxOfClient(share)));
    return max;
  }

  #computeMaxOfClient({ shareClass, invitation }: Share): Float64Array {
    return this.#maxOf(({ each }) => {
      if (each === undefined) return Number.POSITIVE_INFINITY;
      const { client, participant = client, player = participant } = each;
      const most = this.#limit(client);
      if (shareClass === 'player' || shareClass === 'viewer') {
        return Math.min(most, this.#limit(player));
      }
      return shareClass === 'participant' && invitation !== undefined
        ? Math.min(most, this.#limit(participant))
        : most;
    });
  }

  #maxOf(max: (info: (typeof RESOURCE_INFO)[number]) => number): Float64Array {
    return Float64Array.from(RESOURCE_INFO, max);
  }

  #limit(name: LimitName): number {
    return this.#context.limits.limits[name];
  }
}

/** The account of its class. */
function classOf(account: Account): Account {
  let found = account;
  while (found.kind !== 'class' && found.parent !== undefined) found = found.parent;
  return found;
}

/** A part of a limit: one at least, and all of a limit that is too small to be shared. */
function partOf(limit: number, fraction: number): number {
  return limit - Math.floor(limit * (1 - fraction));
}

function unlimited(): Float64Array {
  return new Float64Array(RESOURCES.length).fill(Number.POSITIVE_INFINITY);
}
