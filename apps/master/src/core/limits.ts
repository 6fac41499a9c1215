import { DEFAULT_PATTERN_LIMITS } from '@ubii/patterns';

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
  | 'texts'
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
    'One WebSocket message. A raw 4K image (3840 x 2160 RGBA) is 31.6 MiB.',
  ),
  strangerBodyBytes: limit(
    16 * KIB,
    'bytes',
    'messages',
    'Body of a service request from a caller that has not joined. Such callers check a token and ask for the configuration: some hundred bytes.',
  ),
  joiningBodyBytes: limit(
    1 * MIB,
    'bytes',
    'messages',
    'Body of a service request from a caller with a token or code that is not registered yet. A registration with devices and small modules fits.',
  ),
  serviceBodyBytes: limit(
    256 * KIB,
    'bytes',
    'messages',
    'Body of an ordinary service request. For sessions, modules and registrations: 1.5 times `sessionBytes` or `registrationBytesPerClient`, because JSON is longer than the encoded form.',
  ),
  subscriptionBodyBytes: limit(
    4 * MIB,
    'bytes',
    'messages',
    'Body of a request to subscribe or unsubscribe: `listElements` topics of 200 bytes.',
  ),
  serviceValues: limit(
    8_192,
    'values',
    'messages',
    'Values (texts, numbers, objects, lists) in an ordinary service request. Decoding time grows with their number.',
  ),
  largeServiceValues: limit(
    65_536,
    'values',
    'messages',
    'Values in a request with a session, modules, a registration or subscriptions. A session with 256 modules and 4096 mappings has some 30 000.',
  ),
  requestDepth: limit(
    64,
    'levels',
    'messages',
    'Nesting depth of objects and lists in a JSON request. The deepest request of the protocol has 16 levels.',
  ),
  // MAX_TOPIC_BYTES
  topicBytes: limit(
    1024,
    'bytes',
    'messages',
    'UTF-8 bytes of a topic. Real topics are ids and short names, some 100 bytes; 1024 leaves room and keeps a full topic table in memory.',
  ),
  patternLength: limit(
    DEFAULT_PATTERN_LIMITS.length,
    'characters',
    'messages',
    'Characters of a regular expression. Compiling and the compiled program grow with it.',
  ),
  patternInstructions: limit(
    DEFAULT_PATTERN_LIMITS.instructions,
    'instructions',
    'messages',
    'Instructions of a compiled regular expression, the worst-case cost of one character of a topic. A UUID pattern takes about 60.',
  ),
  listElements: limit(
    20_000,
    'elements',
    'messages',
    'Elements of one list in a service request. Existing clients list all topics they have used when they disconnect.',
  ),

  listProfiles: limit(
    64,
    'profiles',
    'messages',
    'Profiles in one list request. Each is compared with every listed item.',
  ),

  // --- What one text of a client may be ---

  idCharacters: limit(
    256,
    'characters',
    'texts',
    'Id of a client, device, component, session, module or invitation. Ids of the master have 36 characters; existing programs make their own.',
  ),
  identifierCharacters: limit(
    256,
    'characters',
    'texts',
    'Name of a session, module, component, input, output, muxer or data format. Longer names are refused.',
  ),
  nameCharacters: limit(
    100,
    'characters',
    'texts',
    'Name of a client or device, label of an invitation, author. It appears in events, in the log and on pages. Longer names of clients and devices are cut.',
  ),
  tagCharacters: limit(100, 'characters', 'texts', 'One tag.'),
  textsPerList: limit(
    256,
    'texts',
    'texts',
    'Tags, authors or libraries of one session, module, device or client. A handful is usual.',
  ),
  descriptionCharacters: limit(
    4_096,
    'characters',
    'texts',
    'Description: two pages of text. Of clients, devices and components it is cut, of sessions and modules refused.',
  ),
  reasonCharacters: limit(
    200,
    'characters',
    'texts',
    'Reason for an action on a client, one sentence. Cut when longer.',
  ),
  pathCharacters: limit(301, 'characters', 'texts', 'Path of a page that opens after joining.'),
  libraryCharacters: limit(
    64,
    'characters',
    'texts',
    'Library version, address and node libraries that a client reports. Cut when longer.',
  ),
  userAgentCharacters: limit(
    256,
    'characters',
    'texts',
    'User agent of a browser. Cut when longer.',
  ),
  secretCharacters: limit(
    1_024,
    'characters',
    'texts',
    'Token or code of a caller. Tokens have about 100 characters; longer ones are refused.',
  ),
  jsonCharacters: limit(
    65_536,
    'characters',
    'texts',
    'Metadata of a client, or constant of a session, as JSON.',
  ),
  eventCharacters: limit(
    500,
    'characters',
    'texts',
    'Event or problem in the status of the master. 200 events are kept. Cut when longer.',
  ),
  logCharacters: limit(
    1_000,
    'characters',
    'texts',
    'Message, or one of at most 20 values, of a line of the log. Cut when longer.',
  ),
  stackCharacters: limit(
    8_192,
    'characters',
    'texts',
    'Where in the code an error of the master happened, in its log. Cut when longer.',
  ),
  logBytesPerSecond: limit(
    32 * KIB,
    'bytes/s',
    'texts',
    'Average rate of log lines. After a start or a quiet period, bursts of up to 30 s of this rate are logged. Further lines are dropped and counted.',
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
    'Topics of one client: those it publishes on, and those it subscribes to that have no publisher. Half of all topics remain for the others.',
  ),
  topicsPerParticipant: limit(
    32_768,
    'topics',
    'storage',
    'The same limit for a participant with an invitation. Three programs with 10 000 topics in one.',
  ),
  topicsPerPlayer: limit(
    256,
    'topics',
    'storage',
    'The same limit for a player or viewer. A phone with all its sensors has some twenty.',
  ),
  topicsPerSession: limit(
    16_384,
    'topics',
    'storage',
    'Topics that the demuxers of one session make on the master. Eight sessions at the limit leave room for all clients.',
  ),
  topicsPerModule: limit(
    4_096,
    'topics',
    'storage',
    'Topics that the demuxers of one module make on the master: one for each element that a muxer takes in.',
  ),
  retainedBytes: limit(
    512 * MIB,
    'bytes',
    'storage',
    'Bytes of all retained records. Sixteen raw 4K images; fits a machine with 2 GiB.',
  ),
  retainedBytesPerClient: limit(
    256 * MIB,
    'bytes',
    'storage',
    'Bytes of the retained records on the topics of one client. Eight raw 4K images.',
  ),
  retainedBytesPerParticipant: limit(
    128 * MIB,
    'bytes',
    'storage',
    'The same limit for a participant with an invitation. Four raw 4K images.',
  ),
  retainedBytesPerPlayer: limit(
    32 * MIB,
    'bytes',
    'storage',
    'The same limit for a player or viewer. The camera of a phone at full resolution, once.',
  ),
  clients: limit(
    10_000,
    'clients',
    'storage',
    'Registered clients. Ten times the largest expected room; a client takes some KiB.',
  ),
  sockets: limit(
    10_000,
    'sockets',
    'storage',
    'Open topic-data sockets, below the file descriptors a process usually may have (16 384 and more).',
  ),
  connections: limit(
    12_288,
    'connections',
    'storage',
    'Open connections to all ports. An eighth is kept for this machine. Lowered at startup to half of the open files the process is allowed.',
  ),
  connectionsOfStrangers: limit(
    2_048,
    'connections',
    'storage',
    'The same limit for callers without a token: all phones of a large room that load their page at once. At most half of all.',
  ),
  connectionsPerAddress: limit(
    512,
    'connections',
    'storage',
    'HTTP connections from one remote address. A class of 60 phones behind one router loads its pages at once.',
  ),
  connectionsPerNetwork: limit(
    1_024,
    'connections',
    'storage',
    'The same limit for one IPv6 /64 network: one machine can use all its addresses.',
  ),
  grants: limit(
    256,
    'grants',
    'storage',
    'Invitations. One for each group of an event, and one for each start of the master.',
  ),
  devices: limit(
    20_000,
    'devices',
    'storage',
    'Devices of all clients. Two for each client at the limit.',
  ),
  devicesPerClient: limit(
    1_024,
    'devices',
    'storage',
    'Devices of one client. A phone is one or two; a motion-capture rig is a few dozen.',
  ),
  devicesPerPlayer: limit(16, 'devices', 'storage', 'The same of a player. A phone is one or two.'),
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
    'Encoded bytes of the registration of one client, with its modules and devices.',
  ),
  registrationBytesPerPlayer: limit(
    256 * KIB,
    'bytes',
    'storage',
    'The same limit for a player or viewer. A phone with ten components registers some 3 KiB.',
  ),
  registrationBytes: limit(
    256 * MIB,
    'bytes',
    'storage',
    'Encoded bytes of the registrations of all clients.',
  ),

  // --- Subscriptions ---

  subscriptions: limit(
    1_048_576,
    'subscriptions',
    'subscriptions',
    'Subscriptions by topic of all clients. A hundred clients with 10 000 each; one takes some 100 bytes.',
  ),
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
    'Regular expressions of one client. Each new topic is matched against all of them.',
  ),
  patternsPerParticipant: limit(
    256,
    'expressions',
    'subscriptions',
    'The same limit for a participant with an invitation. A program of ours has a handful.',
  ),
  patternsPerPlayer: limit(
    32,
    'expressions',
    'subscriptions',
    'The same limit for a player or viewer. Thirty phones of one invitation fit into its share of all.',
  ),
  patterns: limit(
    4_096,
    'expressions',
    'subscriptions',
    'Different regular expressions of all clients together: bounds the matching cost of a new topic.',
  ),
  // PATTERN_MATCH_MS
  patternMatchMs: limit(
    500,
    'ms',
    'subscriptions',
    'Time that matching the regular expressions of one client may take at once. An ordinary pattern takes 0.001 ms per topic, one that is built to be slow up to 30 ms.',
  ),
  // PATTERN_MATCH_MS_PER_SECOND
  patternMatchMsPerSecond: limit(
    50,
    'ms/s',
    'subscriptions',
    'The same limit as an average per second: 5 % of the event loop.',
  ),
  profilesPerClient: limit(
    256,
    'profiles',
    'subscriptions',
    'Component profiles of one client. Each registered component is matched against all of them.',
  ),
  profilesPerPlayer: limit(
    16,
    'profiles',
    'subscriptions',
    'The same limit for a player or viewer. Thirty phones of one invitation fit into its share of all.',
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
    'TopicData errors sent to a client per second. Sending more would cost more than the refused records.',
  ),
  // MAX_PROTOCOL_ERRORS
  protocolErrors: limit(
    20,
    'messages',
    'rates',
    'Frames within `protocolErrorWindowMs` that cannot be decoded before the socket is closed. A faulty client sends a few; a client of another protocol sends only such frames.',
  ),
  protocolErrorWindowMs: limit(10_000, 'ms', 'rates', 'The window of `protocolErrors`.'),
  announcementBytes: limit(
    8 * KIB,
    'bytes',
    'rates',
    'Size up to which a registration is announced as a whole when its client changes. Larger registrations are announced by name, state and revision. A phone with twenty components registers some 6 KiB.',
  ),
  clientNewsBytesPerSecond: limit(
    8 * KIB,
    'bytes/s',
    'rates',
    'Average rate of announcements about one client to each subscriber, with bursts of four times as much. Further announcements wait, and the last state is sent.',
  ),
  sessionNewsBytesPerSecond: limit(
    1 * MIB,
    'bytes/s',
    'rates',
    'The same limit for changes of one session. A session of 50 KiB may change twenty times a second.',
  ),
  sessionStartBytesPerSecond: limit(
    1 * MIB,
    'bytes/s',
    'rates',
    'Average rate of session starts by callers of one invitation, with bursts of 32 times as much. Each start, run and stop sends the session to all subscribers.',
  ),

  wrongCodesPerAddress: limit(
    10,
    'codes/s',
    'rates',
    'Wrong join codes from one address. A caller that shares its address with an attacker can still join within a few tries. At this rate, one address guesses a code that is valid for 12 hours with a probability of 4 in 10 million.',
  ),
  wrongCodesPerNetwork: limit(
    20,
    'codes/s',
    'rates',
    'The same limit for one IPv6 /64 network: one of its addresses uses at most half.',
  ),
  wrongCodes: limit(
    200,
    'codes/s',
    'rates',
    'The same limit for all addresses together. A code is valid for at most 12 hours: 9 million tries at 10^12 codes.',
  ),

  // --- What waits for one client ---

  // MAX_BATCH_BYTES
  batchBytes: limit(
    1 * MIB,
    'bytes',
    'queues',
    'Bytes of one write to one client. The rest follows in the next write. Keeps a list frame easy to take for a phone.',
  ),
  connectionQueuedBytes: limit(
    2 * MIB,
    'bytes',
    'queues',
    "Unsent bytes in a socket above which records wait in the client's queue. Some milliseconds of a fast network.",
  ),
  queueBytes: limit(64 * MIB, 'bytes', 'queues', 'Queued bytes of one client. Two raw 4K images.'),
  queuesBytes: limit(
    512 * MIB,
    'bytes',
    'queues',
    'Queued bytes of all clients. A client beyond this limit drops its own oldest records.',
  ),
  // MAX_QUEUED_EVENTS
  queuedEventsPerTopic: limit(
    1_024,
    'events',
    'queues',
    "Queued events of one topic in a client's queue. Some seconds of a fast typist or of a finger at 120 Hz.",
  ),
  // SLOW_SOCKET_TIMEOUT_MS
  slowSocketTimeoutMs: limit(
    30_000,
    'ms',
    'queues',
    'A socket that accepts no data for this long is closed. A raw 4K image in one piece passes at 10 Mbit/s.',
  ),

  // --- Bodies of service requests that are being received or decoded ---

  bodyBytes: limit(
    128 * MIB,
    'bytes',
    'queues',
    'Bytes of all service requests in flight. Local callers and remote callers can each use three quarters.',
  ),
  bodyBytesOfStrangers: limit(
    4 * MIB,
    'bytes',
    'queues',
    'The same limit for all callers that have not joined: 256 of the largest requests.',
  ),
  bodyBytesOfJoining: limit(
    16 * MIB,
    'bytes',
    'queues',
    'The same limit for all callers with a token or code that are not registered yet.',
  ),
  bodyBytesPerAddress: limit(
    2 * MIB,
    'bytes',
    'queues',
    'The same limit for these two kinds of callers from one address. A class of 60 phones behind one router registers at once.',
  ),
  bodyBytesPerClient: limit(
    24 * MIB,
    'bytes',
    'queues',
    'The same limit for one client, or for one address that needs no token. Two of the largest sessions.',
  ),
  bodyBytesPerConnection: limit(
    16 * MIB,
    'bytes',
    'queues',
    'The same limit for one connection. Existing clients send one request after another.',
  ),
  bodyGraceMs: limit(
    10_000,
    'ms',
    'time',
    'Time after which a body must arrive at `bodyBytesPerSecond` or faster. Small bodies must be complete by then.',
  ),
  bodyBytesPerSecond: limit(
    32 * KIB,
    'bytes/s',
    'rates',
    'Lowest rate of the body of a service request. A mobile network with one bar has several times as much.',
  ),

  // --- Sessions ---

  // MAX_SESSIONS
  sessions: limit(
    1_024,
    'sessions',
    'sessions',
    'Sessions of the master, including stopped ones. A workshop has some hundred; one takes tens of KiB.',
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
    "Encoded bytes of one session or of one stored module. Code of a large model's glue is some hundred KiB.",
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
  moduleBytes: limit(
    2_048 * MIB,
    'bytes',
    'sessions',
    "Memory of all sandboxed modules on the master. Unless set, the program takes a quarter of the machine's, or of its container's, at least 256 MiB. A module without state takes less than 1 MiB.",
  ),
  moduleBytesPerSession: limit(
    1_024 * MIB,
    'bytes',
    'sessions',
    'Memory of the sandboxed modules of one session on the master. Unless set, 1 GiB or half of `moduleBytes`, whichever is less, so that others have room.',
  ),
  sourceCheckTimeoutMs: limit(
    3_000,
    'ms',
    'sessions',
    'Time to check the code of a session. Starting a worker takes a fifth of it.',
  ),
  // START_TIMEOUT_MS
  startTimeoutMs: limit(
    10_000,
    'ms',
    'sessions',
    'Time within which nodes must report that modules run. Loading a detector from disk takes some seconds.',
  ),
  // STOP_TIMEOUT_MS
  stopTimeoutMs: limit(10_000, 'ms', 'sessions', 'Time nodes have to say that modules ended.'),
  // LOCKSTEP_TIMEOUT_MS
  lockstepTimeoutMs: limit(
    500,
    'ms',
    'sessions',
    'Time within which a node must answer a lockstep pass.',
  ),

  // --- Time ---

  // SERVICE_TIMEOUT_MS
  serviceTimeoutMs: limit(
    8_000,
    'ms',
    'time',
    'Time to answer a service request. Shorter than the 10 s after which clients of ours give up.',
  ),
  headersTimeoutMs: limit(
    10_000,
    'ms',
    'time',
    'Time for the first request of a connection, including the TLS handshake, and for the headers of each further one. A phone at the edge of its Wi-Fi takes some seconds.',
  ),
  // REPLAY_DELAY_MS
  replayDelayMs: limit(
    25,
    'ms',
    'time',
    'Retained records reach an existing client this long after the reply. Existing browser and Node clients attach their callback some event-loop turns after they read the reply; without the delay they lost every third record.',
  ),
  // UNAVAILABLE_RETENTION_MS
  unavailableRetentionMs: limit(
    20 * 60_000,
    'ms',
    'time',
    'How long an unavailable client is remembered. A phone that sleeps during a break resumes as the same client.',
  ),

  // MAX_KEEP_MS
  keepMs: limit(
    60 * 60_000,
    'ms',
    'time',
    'How long a value may outlive its publisher. The values of a page survive its reload.',
  ),

  // --- Audit log ---

  auditEntries: limit(
    10_000,
    'entries',
    'storage',
    'Entries of the audit log that can be read. An entry takes some 300 bytes, 2 KiB at most; on disk there are at most twice as many.',
  ),
  auditEntriesPerSecond: limit(
    2,
    'entries/s',
    'rates',
    'Average rate of audit entries of one caller, with bursts of one minute of it. Further entries are counted, and the next entry names the number.',
  ),

  // --- Statistics ---

  keptRemovals: limit(
    10_000,
    'topics',
    'statistics',
    'Deleted topics remembered for readers of the statistics. Readers that ask less often get the full list.',
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
