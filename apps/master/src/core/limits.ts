const KIB = 1024;
const MIB = 1024 * KIB;

/**
 * Every limit of the master. Whoever meets one is answered with `resource_exhausted` and the limit's
 * name; it is counted, and shown in the metrics, the status and its problems. Units are in the names.
 */
export const DEFAULT_LIMITS = {
  // --- What one message may be ---

  /** One WebSocket message or one service request. A raw 4K image (3840 x 2160 RGBA) is 31.6 MiB. */
  frameBytes: 32 * MIB,
  /** UTF-8 bytes of a topic (MAX_TOPIC_BYTES). Real topics are ids and short names, some 100 bytes; 1024 leaves room and keeps a full topic table in memory. */
  topicBytes: 1024,
  /** Characters of a regular expression. Compiling and the compiled program grow with it. */
  patternLength: 1024,
  /** Instructions of a compiled regular expression: what one character of a topic may cost at worst. A UUID takes some 60. */
  patternInstructions: 1_024,
  /** Elements of one list in a service request. Existing clients list every topic they ever saw when they leave. */
  listElements: 20_000,

  /** Profiles in one request for a list. Each is compared with everything that is listed. */
  listProfiles: 64,

  // --- What the master holds ---

  /** Topics with a value or a subscription. Two clients with 100 000 topics each fit; an entry takes about 1 KiB. */
  topics: 262_144,
  /** Topics that belong to one client. Leaves half of all topics to the others. */
  topicsPerClient: 131_072,
  /** Bytes of all retained records. Sixteen raw 4K images, and a machine with 2 GiB still has room. */
  retainedBytes: 512 * MIB,
  /** Registered clients. Ten times the largest room; one costs some KiB. */
  clients: 10_000,
  /** Open topic-data sockets, below the file descriptors a process usually may have (16 384 and more). */
  sockets: 10_000,
  /** Devices of one client. A phone is one or two; a motion-capture rig is a few dozen. */
  devicesPerClient: 1_024,
  /** Components of one device. A full body with fingers has some hundred joints. */
  componentsPerDevice: 1_024,
  /** Encoded bytes of what one client registered: itself, its modules with their code, its devices. */
  registrationBytesPerClient: 4 * MIB,
  /** Encoded bytes of what all clients registered. */
  registrationBytes: 256 * MIB,

  // --- Subscriptions ---

  /** Subscriptions by topic of one client. One for each of 10 000 topics, and more. */
  subscriptionsPerClient: 32_768,
  /** Regular expressions of one client. A new topic is tried against each. */
  patternsPerClient: 1_024,
  /** Different regular expressions of all clients together: bounds what a new topic costs everybody. */
  patterns: 4_096,
  /** Time that matching the regular expressions of one client may take at once, milliseconds (PATTERN_MATCH_MS). Ordinary ones take a thousandth for a topic; what is built to be slow may take thirty. */
  patternMatchMs: 500,
  /** The same per second in the long run, milliseconds (PATTERN_MATCH_MS_PER_SECOND): a twentieth of the master. */
  patternMatchMsPerSecond: 50,
  /** Component profiles of one client. A registered component is tried against each. */
  profilesPerClient: 256,
  /** Different component profiles of all clients together. */
  profiles: 2_048,

  // --- Rates of one client ---

  /** Records a client may publish per second, and at once. A benchmark publishes some 200 000. */
  recordsPerSecond: 1_000_000,
  /** Bytes of records a client may publish per second, and at once. Three raw 4K cameras at 10 Hz. */
  publishedBytesPerSecond: 1_024 * MIB,
  /** TopicData errors sent to a client per second (MAX_ERRORS_PER_SECOND). More teach nobody and cost more than the record. */
  errorsPerSecond: 10,
  /** Frames within `protocolErrorWindowMs` that cannot be decoded before the socket is closed (MAX_PROTOCOL_ERRORS). A client with a bug has a few; a stranger has only these. */
  protocolErrors: 20,
  /** The window of `protocolErrors`, milliseconds. */
  protocolErrorWindowMs: 10_000,

  // --- What waits for one client ---

  /** Bytes of one write to one client (MAX_BATCH_BYTES); what is more leaves in the next. Keeps a list frame easy to take for a phone. */
  batchBytes: 1 * MIB,
  /** Bytes handed to a socket and not taken, beyond which records wait in the client's queue. Some milliseconds of a fast network. */
  connectionQueuedBytes: 2 * MIB,
  /** Bytes that wait in a client's queue. Two raw 4K images. */
  queueBytes: 64 * MIB,
  /** Events of one topic that wait in a client's queue (MAX_QUEUED_EVENTS). Some seconds of a fast typist or of a finger at 120 Hz. */
  queuedEventsPerTopic: 1_024,
  /** A socket that takes nothing for this long is closed, milliseconds (SLOW_SOCKET_TIMEOUT_MS). A raw 4K image in one piece passes at 10 Mbit/s. */
  slowSocketTimeoutMs: 30_000,

  // --- Sessions ---

  /** Sessions the master knows, stopped ones included (MAX_SESSIONS). A workshop has some hundred; one takes tens of KiB. */
  sessions: 1_024,
  /** Modules of one session (MAX_MODULES_PER_SESSION). An orchestra of 256 players, each with its own. */
  modulesPerSession: 256,
  /** Inputs and outputs mapped in one session (MAX_MAPPINGS_PER_SESSION). Sixteen for each module. */
  mappingsPerSession: 4_096,
  /** Bytes of the source of one module (MAX_SOURCE_BYTES), as nodes take it. A bundled library fits. */
  moduleSourceBytes: 1 * MIB,
  /** Encoded bytes of one session as it was sent (MAX_SESSION_BYTES), or of one stored module. Code of a large model's glue is some hundred KiB. */
  sessionBytes: 8 * MIB,
  /** The same of all sessions (MAX_SESSIONS_BYTES). */
  sessionsBytes: 256 * MIB,
  /** Stored sessions, and stored modules. */
  storedDocuments: 4_096,
  /** Encoded bytes of all stored sessions, and of all stored modules. */
  storedBytes: 256 * MIB,
  /** Looking at the code of a session, milliseconds. A worker that has to be started first takes a fifth. */
  sourceCheckTimeoutMs: 3_000,
  /** Time nodes have to say that modules run, milliseconds (START_TIMEOUT_MS). Loading a detector from disk takes some seconds. */
  startTimeoutMs: 10_000,
  /** Time nodes have to say that modules ended, milliseconds (STOP_TIMEOUT_MS). */
  stopTimeoutMs: 10_000,
  /** What a node may take for its share of a lockstep pass, milliseconds (LOCKSTEP_TIMEOUT_MS). Slower than two a second is no lockstep any more. */
  lockstepTimeoutMs: 500,

  // --- Time ---

  /** The answer to a service request, milliseconds (SERVICE_TIMEOUT_MS). Shorter than the 10 s after which clients of ours give up. */
  serviceTimeoutMs: 8_000,
  /** Retained records reach an existing client this long after the reply, milliseconds (REPLAY_DELAY_MS). Browser and Node nodes take up the callback some turns after they read the reply; without it every third record was lost to them. */
  replayDelayMs: 25,
  /** How long an unavailable client is remembered, milliseconds (UNAVAILABLE_RETENTION_MS). A phone may sleep through a break and come back as itself. */
  unavailableRetentionMs: 20 * 60_000,

  // --- Statistics ---

  /** Deleted topics remembered for readers of the statistics; who asks less often gets a full list. */
  keptRemovals: 10_000,
} as const satisfies Record<string, number>;

/** Name of a limit, as errors, metrics and problems show it. */
export type LimitName = keyof typeof DEFAULT_LIMITS;

/** The limits one master runs with. */
export type Limits = { readonly [L in LimitName]: number };
