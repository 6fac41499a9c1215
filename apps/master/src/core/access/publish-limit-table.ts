import type { LimitName, Limits } from '../limits/index.ts';
import type { PublishLimits } from '../topics/publish-limits.ts';
import type { ClientAccess } from './caller.ts';

/** Limits of what a client publishes, for each way to come in. */
const LIMITS_BY_ROLE = {
  frameBytes: { client: 'frameBytes', player: 'frameBytesOfPlayer' },
  frameRecords: { client: 'frameRecords', player: 'frameRecordsOfPlayer' },
  recordFields: { client: 'recordFields', player: 'recordFieldsOfPlayer' },
  recordsPerSecond: {
    client: 'recordsPerSecond',
    participant: 'recordsPerSecondOfParticipant',
    player: 'recordsPerSecondOfPlayer',
  },
  bytesPerSecond: {
    client: 'publishedBytesPerSecond',
    participant: 'publishedBytesPerSecondOfParticipant',
    player: 'publishedBytesPerSecondOfPlayer',
  },
} as const satisfies { readonly [L in keyof PublishLimits]: LimitsOfRoles };

interface LimitsOfRoles {
  /** Admins, clients without an invitation, and upper bound of the two below. */
  readonly client: LimitName;
  /** Participants that were invited. Default: as `client`. */
  readonly participant?: LimitName;
  /** Players and viewers. Default: as `client`. */
  readonly player?: LimitName;
}

/** The limits of what clients publish, by the way they came in. [TD-70] */
export class PublishLimitTable {
  readonly #client: PublishLimits;
  readonly #participant: PublishLimits;
  readonly #player: PublishLimits;

  constructor(limits: Limits) {
    this.#client = limitsFor('client', limits);
    this.#participant = limitsFor('participant', limits);
    this.#player = limitsFor('player', limits);
  }

  of({ role, grant }: Pick<ClientAccess, 'role' | 'grant'>): PublishLimits {
    if (role === 'admin') return this.#client;
    if (role !== 'participant') return this.#player;
    return grant === undefined ? this.#client : this.#participant;
  }
}

function limitsFor(role: keyof LimitsOfRoles, limits: Limits): PublishLimits {
  const held = Object.entries(LIMITS_BY_ROLE).map(([key, names]: [string, LimitsOfRoles]) => {
    const own = names[role] ?? names.client;
    // A limit of all clients that was lowered holds for each role as well.
    const name = limits[own] <= limits[names.client] ? own : names.client;
    return [key, { name, value: limits[name] }];
  });
  return Object.fromEntries(held) as PublishLimits;
}
