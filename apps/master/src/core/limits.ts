const KIB = 1024;
const MIB = 1024 * KIB;

/** What a limit is, for people [EX-35]. */
export interface LimitInfo {
  readonly value: number;
  /** What the value counts. */
  readonly unit: string;
  /** The heading it stands under. */
  readonly group: LimitGroup;
  /** What is limited, and why by this number. */
  readonly reason: string;
}

/** Headings of limits, in their order. */
export type LimitGroup =
  | 'messages'
  | 'storage'
  | 'subscriptions'
  | 'rates'
  | 'queues'
  | 'sessions'
  | 'time'
  | 'statistics';

/**
 * Every limit of the master. Whoever meets one is answered with `resource_exhausted` and the limit's
 * name; it is counted, and shown in the metrics, the status and its problems. Units are in the names.
 */
export const LIMITS = {
  // --- What one message may be ---

  frameBytes: limit(
    32 * MIB,
    'bytes',
    'messages',
    'One WebSocket message or one service request. A raw 4K image (3840 x 2160 RGBA) is 31.6 MiB.',
  ),
  // MAX_TOPIC_BYTES
  topicBytes: limit(
    1024,
    'bytes',
    'messages',
    'UTF-8 bytes of a topic. Real topics are ids and short names, some 100 bytes; 1024 leaves room and keeps a full topic table in memory.',
  ),
  patternLength: limit(
    1024,
    'characters',
    'messages',
    'Characters of a regular expression. Compiling and the compiled program grow with it.',
  ),
  patternInstructions: limit(
    1_024,
    'instructions',
    'messages',
    'Instructions of a compiled regular expression: what one character of a topic may cost at worst. A UUID takes some 60.',
  ),
  listElements: limit(
    20_000,
    'elements',
    'messages',
    'Elements of one list in a service request. Existing clients list every topic they ever saw when they leave.',
  ),

  listProfiles: limit(
    64,
    'profiles',
    'messages',
    'Profiles in one request for a list. Each is compared with everything that is listed.',
  ),

  // --- What the master holds ---

  topics: limit(
    262_144,
    'topics',
    'storage',
    'Topics with a value or a subscription. Two clients with 100 000 topics each fit; an entry takes about 1 KiB.',
  ),
  topicsPerClient: limit(
    131_072,
    'topics',
    'storage',
    'Topics that belong to one client. Leaves half of all topics to the others.',
  ),
  retainedBytes: limit(
    512 * MIB,
    'bytes',
    'storage',
    'Bytes of all retained records. Sixteen raw 4K images, and a machine with 2 GiB still has room.',
  ),
  clients: limit(
    10_000,
    'clients',
    'storage',
    'Registered clients. Ten times the largest room; one costs some KiB.',
  ),
  sockets: limit(
    10_000,
    'sockets',
    'storage',
    'Open topic-data sockets, below the file descriptors a process usually may have (16 384 and more).',
  ),
  grants: limit(
    256,
    'grants',
    'storage',
    'Leaves to join that are kept. One for each group of an event, and for each start of the master.',
  ),
  devicesPerClient: limit(
    1_024,
    'devices',
    'storage',
    'Devices of one client. A phone is one or two; a motion-capture rig is a few dozen.',
  ),
  componentsPerDevice: limit(
    1_024,
    'components',
    'storage',
    'Components of one device. A full body with fingers has some hundred joints.',
  ),
  registrationBytesPerClient: limit(
    4 * MIB,
    'bytes',
    'storage',
    'Encoded bytes of what one client registered: itself, its modules with their code, its devices.',
  ),
  registrationBytes: limit(
    256 * MIB,
    'bytes',
    'storage',
    'Encoded bytes of what all clients registered.',
  ),

  // --- Subscriptions ---

  subscriptionsPerClient: limit(
    32_768,
    'subscriptions',
    'subscriptions',
    'Subscriptions by topic of one client. One for each of 10 000 topics, and more.',
  ),
  patternsPerClient: limit(
    1_024,
    'expressions',
    'subscriptions',
    'Regular expressions of one client. A new topic is tried against each.',
  ),
  patterns: limit(
    4_096,
    'expressions',
    'subscriptions',
    'Different regular expressions of all clients together: bounds what a new topic costs everybody.',
  ),
  // PATTERN_MATCH_MS
  patternMatchMs: limit(
    500,
    'ms',
    'subscriptions',
    'Time that matching the regular expressions of one client may take at once. Ordinary ones take a thousandth for a topic; what is built to be slow may take thirty.',
  ),
  // PATTERN_MATCH_MS_PER_SECOND
  patternMatchMsPerSecond: limit(
    50,
    'ms/s',
    'subscriptions',
    'The same per second in the long run: a twentieth of the master.',
  ),
  profilesPerClient: limit(
    256,
    'profiles',
    'subscriptions',
    'Component profiles of one client. A registered component is tried against each.',
  ),
  profiles: limit(
    2_048,
    'profiles',
    'subscriptions',
    'Different component profiles of all clients together.',
  ),

  // --- Rates of one client ---

  recordsPerSecond: limit(
    1_000_000,
    'records/s',
    'rates',
    'Records a client may publish per second, and at once. A benchmark publishes some 200 000.',
  ),
  publishedBytesPerSecond: limit(
    1_024 * MIB,
    'bytes/s',
    'rates',
    'Bytes of records a client may publish per second, and at once. Three raw 4K cameras at 10 Hz.',
  ),
  // MAX_ERRORS_PER_SECOND
  errorsPerSecond: limit(
    10,
    'errors/s',
    'rates',
    'TopicData errors sent to a client per second. More teach nobody and cost more than the record.',
  ),
  // MAX_PROTOCOL_ERRORS
  protocolErrors: limit(
    20,
    'messages',
    'rates',
    'Frames within `protocolErrorWindowMs` that cannot be decoded before the socket is closed. A client with a bug has a few; a stranger has only these.',
  ),
  protocolErrorWindowMs: limit(10_000, 'ms', 'rates', 'The window of `protocolErrors`.'),

  wrongCodesPerAddress: limit(
    10,
    'codes/min',
    'rates',
    'Wrong join codes from one address in a minute before codes from there are not looked at. People mistype twice.',
  ),
  wrongCodes: limit(
    200,
    'codes/min',
    'rates',
    'The same of all addresses together. A code stands for 12 hours at most: 144 000 tries at 10^12 codes.',
  ),

  // --- What waits for one client ---

  // MAX_BATCH_BYTES
  batchBytes: limit(
    1 * MIB,
    'bytes',
    'queues',
    'Bytes of one write to one client; what is more leaves in the next. Keeps a list frame easy to take for a phone.',
  ),
  connectionQueuedBytes: limit(
    2 * MIB,
    'bytes',
    'queues',
    "Bytes handed to a socket and not taken, beyond which records wait in the client's queue. Some milliseconds of a fast network.",
  ),
  queueBytes: limit(
    64 * MIB,
    'bytes',
    'queues',
    "Bytes that wait in a client's queue. Two raw 4K images.",
  ),
  // MAX_QUEUED_EVENTS
  queuedEventsPerTopic: limit(
    1_024,
    'events',
    'queues',
    "Events of one topic that wait in a client's queue. Some seconds of a fast typist or of a finger at 120 Hz.",
  ),
  // SLOW_SOCKET_TIMEOUT_MS
  slowSocketTimeoutMs: limit(
    30_000,
    'ms',
    'queues',
    'A socket that takes nothing for this long is closed. A raw 4K image in one piece passes at 10 Mbit/s.',
  ),

  // --- Sessions ---

  // MAX_SESSIONS
  sessions: limit(
    1_024,
    'sessions',
    'sessions',
    'Sessions the master knows, stopped ones included. A workshop has some hundred; one takes tens of KiB.',
  ),
  // MAX_MODULES_PER_SESSION
  modulesPerSession: limit(
    256,
    'modules',
    'sessions',
    'Modules of one session. An orchestra of 256 players, each with its own.',
  ),
  // MAX_MAPPINGS_PER_SESSION
  mappingsPerSession: limit(
    4_096,
    'mappings',
    'sessions',
    'Inputs and outputs mapped in one session. Sixteen for each module.',
  ),
  // MAX_SOURCE_BYTES
  moduleSourceBytes: limit(
    1 * MIB,
    'bytes',
    'sessions',
    'Bytes of the source of one module, as nodes take it. A bundled library fits.',
  ),
  // MAX_SESSION_BYTES
  sessionBytes: limit(
    8 * MIB,
    'bytes',
    'sessions',
    "Encoded bytes of one session as it was sent, or of one stored module. Code of a large model's glue is some hundred KiB.",
  ),
  // MAX_SESSIONS_BYTES
  sessionsBytes: limit(256 * MIB, 'bytes', 'sessions', 'The same of all sessions.'),
  storedDocuments: limit(4_096, 'documents', 'sessions', 'Stored sessions, and stored modules.'),
  storedBytes: limit(
    256 * MIB,
    'bytes',
    'sessions',
    'Encoded bytes of all stored sessions, and of all stored modules.',
  ),
  sourceCheckTimeoutMs: limit(
    3_000,
    'ms',
    'sessions',
    'Looking at the code of a session. A worker that has to be started first takes a fifth.',
  ),
  // START_TIMEOUT_MS
  startTimeoutMs: limit(
    10_000,
    'ms',
    'sessions',
    'Time nodes have to say that modules run. Loading a detector from disk takes some seconds.',
  ),
  // STOP_TIMEOUT_MS
  stopTimeoutMs: limit(10_000, 'ms', 'sessions', 'Time nodes have to say that modules ended.'),
  // LOCKSTEP_TIMEOUT_MS
  lockstepTimeoutMs: limit(
    500,
    'ms',
    'sessions',
    'What a node may take for its share of a lockstep pass. Slower than two a second is no lockstep any more.',
  ),

  // --- Time ---

  // SERVICE_TIMEOUT_MS
  serviceTimeoutMs: limit(
    8_000,
    'ms',
    'time',
    'The answer to a service request. Shorter than the 10 s after which clients of ours give up.',
  ),
  // REPLAY_DELAY_MS
  replayDelayMs: limit(
    25,
    'ms',
    'time',
    'Retained records reach an existing client this long after the reply. Browser and Node nodes take up the callback some turns after they read the reply; without it every third record was lost to them.',
  ),
  // UNAVAILABLE_RETENTION_MS
  unavailableRetentionMs: limit(
    20 * 60_000,
    'ms',
    'time',
    'How long an unavailable client is remembered. A phone may sleep through a break and come back as itself.',
  ),

  // --- Statistics ---

  keptRemovals: limit(
    10_000,
    'topics',
    'statistics',
    'Deleted topics remembered for readers of the statistics; who asks less often gets a full list.',
  ),
} as const satisfies Record<string, LimitInfo>;

/** Name of a limit, as errors, metrics and problems show it. */
export type LimitName = keyof typeof LIMITS;

/** The limits one master runs with. */
export type Limits = { readonly [L in LimitName]: number };

/** The numbers of the table above. */
export const DEFAULT_LIMITS = Object.fromEntries(
  Object.entries(LIMITS).map(([name, { value }]) => [name, value]),
) as Limits;

function limit(value: number, unit: string, group: LimitGroup, reason: string): LimitInfo {
  return { value, unit, group, reason };
}
