import { decode, encode } from 'node-osc';
import type { OscArgument, OscContent } from './osc-codec.ts';

/** Most that a datagram may have over UDP and IPv4, bytes. */
export const MAX_DATAGRAM_BYTES = 65_507;
const MAX_MESSAGES = 1_000;
const MAX_DEPTH = 8;

/** Characters that patterns of OSC have, and addresses have not (OSC 1.0, "OSC Address Spaces"). */
const NOT_IN_ADDRESS = /[ #*,?[\]{}]|[^\x21-\x7e]/;

/** A message with its address. */
export interface OscMessage extends OscContent {
  readonly address: string;
}

interface Decoded {
  readonly oscType?: unknown;
  readonly address?: unknown;
  readonly args?: readonly { readonly value?: unknown }[];
  readonly elements?: readonly Decoded[];
  readonly timetag?: unknown;
}

/** Returns why no message can have this address; `undefined` when one can. */
export function addressProblem(address: string): string | undefined {
  if (!address.startsWith('/')) return `The address ${address} does not begin with "/".`;
  return NOT_IN_ADDRESS.test(address.replaceAll('/', ''))
    ? `The address ${address} has characters that OSC does not allow.`
    : undefined;
}

/**
 * Reads a datagram: a message, or a bundle with messages and bundles, whose time tag they get.
 *
 * @throws Error with the reason
 */
export function decodeOsc(bytes: Buffer): readonly OscMessage[] {
  const messages: OscMessage[] = [];
  collect(decode(bytes) as Decoded, undefined, 0, messages);
  return messages;
}

function collect(
  packet: Decoded,
  timestampMs: number | undefined,
  depth: number,
  messages: OscMessage[],
): void {
  if (depth > MAX_DEPTH) throw new Error(`Bundles are nested more than ${MAX_DEPTH} times.`);
  if (packet.oscType === 'bundle') {
    // Unix seconds; 0 means at once.
    const seconds = Number(packet.timetag ?? 0);
    const time = seconds > 0 ? Math.round(seconds * 1_000) : timestampMs;
    for (const element of packet.elements ?? []) collect(element, time, depth + 1, messages);
    return;
  }
  if (messages.length >= MAX_MESSAGES) {
    throw new Error(`The bundle has more than ${MAX_MESSAGES} messages.`);
  }
  const address = String(packet.address);
  const problem = addressProblem(address);
  if (problem !== undefined) throw new Error(problem);
  messages.push({ address, timestampMs, args: (packet.args ?? []).map(readArgument) });
}

/** The library tells the value of an argument, and not its type. */
function readArgument({ value }: { readonly value?: unknown }): OscArgument {
  if (typeof value === 'number') return { type: Number.isInteger(value) ? 'i' : 'f', value };
  if (typeof value === 'string') return { type: 's', value };
  if (typeof value === 'boolean') return { type: value ? 'T' : 'F', value };
  // The bytes are a view of the datagram, whose buffer is used again.
  if (value instanceof Uint8Array) return { type: 'b', value: Uint8Array.from(value) };
  return { type: 'N', value: null };
}

/** Encodes a message, in a bundle when it has a time. */
export function encodeOsc({ address, args, timestampMs }: OscMessage): Buffer {
  const message = {
    oscType: 'message',
    address,
    args: args.map(({ type, value }) => ({
      type,
      value: value instanceof Uint8Array ? Buffer.from(value) : value,
    })),
  };
  if (timestampMs === undefined) return encode(message);
  return encode({ oscType: 'bundle', timetag: timestampMs / 1_000, elements: [message] });
}
