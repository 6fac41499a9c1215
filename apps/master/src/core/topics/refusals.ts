import type { ServiceErrorCode } from '@ubii/proto';
import { describeThrottle } from '../counters/throttle.ts';
import type { LimitName, Limits } from '../limits/index.ts';
import { describeShortage, limitOf } from '../shares/shortage.ts';
import type { Publication } from './publication.ts';
import type { HeldLimit } from './publish-limits.ts';
import { quote } from '../texts/quote.ts';

/** Why a record is refused. A constant, because refusing must not cost more than publishing. */
export interface Refusal {
  readonly code: ServiceErrorCode;
  /** The limit that was met, if it was one. */
  readonly limit?: LimitName | ((publication: Publication, limits: Limits) => LimitName);
  /** It holds for the rest of the records of the message as well: they are counted without being read. [TD-70] */
  readonly isForRest?: boolean;
  /** Names the topic, what was expected and what was received: one sentence [TD-17]. */
  describe(publication: Publication, limits: Limits): string;
}

/** Every reason for which a record of a client is refused. */
export const REFUSALS = {
  noTopic: {
    code: 'invalid_argument',
    describe: ({ byteLength }) =>
      `The record of ${byteLength} bytes has no topic. Set \`topic\` to a non-empty string.`,
  },
  longTopic: {
    code: 'resource_exhausted',
    limit: 'topicBytes',
    describe: ({ topic }, { topicBytes }) =>
      `The topic ${quote(topic)} has ${topic.length} characters, but a topic has at most ${topicBytes} bytes (limit topicBytes).`,
  },
  controlCharacter: {
    code: 'invalid_argument',
    describe: ({ topic }) =>
      `The topic ${quote(topic)} contains a control character, but a topic is text on one line.`,
  },
  mastersTopic: {
    code: 'permission_denied',
    describe: ({ topic }) =>
      `Only the master publishes on ${quote(topic)}; a client publishes on topics that do not begin with /info/ or /ubii/.`,
  },
  /** [AC-24] */
  notYours: {
    code: 'permission_denied',
    describe: ({ topic, client }) =>
      `The record on ${quote(topic)} was refused: a client that joined with this role publishes on its own topics, /${client?.id ?? '<its id>'}/..., and on those it was given.`,
  },
  tooManyRecords: {
    code: 'resource_exhausted',
    limit: ({ client }) => client!.publishLimits.recordsPerSecond.name,
    isForRest: true,
    describe: ({ topic, client }) =>
      `The record on ${quote(topic)} exceeds the rate limit: this client publishes at most ${described(client!.publishLimits.recordsPerSecond, 'records per second')}.`,
  },
  /** [TD-70] */
  manyRecords: {
    code: 'resource_exhausted',
    limit: ({ client }) => client!.publishLimits.frameRecords.name,
    isForRest: true,
    describe: ({ topic, client }) =>
      `The record on ${quote(topic)} and those after it were refused: a message of this client has at most ${described(client!.publishLimits.frameRecords, 'records')}.`,
  },
  /** [TD-70] */
  largeFrame: {
    code: 'resource_exhausted',
    limit: ({ client }) => client!.publishLimits.frameBytes.name,
    describe: ({ byteLength, client }) =>
      `The message has ${byteLength} bytes, but a message of this client has at most ${described(client!.publishLimits.frameBytes, 'bytes')}.`,
  },
  /** [EX-32] */
  throttled: {
    code: 'resource_exhausted',
    isForRest: true,
    describe: ({ topic, client }) =>
      `The record on ${quote(topic)} was dropped: this client is ${client?.throttle === undefined ? 'throttled' : describeThrottle(client.throttle)}.`,
  },
  tooManyBytes: {
    code: 'resource_exhausted',
    limit: ({ client }) => client!.publishLimits.bytesPerSecond.name,
    describe: ({ byteLength, client }) =>
      `A message of ${byteLength} bytes exceeds the rate limit: this client publishes at most ${described(client!.publishLimits.bytesPerSecond, 'bytes per second')}.`,
  },
  /** [RP-20] */
  replayed: {
    code: 'failed_precondition',
    describe: ({ topic }) =>
      `The record on ${quote(topic)} was dropped: a replay plays this topic and mutes all others. Publish again when the replay has stopped.`,
  },
  /** [AC-83] */
  noRoom: {
    code: 'resource_exhausted',
    limit: ({ shortage }, limits) => limitOf(shortage!, limits),
    describe: ({ topic, shortage }, limits) =>
      `The record on ${quote(topic)} was refused: with it there would be ${describeShortage(shortage!, limits)}`,
  },
} as const satisfies Record<string, Refusal>;

/** The limit and its name: `10000 records per second (limit recordsPerSecondOfPlayer)`. */
function described({ name, value }: HeldLimit, unit: string): string {
  return `${value} ${unit} (limit ${name})`;
}
