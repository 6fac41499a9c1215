/** Facts of a stream for its header. */
export interface StreamFacts {
  readonly name: string;
  /** Such as `vector3` or `Markers`. */
  readonly type: string;
  readonly channels: readonly string[];
  readonly format: 'double64' | 'string';
  /** Who published: identifies the stream in other recordings. */
  readonly sourceId: string;
  readonly host: string;
}

/** Header of a stream as programs of the Lab Streaming Layer write it; irregular rate. */
export function headerXml({ name, type, channels, format, sourceId, host }: StreamFacts): string {
  const labels = channels.map((label) => `<channel>${element('label', label)}</channel>`);
  return info(
    element('name', name) +
      element('type', type) +
      element('channel_count', String(channels.length)) +
      element('nominal_srate', '0') +
      element('channel_format', format) +
      element('source_id', sourceId) +
      element('hostname', host) +
      `<desc><channels>${labels.join('')}</channels></desc>`,
  );
}

/** @param first @param last times of the samples, seconds */
export function footerXml(first: number, last: number, count: number): string {
  return info(
    element('first_timestamp', String(first)) +
      element('last_timestamp', String(last)) +
      element('sample_count', String(count)),
  );
}

function info(content: string): string {
  return `<?xml version="1.0"?><info>${content}</info>`;
}

function element(name: string, content: string): string {
  return `<${name}>${escaped(content)}</${name}>`;
}

const ENTITIES: Readonly<Record<string, string>> = { '&': '&amp;', '<': '&lt;', '>': '&gt;' };

/** Characters that XML 1.0 does not have, such as control characters, are left out. */
function escaped(content: string): string {
  return content
    .replace(/[^\t\n\r\u0020-\uD7FF\uE000-\uFFFD\u{10000}-\u{10FFFF}]/gu, '')
    .replace(/[&<>]/g, (character) => ENTITIES[character]!);
}
