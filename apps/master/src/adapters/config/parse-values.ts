import { isIP } from 'node:net';
import { parseList, parseWholeNumber } from '@ubii/program';

import { ORIGINAL_PORTS, ORIGINAL_ZEROMQ_PORTS, type LegacyPorts } from './legacy-ports.ts';
import { DEFAULT_LIMITS, type Limits } from '../../core/limits/index.ts';

/*
 * Each function reads one option's text and throws an Error whose message is what was expected, to
 * follow "must be".
 */

/** 0: any free port. */
export const parsePort = parseWholeNumber(0, 65_535);

export function parseHost(text: string): string {
  const host = text.replace(/^\[(.*)\]$/, '$1');
  if (isIP(host) === 0 && !/^[a-z0-9]([a-z0-9._-]*[a-z0-9])?$/i.test(host)) {
    throw new Error('a hostname or an IP address, without scheme and port');
  }
  return host.toLowerCase();
}

export const parseLegacyPorts = parsePortPair(ORIGINAL_PORTS);
export const parseZeroMqPorts = parsePortPair(ORIGINAL_ZEROMQ_PORTS);

function parsePortPair(original: LegacyPorts): (text: string) => LegacyPorts | undefined {
  return (text) => {
    if (text === 'off' || text === 'false') return undefined;
    if (text === 'on' || text === 'true') return original;
    return readPortPair(text, original);
  };
}

function readPortPair(text: string, original: LegacyPorts): LegacyPorts {
  const match = /^(\d+),(\d+)$/.exec(text.replaceAll(' ', ''));
  try {
    return { services: parsePort(match?.[1] ?? ''), topicData: parsePort(match?.[2] ?? '') };
  } catch {
    const example = `${original.services},${original.topicData}`;
    throw new Error(`on, off, or two ports separated by a comma, such as ${example}`);
  }
}

/** Minutes, up to an hour; undefined for off. */
export function parseFlightMinutes(text: string): number | undefined {
  if (text === 'off' || text === 'false' || text === '0') return undefined;
  const minutes = Number(text);
  if (minutes > 0 && minutes <= 60) return minutes;
  throw new Error('off, or a number of minutes up to 60');
}

export function parseOrigins(text: string): readonly string[] {
  const origins = parseList(text.toLowerCase()).map((origin) => origin.replace(/\/$/, ''));
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
  const networks = parseList(text.toLowerCase());
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

/** An origin. */
export function parsePublicUrl(text: string): string {
  const url = URL.canParse(text) ? new URL(text) : undefined;
  const isOrigin = url !== undefined && `${url.origin}/` === url.href;
  if (!isOrigin || !/^https?:$/.test(url.protocol)) {
    throw new Error('an address without a path, such as https://ubii.example.org');
  }
  return url.origin;
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

/** Any limit of the list, by its name, as a whole number above 0 in its own unit. */
export function parseLimits(text: string): Partial<Limits> {
  return Object.fromEntries(
    parseList(text).map((pair) => {
      const [, name = '', number = ''] = /^(\w+)\s*=\s*(\d{1,15})$/.exec(pair) ?? [];
      if (!Object.hasOwn(DEFAULT_LIMITS, name)) {
        throw new Error(`limits by name with a number, such as clients=20000, not "${pair}"`);
      }
      if (Number(number) === 0) throw new Error(`at least 1 for the limit ${name}`);
      return [name, Number(number)];
    }),
  );
}
