/** Data that a master announces in the local network. [DI-2] */
export interface Announcement {
  /** Name of the master, as people see it. */
  readonly name: string;
  /** Another one for each run. */
  readonly id: string;
  /** Semantic version of the master. */
  readonly version: string;
  /** Port of pages, services and topic data. */
  readonly port: number;
  /** Whether that port takes HTTPS as well as HTTP. */
  readonly https: boolean;
  /** Ports on which existing clients find services and topic data; they may be `port`. */
  readonly servicesPort: number;
  readonly topicDataPort: number;
}

/** The type of service: `_ubii._tcp`. [DI-1] */
export const SERVICE_TYPE = 'ubii';

/** Version of what the TXT record holds (RFC 6763, section 6.7). */
const TXT_VERSION = '1';

/** The TXT record. Keys have at most nine characters, as RFC 6763 wants. */
export function toTxt(announcement: Announcement): Record<string, string> {
  const { name, id, version, https, servicesPort, topicDataPort } = announcement;
  return {
    txtvers: TXT_VERSION,
    version,
    id,
    name: cutToBytes(name, MAX_TXT_VALUE_BYTES),
    https: https ? 'on' : 'off',
    services: String(servicesPort),
    topicdata: String(topicDataPort),
  };
}

/**
 * Reads what another program says it is: nothing of it can be trusted.
 * @returns undefined when it is not what a master says
 */
export function fromTxt(
  txt: Readonly<Record<string, unknown>> | undefined,
  port: number,
): Announcement | undefined {
  const text = (key: string): string => {
    const value = txt?.[key];
    // eslint-disable-next-line no-control-regex -- what a network tells is logged and listed
    return typeof value === 'string' ? value.replace(/[\u0000-\u001f\u007f]/g, '') : '';
  };
  const number = (key: string): number => (isPort(Number(text(key))) ? Number(text(key)) : port);
  const id = text('id');
  if (id === '' || !isPort(port)) return undefined;
  return {
    name: text('name'),
    id,
    version: text('version'),
    port,
    https: text('https') === 'on',
    servicesPort: number('services'),
    topicDataPort: number('topicdata'),
  };
}

/** A key and its value have 255 bytes together. */
const MAX_TXT_VALUE_BYTES = 200;
/** A label of DNS. */
const MAX_LABEL_BYTES = 63;

/**
 * The name of the service instance: that of the master, with a number when others have it. [DI-3]
 * @param attempt 1 for the first
 */
export function instanceName(name: string, attempt: number): string {
  const suffix = attempt === 1 ? '' : ` (${attempt})`;
  // The library takes a dot for the end of a label.
  return `${cutToBytes(name.replaceAll('.', '-'), MAX_LABEL_BYTES - suffix.length)}${suffix}`;
}

function cutToBytes(text: string, bytes: number): string {
  let cut = text;
  while (new TextEncoder().encode(cut).length > bytes) cut = [...cut].slice(0, -1).join('');
  return cut;
}

function isPort(port: number): boolean {
  return Number.isInteger(port) && port > 0 && port < 65_536;
}
