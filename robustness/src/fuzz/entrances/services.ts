import { decode, SERVICES, toJson } from '@ubii/proto';

import type { Entrance, FuzzTarget } from '../entrance.ts';
import { mutateBytes } from '../mutate-bytes.ts';
import { mutateJson } from '../mutate-json.ts';
import { mutateWire } from '../mutate-wire.ts';
import { fromBase64, readSeeds } from '../seeds.ts';

const TIMEOUT_MS = 30_000;
const REQUEST = 'ubii.services.ServiceRequest';
/** Statuses with which a body may be turned away; everything else of a service is 200 [SV-7]. */
const TURNED_AWAY = new Set([200, 400, 401, 403, 408, 411, 413, 415, 429, 431, 503]);

/** Recorded requests, and one without a payload of every service. */
function requests(): Uint8Array[] {
  return fromBase64(readSeeds().requests);
}

function jsonSeeds(): Uint8Array[] {
  const recorded = requests().map((bytes) => toJson(REQUEST, decode(REQUEST, bytes)));
  const bare = Object.values(SERVICES).map(({ topic }) => ({ topic }));
  return [...recorded, ...bare].map((json) => utf8(JSON.stringify(json)));
}

export const json: Entrance = {
  name: 'json',
  about: 'service requests as JSON',
  kind: 'running',
  seeds: jsonSeeds,
  mutate(random, seed, other) {
    if (random.oneIn(4)) return mutateBytes(random, seed, other);
    const text = JSON.stringify(mutateJson(random, JSON.parse(Buffer.from(seed).toString())));
    return utf8(text ?? 'null');
  },
  deliver: (input, target) => post(input, target, '/services/json', 'application/json'),
};

export const binary: Entrance = {
  name: 'binary',
  about: 'service requests as protobuf',
  kind: 'running',
  seeds: requests,
  mutate: (random, seed, other) =>
    random.oneIn(4) ? mutateBytes(random, seed, other) : mutateWire(random, seed, other),
  deliver: (input, target) => post(input, target, '/services/binary', 'application/octet-stream'),
};

async function post(
  input: Uint8Array,
  { master }: FuzzTarget,
  path: string,
  contentType: string,
): Promise<void> {
  const response = await fetch(new URL(path, master.endpoints.url), {
    method: 'POST',
    headers: { 'content-type': contentType },
    body: Buffer.from(input),
    signal: AbortSignal.timeout(TIMEOUT_MS),
  });
  const body = new Uint8Array(await response.arrayBuffer());
  const text = Buffer.from(body).toString();
  if (!TURNED_AWAY.has(response.status)) {
    throw new Error(`The service answered with status ${response.status}: ${text.slice(0, 400)}`);
  }
  if (response.status !== 200) return;
  const isJson = response.headers.get('content-type')?.includes('json') ?? false;
  const reply = isJson
    ? (JSON.parse(text) as Record<string, unknown>)
    : decode('ubii.services.ServiceReply', body);
  const { error } = reply as { error?: { code?: string; message?: string } };
  if (error?.code === 'internal') {
    throw new Error(`The service answered with an internal error: ${error.message}`);
  }
}

function utf8(text: string): Uint8Array {
  return new Uint8Array(Buffer.from(text));
}
