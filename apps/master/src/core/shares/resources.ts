import type { LimitName } from '../limits/index.ts';

/** Limited resources that all clients share [AC-80]. The numbers are places in the tables of an account. */
export const RESOURCE = {
  topics: 0,
  retainedBytes: 1,
  subscriptions: 2,
  patterns: 3,
  profiles: 4,
  registrationBytes: 5,
  clients: 6,
  sockets: 7,
  devices: 8,
  queueBytes: 9,
} as const;

/** A scarce resource. */
export type Resource = (typeof RESOURCE)[keyof typeof RESOURCE];

export const RESOURCES = Object.values(RESOURCE);

/** The limits of one resource. */
export interface ResourceInfo {
  /** Name of the resource in messages. */
  readonly what: string;
  /** The limit of the whole master: what shares are parts of. */
  readonly all: LimitName;
  /** Limit per owner by role; default: only those of its invitation and class. */
  readonly each?: {
    /** Admins, clients without an invitation, and upper bound of the two below. */
    readonly client: LimitName;
    /** Participants that were invited. Default: as `client`. */
    readonly participant?: LimitName;
    /** Players and viewers. Default: as `participant`. */
    readonly player?: LimitName;
  };
}

/** Every scarce resource with its limits, in the order of `RESOURCE` [AC-81]. */
export const RESOURCE_INFO: readonly ResourceInfo[] = [
  {
    what: 'topics',
    all: 'topics',
    each: {
      client: 'topicsPerClient',
      participant: 'topicsPerParticipant',
      player: 'topicsPerPlayer',
    },
  },
  {
    what: 'bytes of retained records',
    all: 'retainedBytes',
    each: {
      client: 'retainedBytesPerClient',
      participant: 'retainedBytesPerParticipant',
      player: 'retainedBytesPerPlayer',
    },
  },
  {
    what: 'topic subscriptions',
    all: 'subscriptions',
    each: { client: 'subscriptionsPerClient' },
  },
  {
    what: 'different regular expressions',
    all: 'patterns',
    each: {
      client: 'patternsPerClient',
      participant: 'patternsPerParticipant',
      player: 'patternsPerPlayer',
    },
  },
  {
    what: 'component profiles',
    all: 'profiles',
    each: { client: 'profilesPerClient', player: 'profilesPerPlayer' },
  },
  {
    what: 'registered bytes',
    all: 'registrationBytes',
    each: { client: 'registrationBytesPerClient', player: 'registrationBytesPerPlayer' },
  },
  { what: 'clients', all: 'clients' },
  { what: 'topic-data sockets', all: 'sockets' },
  {
    what: 'devices',
    all: 'devices',
    each: { client: 'devicesPerClient', player: 'devicesPerPlayer' },
  },
  { what: 'queued bytes', all: 'queuesBytes', each: { client: 'queueBytes' } },
];
