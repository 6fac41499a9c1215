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
    'Body of an ordinary service request. Sessions, modules and registrations may have half as much again as `sessionBytes` and `registrationBytesPerClient`, because JSON is longer than what is counted there.',
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
    'Values (texts, numbers, objects, lists) in an ordinary service request. Decoding costs by value.',
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
    'Objects and lists within each other in a JSON request. The deepest request of the protocol has 16.',
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
    'Name that something is found by: a session, module, component, input, output, muxer, data format. Refused when longer.',
  ),
  nameCharacters: limit(
    100,
    'characters',
    'texts',
    'Name of a client or device, label of an invitation, author. It stands in events, in the log and on pages. Names of clients and devices are cut.',
  ),
  tagCharacters: limit(100, 'characters', 'texts', 'One tag.'),
  textsPerList: limit(
    256,
    'texts',
    'texts',
    'Tags, authors or libraries of one thing. People give a handful.',
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
    'What a client says of its library, its address and the libraries of its node. Cut when longer.',
  ),
  userAgentCharacters: limit(
    256,
    'characters',
    'texts',
    'What a browser says of itself. Cut when longer.',
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
    'Lines of the log in the long run. At the start and after a quiet time as much as half a minute of it at once. What is more is left out and counted.',
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
    'Topics of one client: those it publishes on, and those it subscribes to before anybody publishes. Leaves half of all topics to the others.',
  ),
  topicsPerParticipant: limit(
    32_768,
    'topics',
    'storage',
    'The same of a participant that was invited. Three programs with 10 000 topics in one.',
  ),
  topicsPerPlayer: limit(
    256,
    'topics',
    'storage',
    'The same of a player or viewer. A phone with all its sensors has some twenty.',
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
    'Bytes of all retained records. Sixteen raw 4K images, and a machine with 2 GiB still has room.',
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
    'The same of a participant that was invited. Four raw 4K images.',
  ),
  retainedBytesPerPlayer: limit(
    32 * MIB,
    'bytes',
    'storage',
    'The same of a player or viewer. The camera of a phone at full resolution, once.',
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
  connections: limit(
    12_288,
    'connections',
    'storage',
    'Open connections to all ports. An eighth is kept for this machine. Lowered at the start to half of what the process may have open.',
  ),
  connectionsOfStrangers: limit(
    2_048,
    'connections',
    'storage',
    'The same of callers of whom nothing is known yet: all phones of a large room that load their page at once. At most half of all.',
  ),
  connectionsPerAddress: limit(
    512,
    'connections',
    'storage',
    'Connections from one address of another machine that are no sockets. A class of 60 phones behind one router loads its pages at once.',
  ),
  connectionsPerNetwork: limit(
    1_024,
    'connections',
    'storage',
    'The same of one IPv6 network of 64 bits, all of whose addresses one person may have.',
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
    'Devices of all clients. Two for each of as many clients as there may be.',
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
    'Encoded bytes of what one client registered: itself, its modules with their code, its devices.',
  ),
  registrationBytesPerPlayer: limit(
    256 * KIB,
    'bytes',
    'storage',
    'The same of a player or viewer. A phone with ten components registers some 3 KiB.',
  ),
  registrationBytes: limit(
    256 * MIB,
    'bytes',
    'storage',
    'Encoded bytes of what all clients registered.',
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
    'Regular expressions of one client. A new topic is tried against each.',
  ),
  patternsPerParticipant: limit(
    256,
    'expressions',
    'subscriptions',
    'The same of a participant that was invited. A program of ours has a handful.',
  ),
  patternsPerPlayer: limit(
    32,
    'expressions',
    'subscriptions',
    'The same of a player or viewer. Thirty phones of one invitation fit into its share of all.',
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
  profilesPerPlayer: limit(
    16,
    'profiles',
    'subscriptions',
    'The same of a player or viewer. Thirty phones of one invitation fit into its share of all.',
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
  announcementBytes: limit(
    8 * KIB,
    'bytes',
    'rates',
    'Registration that is announced as a whole whenever its client changes; of larger ones the name, the state and a number that says whether the rest has changed. A phone with twenty components registers some 6 KiB.',
  ),
  clientNewsBytesPerSecond: limit(
    8 * KIB,
    'bytes/s',
    'rates',
    'What is announced of one client in the long run, to each who listens; four times as much at once. What is more waits, and the last state is told.',
  ),
  sessionNewsBytesPerSecond: limit(
    1 * MIB,
    'bytes/s',
    'rates',
    'The same of changes of one session. A session of 50 KiB may change twenty times a second.',
  ),
  sessionStartBytesPerSecond: limit(
    1 * MIB,
    'bytes/s',
    'rates',
    'Sessions that callers of one invitation start in the long run; 32 times as much at once. Everybody who listens is sent a session when it starts, when it runs and when it stops.',
  ),

  wrongCodesPerAddress: limit(
    10,
    'codes/s',
    'rates',
    'Wrong join codes from one address. Somebody who shares it with an attacker gets in with a try or a few; one address guesses a code of 12 hours with a chance of 4 in 10 million.',
  ),
  wrongCodesPerNetwork: limit(
    20,
    'codes/s',
    'rates',
    'The same of one IPv6 network of 64 bits: one address in it leaves half to the others.',
  ),
  wrongCodes: limit(
    200,
    'codes/s',
    'rates',
    'The same of all addresses together. A code stands for 12 hours at most: 9 million tries at 10^12 codes.',
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
  queuesBytes: limit(
    512 * MIB,
    'bytes',
    'queues',
    'The same of all queues together. A client that would add to more drops its own oldest records.',
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

  // --- Bodies of service requests that are being received or decoded ---

  bodyBytes: limit(
    128 * MIB,
    'bytes',
    'queues',
    'Bytes of all service requests in flight. This machine may have three quarters of it, and so may all others.',
  ),
  bodyBytesOfStrangers: limit(
    4 * MIB,
    'bytes',
    'queues',
    'The same of all callers that have not joined: 256 of the largest requests.',
  ),
  bodyBytesOfJoining: limit(
    16 * MIB,
    'bytes',
    'queues',
    'The same of all callers with a token or code that are not registered yet.',
  ),
  bodyBytesPerAddress: limit(
    2 * MIB,
    'bytes',
    'queues',
    'The same of those two kinds of callers, from one address. A class of 60 phones behind one router registers at once.',
  ),
  bodyBytesPerClient: limit(
    24 * MIB,
    'bytes',
    'queues',
    'The same of one client, or of one address that is let in without a token. Two of the largest sessions.',
  ),
  bodyBytesPerConnection: limit(
    16 * MIB,
    'bytes',
    'queues',
    'The same of one connection. Existing clients send one request after another.',
  ),
  bodyGraceMs: limit(
    10_000,
    'ms',
    'time',
    'Time after which a body has to have come at `bodyBytesPerSecond`. A small one has to be there by then.',
  ),
  bodyBytesPerSecond: limit(
    32 * KIB,
    'bytes/s',
    'rates',
    'Slowest body of a service request. A mobile network with one bar has several times as much.',
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
  moduleBytes: limit(
    2_048 * MIB,
    'bytes',
    'sessions',
    "Memory of all sandboxed modules on the master. Unless set, the program takes a quarter of the machine's, or of its container's, at least 256 MiB. A module that keeps nothing takes less than one.",
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
  headersTimeoutMs: limit(
    10_000,
    'ms',
    'time',
    'The first request of a connection, its TLS handshake included, and the headers of each further one. A phone at the edge of its Wi-Fi takes some seconds.',
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

  // MAX_KEEP_MS
  keepMs: limit(
    60 * 60_000,
    'ms',
    'time',
    'How long a value may outlive its publisher. A person can reload the page, or go and come back, and finds the value that was set.',
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
    'Entries of one caller in the long run, and a minute of them at once. What is more is counted, and the next entry says how many.',
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
