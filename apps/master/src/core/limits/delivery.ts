import { MIB, limit } from './limit.ts';

/** Limits of publishing and of delivery to one client. */
export const DELIVERY_LIMITS = {
  recordsPerSecond: limit(
    1_000_000,
    'records/s',
    'rates',
    'Records that a client may publish per second, also in one burst. A benchmark publishes some 200 000.',
  ),
  publishedBytesPerSecond: limit(
    1_024 * MIB,
    'bytes/s',
    'rates',
    'Bytes that a client may publish per second, also in one burst. A shorter field counts as 16 bytes, a shorter message as 1024. Beyond it, the messages of the client are read later. Enough for three raw 4K cameras at 10 Hz.',
  ),
  recordsPerSecondOfParticipant: limit(
    200_000,
    'records/s',
    'rates',
    'The same limit for a participant with an invitation. Four times the 50 000 records per second that one replay plays.',
  ),
  recordsPerSecondOfPlayer: limit(
    10_000,
    'records/s',
    'rates',
    'The same limit for a player or viewer. A phone with 20 topics at 60 Hz publishes 1200.',
  ),
  publishedBytesPerSecondOfParticipant: limit(
    256 * MIB,
    'bytes/s',
    'rates',
    'The same limit for a participant with an invitation. Enough for a raw 4K camera at 8 Hz.',
  ),
  publishedBytesPerSecondOfPlayer: limit(
    32 * MIB,
    'bytes/s',
    'rates',
    'The same limit for a player or viewer. Ten times a camera with pictures of 100 kB at 30 Hz.',
  ),
  errorsPerSecond: limit(
    10,
    'errors/s',
    'rates',
    'TopicData errors sent to a client per second. More errors would cost more than the refused records.',
  ),
  protocolErrors: limit(
    20,
    'messages',
    'rates',
    'Frames within `protocolErrorWindowMs` that cannot be decoded, until the socket is closed. A faulty client sends a few such frames, a client of another protocol only such frames.',
  ),
  protocolErrorWindowMs: limit(10_000, 'ms', 'rates', 'Time window of `protocolErrors`.'),
  batchBytes: limit(
    1 * MIB,
    'bytes',
    'queues',
    'Bytes of one write to one client. Further records follow in the next write, so that a phone does not have to decode large frames.',
  ),
  connectionQueuedBytes: limit(
    2 * MIB,
    'bytes',
    'queues',
    "Unsent bytes of a socket, above which records stay in the client's queue. A fast network sends them in a few milliseconds.",
  ),
  connectionQueuedLargeBytes: limit(
    256 * 1024,
    'bytes',
    'queues',
    "Unsent bytes of a socket, above which large records, such as pictures, stay in the client's queue: on a slow network the newest one leaves next, and not one that is seconds old.",
  ),
  queueBytes: limit(
    64 * MIB,
    'bytes',
    'queues',
    'Queued bytes of one client. Enough for two raw 4K images.',
  ),
  queuesBytes: limit(
    512 * MIB,
    'bytes',
    'queues',
    'Queued bytes of all clients. At this limit, a client drops the oldest records of its own queue.',
  ),
  queuedEventsPerTopic: limit(
    1_024,
    'events',
    'queues',
    "Events of one topic in a client's queue. Several seconds of fast typing or of touch events at 120 Hz.",
  ),
  slowSocketTimeoutMs: limit(
    30_000,
    'ms',
    'queues',
    'Time without progress after which a socket is closed. Enough to send a raw 4K image at 10 Mbit/s.',
  ),
} as const;
