import { MIB, limit } from './limit.ts';

/** Limits of sessions and modules. */
export const SESSION_LIMITS = {
  sessionNewsBytesPerSecond: limit(
    1 * MIB,
    'bytes/s',
    'rates',
    'The same limit for changes of one session. A session of 50 KiB can change 20 times per second.',
  ),
  sessionStartBytesPerSecond: limit(
    1 * MIB,
    'bytes/s',
    'rates',
    'Average rate of sessions started by callers with one invitation, in bytes of the sessions, with bursts of 32 times as much. Each change of state sends the session to all subscribers.',
  ),
  sessions: limit(
    1_024,
    'sessions',
    'sessions',
    'Sessions of the master, including stopped ones. A workshop has some hundred; a session takes some 10 KiB.',
  ),
  modulesPerSession: limit(
    256,
    'modules',
    'sessions',
    'Modules of one session. Enough for 256 players with one module each.',
  ),
  mappingsPerSession: limit(
    4_096,
    'mappings',
    'sessions',
    'Mapped inputs and outputs of one session. Sixteen for each module.',
  ),
  moduleSourceBytes: limit(
    1 * MIB,
    'bytes',
    'sessions',
    'Bytes of the source of one module. Nodes have the same limit. Enough for a bundled library.',
  ),
  sessionBytes: limit(
    8 * MIB,
    'bytes',
    'sessions',
    'Encoded bytes of one session or of one stored module. The code of a large module has some hundred KiB.',
  ),
  sessionsBytes: limit(256 * MIB, 'bytes', 'sessions', 'Encoded bytes of all sessions.'),
  storedDocuments: limit(
    4_096,
    'documents',
    'sessions',
    'Stored sessions; the same number of stored modules.',
  ),
  storedBytes: limit(
    256 * MIB,
    'bytes',
    'sessions',
    'Encoded bytes of all stored sessions; the same for all stored modules.',
  ),
  moduleBytes: limit(
    2_048 * MIB,
    'bytes',
    'sessions',
    'Memory of all sandboxed modules on the master. By default a quarter of the memory of the machine or container, at least 256 MiB. A module without state takes less than 1 MiB.',
  ),
  moduleBytesPerSession: limit(
    1_024 * MIB,
    'bytes',
    'sessions',
    'Memory of the sandboxed modules of one session on the master. By default 1 GiB or half of `moduleBytes`, whichever is less, so that memory remains for other sessions.',
  ),
  sourceCheckTimeoutMs: limit(
    3_000,
    'ms',
    'sessions',
    'Time to check the code of a session. Starting a worker takes one fifth of it.',
  ),
  startTimeoutMs: limit(
    10_000,
    'ms',
    'sessions',
    'Time within which nodes must report that modules run. Loading an object detector from disk takes several seconds.',
  ),
  stopTimeoutMs: limit(
    10_000,
    'ms',
    'sessions',
    'Time within which nodes must report that modules have stopped.',
  ),
  lockstepTimeoutMs: limit(
    500,
    'ms',
    'sessions',
    'Time within which a node must answer a lockstep pass.',
  ),
} as const;
