import { MIB, limit } from './limit.ts';

/** Limits of topics and of retained records. */
export const TOPIC_LIMITS = {
  topics: limit(
    262_144,
    'topics',
    'storage',
    'Topics with a value or a subscription. Enough for two clients with 100 000 topics each; an entry takes about 1 KiB.',
  ),
  topicsPerClient: limit(
    131_072,
    'topics',
    'storage',
    'Topics of one client: those it publishes to, and those without a publisher that it subscribes to. Half of all topics remain for other clients.',
  ),
  topicsPerParticipant: limit(
    32_768,
    'topics',
    'storage',
    'The same limit for a participant with an invitation. Enough for three programs with 10 000 topics each in one client.',
  ),
  topicsPerPlayer: limit(
    256,
    'topics',
    'storage',
    'The same limit for a player or viewer. A phone with all its sensors has some 20 topics.',
  ),
  topicsPerSession: limit(
    16_384,
    'topics',
    'storage',
    'Topics that the demuxers of one session create on the master. Eight sessions at this limit leave half of all topics for clients.',
  ),
  topicsPerModule: limit(
    4_096,
    'topics',
    'storage',
    'Topics that the demuxers of one module create on the master: one for each element of a muxer.',
  ),
  retainedBytes: limit(
    512 * MIB,
    'bytes',
    'storage',
    'Bytes of all retained records. Enough for sixteen raw 4K images, on a machine with 2 GiB of memory.',
  ),
  retainedBytesPerClient: limit(
    256 * MIB,
    'bytes',
    'storage',
    'Bytes of the retained records on the topics of one client. Enough for eight raw 4K images.',
  ),
  retainedBytesPerParticipant: limit(
    128 * MIB,
    'bytes',
    'storage',
    'The same limit for a participant with an invitation. Enough for four raw 4K images.',
  ),
  retainedBytesPerPlayer: limit(
    32 * MIB,
    'bytes',
    'storage',
    'The same limit for a player or viewer. Enough for one image of a phone camera at full resolution.',
  ),
  replayDelayMs: limit(
    25,
    'ms',
    'time',
    'Delay of retained records after the reply to a subscription, for existing clients. Existing browser and Node clients attach their callback some event-loop turns after they read the reply; without the delay, they lost every third record.',
  ),
  keepMs: limit(
    60 * 60_000,
    'ms',
    'time',
    'Longest time that a value can be kept after its publisher has left. The values of a page survive its reload.',
  ),
  keptRemovals: limit(
    10_000,
    'topics',
    'statistics',
    'Deleted topics that the statistics report. Clients that read the statistics less often get the full list.',
  ),
} as const;
