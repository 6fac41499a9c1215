/** Topics on which the master announces what happens. Each carries the whole thing. */
export const INFO_TOPICS = {
  newProcessingModule: '/info/processing_module/new',
  startProcessingModule: '/info/processing_module/start',
  deleteProcessingModule: '/info/processing_module/delete',
  changeProcessingModule: '/info/processing_module/change',
  processedProcessingModule: '/info/processing_module/processed',
  newSession: '/info/session/new',
  deleteSession: '/info/session/delete',
  changeSession: '/info/session/change',
  startSession: '/info/session/start',
  stopSession: '/info/session/stop',
  runningSession: '/info/session/running',
  newDevice: '/info/device/new',
  deleteDevice: '/info/device/delete',
} as const;

/** Everything below is published by the master only. [TD-16] */
const INFO_PREFIX = '/info/';
/** Everything below is ours: an original client never sees it. [TD-26] */
const EXTENSION_PREFIX = '/ubii/';
/** Everything below is a service of ours. [EX] */
export const EXTENSION_SERVICE_PREFIX = '/services/ubii/';

/** Source of a regular expression for a UUID of any version, lower or upper case. */
export const UUID_PATTERN = '[0-9a-fA-F]{8}(?:-[0-9a-fA-F]{4}){3}-[0-9a-fA-F]{12}';
// eslint-disable-next-line ubii/no-native-patterns -- our own pattern, linear
const UUID = new RegExp(`^${UUID_PATTERN}$`);

/** True for the text of a UUID of any version. */
export function isUuid(text: string): boolean {
  return UUID.test(text);
}

/** True when only the master may publish on the topic, with or without leading slash. [TD-16] */
export function isMasterTopic(topic: string): boolean {
  const path = topic.startsWith('/') ? topic : `/${topic}`;
  return path.startsWith(INFO_PREFIX) || path.startsWith(EXTENSION_PREFIX);
}

/** True for a topic that only extension clients receive. [TD-26] */
export function isExtensionTopic(topic: string): boolean {
  return topic.startsWith(EXTENSION_PREFIX);
}

/** The topic on which a client is announced whenever it changes. [CL-31] */
export function clientTopic(clientId: string): string {
  return `${EXTENSION_PREFIX}client/${clientId}`;
}

/** The topic on which a page that joined says what its preflight found, as JSON. [AC-30] */
export function preflightTopic(clientId: string): string {
  return `/${clientId}/preflight`;
}

/**
 * Where a controller says that it is gone, by a string with the id of its client: games take its player away.
 * Existing programs know it without a slash in front. [AC-24]
 */
export const FAREWELL_TOPIC = 'removeClient';

/**
 * The topic of a request to identify the device of a client: a string with the name of the requesting client.
 * Any client may publish there; a client with a screen, sound or vibration subscribes to its own topic. [EX-34]
 */
export function identifyTopic(clientId: string): string {
  return `/${clientId}/identify`;
}

/** The topic on which the master publishes how a running session does, a few times a second. [SE-50] */
export function sessionStatisticsTopic(sessionId: string): string {
  return `${EXTENSION_PREFIX}session/${sessionId}/statistics`;
}

/** The topic of what the modules of a session do: errors, log lines, restarts. [SE-51] */
export function moduleEventTopic(sessionId: string): string {
  return `${EXTENSION_PREFIX}session/${sessionId}/events`;
}

/**
 * The topic on which a master names the others of its cluster: a stringList with their addresses, of each the best
 * first. [CU-26]
 */
export const MASTERS_TOPIC = `${EXTENSION_PREFIX}masters`;

/** The topic on which the master says what is recorded, about once a second. [RC-8] */
export const RECORDING_STATUS_TOPIC = `${EXTENSION_PREFIX}recordings`;

/** The topic on which the master says what is replayed, up to five times a second. [RP-7] */
export const REPLAYS_TOPIC = `${EXTENSION_PREFIX}replays`;
/** The topic on which the master tells of open runs and check lists of studies. [ST-40] */
export const STUDY_STATUS_TOPIC = `${EXTENSION_PREFIX}studies`;

/**
 * The topic a component publishes on by convention: `/<client id>/<device>/<component>`.
 *
 * @param deviceName may contain anything; slashes add levels
 */
export function componentTopic(
  clientId: string,
  deviceName: string,
  componentName: string,
): string {
  return `/${clientId}/${deviceName}/${componentName}`;
}

/**
 * Turns a glob into the source of a regular expression that matches whole topics: `*` is any text
 * within one level, `**` any text, `?` one character within a level; all else means itself.
 * The source is understood by RE2 as well as by JavaScript. [TD-21]
 */
export function globToRegExpSource(glob: string): string {
  const body = glob.replace(/\*\*|[*?]|[\\^$.|+()[\]{}]/g, (token) => {
    if (token === '**') return '.*';
    if (token === '*') return '[^/]*';
    if (token === '?') return '[^/]';
    return `\\${token}`;
  });
  return `^${body}$`;
}
