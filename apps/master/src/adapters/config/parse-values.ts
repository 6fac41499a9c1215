import { isIP } from 'node:net';
import { resolve } from 'node:path';

import type { LegacyPorts } from './legacy-ports.ts';
import { DEFAULT_LIMITS, type Limits } from '../../core/limits/index.ts';

/*
 * Each function reads one option's text and throws an Error whose message is what was expected, to
 * follow "must be".
 */

const PORT = 'a whole number from 0 to 65535';

export function parsePort(text: string): number {
  const port = /^\d{1,5}$/.test(text) ? Number(text) : Number.NaN;
  if (!(port <= 65535)) throw new Error(PORT);
  return port;
}

export function parseHost(text: string): string {
  const host = text.replace(/^\[(.*)\]$/, '$1');
  if (isIP(host) === 0 && !/^[a-z0-9]([a-z0-9._-]*[a-z0-9])?$/i.test(host)) {
    throw new Error('a host name or an IP address, without scheme and port');
  }
  return host.toLowerCase();
}

export function parseSwitch(text: string): boolean {
  if (/^(1|true|on|yes)$/i.test(text)) return true;
  if (/^(0|false|off|no|)$/i.test(text)) return false;
  throw new Error('true or false');
}

export function parseFilePath(text: string, baseDir: string): string {
  if (text === '') throw new Error('a path');
  return resolve(baseDir, text);
}

export function parseName(text: string): string {
  const name = text.trim();
  // eslint-disable-next-line no-control-regex -- names are lines that are drawn and logged
  if (name === '' || name.length > 100 || /[\u0000-\u001f\u007f]/.test(name)) {
    throw new Error('1 to 100 characters');
  }
  return name;
}

export function parseLegacyPorts(text: string): LegacyPorts | undefined {
  if (text === 'off' || text === 'false') return undefined;
  if (text === 'on' || text === 'true') return { services: 8102, topicData: 8104 };
  const match = /^(\d+),(\d+)$/.exec(text.replaceAll(' ', ''));
  try {
    return { services: parsePort(match?.[1] ?? ''), topicData: parsePort(match?.[2] ?? '') };
  } catch {
    throw new Error('on, off, or two ports separated by a comma, such as 8102,8104');
  }
}

export function parseOrigins(text: string): readonly string[] {
  const origins = text
    .split(',')
    .map((origin) => origin.trim().toLowerCase().replace(/\/$/, ''))
    .filter((origin) => origin !== '');
  if (origins.includes('null')) {
    throw new Error(
      'origins of pages, not "null": pages opened from files send it, and any website can. A page opened from a file uses a token of its own',
    );
  }
  const isOrigin = /^(\*|https?:\/\/(\*\.)?[a-z0-9._[\]:-]*?[a-z0-9\]](:(\d{1,5}|\*))?)$/;
  if (!origins.every((origin) => isOrigin.test(origin))) {
    throw new Error(
      'origins separated by commas, such as https://example.org or http://*.example.org:8080',
    );
  }
  return origins;
}

/** Addresses and CIDR blocks. */
export function parseNetworks(text: string): readonly string[] {
  const networks = text
    .split(',')
    .map((network) => network.trim().toLowerCase())
    .filter((network) => network !== '');
  const isNetwork = (network: string): boolean => {
    const [address = '', prefix, ...rest] = network.split('/');
    const bits = isIP(address) === 6 ? 128 : 32;
    const isPrefix = prefix === undefined || (/^\d{1,3}$/.test(prefix) && Number(prefix) <= bits);
    return isIP(address) !== 0 && isPrefix && rest.length === 0;
  };
  if (!networks.every(isNetwork)) {
    throw new Error('networks separated by commas, such as 192.168.1.0/24 or 10.0.0.7');
  }
  return networks;
}

/** Origins as they are, without wildcards: a request goes to one of them. */
export function parseFetchOrigins(text: string): readonly string[] {
  const origins = text
    .split(',')
    .map((origin) => origin.trim())
    .filter((origin) => origin !== '');
  return origins.map((origin) => {
    const url = URL.canParse(origin) ? new URL(origin) : undefined;
    if (url === undefined || !/^https?:$/.test(url.protocol) || url.pathname !== '/') {
      throw new Error('origins separated by commas, such as https://example.org');
    }
    return url.origin;
  });
}

/** An address with a slash at its end. */
export function parseMirror(text: string): string {
  const url = URL.canParse(text) ? new URL(text) : undefined;
  const isPlain = url !== undefined && url.search === '' && url.hash === '' && url.username === '';
  if (!isPlain || !/^https?:$/.test(url.protocol)) {
    throw new Error('an address, such as http://10.0.0.7/models/');
  }
  return url.href.endsWith('/') ? url.href : `${url.href}/`;
}

export function parsePercent(text: string): number {
  const percent = /^\d+(\.\d+)?$/.test(text) ? Number(text) : Number.NaN;
  if (!(percent >= 1 && percent <= 100)) throw new Error('a number from 1 to 100');
  return percent;
}

/** Any limit of the list, by its name, as a whole number above 0 in its own unit. */
export function parseLimits(text: string): Partial<Limits> {
  const pairs = text
    .split(',')
    .map((pair) => pair.trim())
    .filter((pair) => pair !== '');
  return Object.fromEntries(
    pairs.map((pair) => {
      const [, name = '', number = ''] = /^(\w+)\s*=\s*(\d{1,15})$/.exec(pair) ?? [];
      if (!Object.hasOwn(DEFAULT_LIMITS, name)) {
        throw new Error(`limits by name with a number, such as clients=20000, not "${pair}"`);
      }
      if (Number(number) === 0) throw new Error(`at least 1 for the limit ${name}`);
      return [name, Number(number)];
    }),
  );
}

export function parseChoice<const C extends string>(...choices: readonly C[]): (text: string) => C {
  return (text) => {
    const choice = choices.find((candidate) => candidate === text.toLowerCase());
    if (choice === undefined) throw new Error(choices.join(', ').replace(/, ([^,]*)$/, ' or $1'));
    return choice;
  };
}
