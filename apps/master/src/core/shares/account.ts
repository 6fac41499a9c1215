import { RESOURCES, type Resource } from './resources.ts';

/** Kind of an account. `all` is the whole master. */
export type AccountKind = 'all' | 'class' | 'invitation' | 'client' | 'session' | 'master';

/** Fixed properties of an account. */
export interface AccountInit {
  readonly kind: AccountKind;
  /** Id of the client, session or invitation; name of the class. */
  readonly id: string;
  /** Name for people. Default: its id. */
  readonly label?: string;
  /** The account that everything counts for as well; undefined for that of the whole master. */
  readonly parent?: Account | undefined;
  /** The most of each resource, in the order of `RESOURCE`. */
  readonly max: Float64Array;
  /** Total usage up to which this account may use more, per resource. Default: the limit. */
  readonly untilFilled?: Float64Array;
}

/**
 * The usage of each limited resource by one client [AC-80]. Usage of an account is also added to its invitation,
 * its class and the whole. Adding is cheap enough for each record: some additions of numbers.
 */
export class Account {
  readonly kind: AccountKind;
  readonly id: string;
  readonly label: string;
  #parent: Account | undefined;
  #max: Float64Array;
  readonly #untilFilled: Float64Array | undefined;
  readonly #used = new Float64Array(RESOURCES.length);
  /** By resource; undefined before the first, as for nearly all clients. */
  #barrenUntilMs: Map<Resource, number> | undefined = undefined;

  constructor({ kind, id, label = id, parent, max, untilFilled }: AccountInit) {
    this.kind = kind;
    this.id = id;
    this.label = label;
    this.#parent = parent;
    this.#max = max;
    this.#untilFilled = untilFilled;
  }

  get parent(): Account | undefined {
    return this.#parent;
  }

  used(resource: Resource): number {
    return this.#used[resource]!;
  }

  max(resource: Resource): number {
    return this.#max[resource]!;
  }

  /** Total usage up to which this account may use more; undefined: the limit. */
  untilFilled(resource: Resource): number | undefined {
    return this.#untilFilled?.[resource];
  }

  /** Time of the next search for a client that could free this, monotonic milliseconds. */
  barrenUntilMs(resource: Resource): number {
    return this.#barrenUntilMs?.get(resource) ?? Number.NEGATIVE_INFINITY;
  }

  /** No client could free this: there is no search until then. */
  setBarren(resource: Resource, untilMs: number): void {
    this.#barrenUntilMs ??= new Map();
    this.#barrenUntilMs.set(resource, untilMs);
  }

  /** Nothing is used. */
  get isIdle(): boolean {
    return this.#used.every((amount) => amount === 0);
  }

  /** Whether this account, or one it counts for, is `other`. */
  isWithin(other: Account): boolean {
    return this === other || (this.#parent?.isWithin(other) ?? false);
  }

  /**
   * The account that has no room for `amount` more of this: the own one, that of the invitation, of the class or of
   * the whole. Undefined: there is room.
   * @param from The account that pays for it now: what both count for stays the same.
   */
  shortage(resource: Resource, amount: number, from?: Account): Account | undefined {
    return this.#shortage(resource, amount, from, Number.POSITIVE_INFINITY);
  }

  /** Takes so much, or with a negative number gives it back. */
  add(resource: Resource, amount: number): void {
    this.#used[resource]! += amount;
    this.#parent?.add(resource, amount);
  }

  /** From now on it counts for another account, with all it uses [AC-18]. */
  moveTo(parent: Account | undefined, max: Float64Array): void {
    this.#max = max;
    if (parent === this.#parent) return;
    for (const resource of RESOURCES) {
      this.#parent?.add(resource, -this.#used[resource]!);
      parent?.add(resource, this.#used[resource]!);
    }
    this.#parent = parent;
  }

  /** @param fillMax how full the whole may be for the account that asks */
  #shortage(
    resource: Resource,
    amount: number,
    from: Account | undefined,
    fillMax: number,
  ): Account | undefined {
    if (from?.isWithin(this)) return undefined;
    const used = this.#used[resource]! + amount;
    if (used > this.#max[resource]!) return this;
    if (this.kind === 'all' && used > fillMax) return this;
    const nextFillMax = this.#untilFilled?.[resource] ?? fillMax;
    const parent = this.#parent;
    if (parent === undefined) return undefined;
    return parent.#shortage(resource, amount, from, nextFillMax);
  }
}
