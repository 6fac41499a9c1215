import type { MessagePort } from 'node:worker_threads';
import type { FormatName } from '../service-format.ts';

/** Initial data of the decoding thread. */
export interface DecodeThreadData {
  /** Receives the `MessagePiece`s of a request. */
  readonly pieces: MessagePort;
}

/** What is called of the decoding thread. */
export interface DecodeThread {
  /**
   * Resolves when all pieces of the request were sent.
   *
   * @throws {Error} why the body could not be decoded, a sentence without its full stop
   */
  decode(format: FormatName, bytes: Uint8Array<ArrayBuffer>): void;
}

/**
 * A part of a message on its way from one thread to another. Taking a message in one piece would hold
 * the thread for as long as the message is large; pieces can be taken with turns in between. [SV-44]
 */
export interface MessagePiece {
  /** Container to put into, by the order in which containers were opened; 0 is the message itself. */
  readonly into: number;
  readonly keys: readonly (string | number)[];
  readonly values: readonly unknown[];
  /** The container that is opened at the key, after `values`; undefined: none. */
  readonly open?: { readonly key: string | number; readonly isList: boolean };
}

/** Values in one piece. */
const PIECE_WEIGHT = 1_024;
/** Characters that weigh as much as one value: copying a text costs by its length. */
const TEXT_PER_WEIGHT = 256;

/** Splits a decoded message. `bytes` members are copied, so that a piece carries nothing else of what they are views of. */
export function splitMessage(message: object): MessagePiece[] {
  const weights = new Map<object, number>();
  weigh(message, weights);
  const pieces: MessagePiece[] = [];
  let opened = 0;
  const emit = (container: object, into: number): void => {
    let keys: (string | number)[] = [];
    let values: unknown[] = [];
    let weight = 0;
    const flush = (open?: MessagePiece['open']): void => {
      if (keys.length > 0 || open !== undefined)
        pieces.push({ into, keys, values, ...(open && { open }) });
      keys = [];
      values = [];
      weight = 0;
    };
    for (const [name, value] of Object.entries(container) as [string, unknown][]) {
      const key = Array.isArray(container) ? Number(name) : name;
      if (typeof value === 'object' && value !== null && weights.has(value)) {
        flush({ key, isList: Array.isArray(value) });
        emit(value, ++opened);
        continue;
      }
      keys.push(key);
      values.push(value instanceof Uint8Array ? value.slice() : value);
      weight += weigh(value, weights);
      if (weight > PIECE_WEIGHT) flush();
    }
    flush();
  };
  emit(message, 0);
  return pieces;
}

/** Puts a message together again. */
export class JoinedMessage {
  readonly message: Record<string, unknown> = {};
  readonly #containers: Record<string | number, unknown>[] = [this.message];

  add({ into, keys, values, open }: MessagePiece): void {
    const container = this.#containers[into]!;
    keys.forEach((key, i) => (container[key] = values[i]));
    if (open === undefined) return;
    const opened = (open.isList ? [] : {}) as Record<string | number, unknown>;
    container[open.key] = opened;
    this.#containers.push(opened);
  }
}

/** Returns the cost of adding a value; records containers that are too large for a piece. */
function weigh(value: unknown, large: Map<object, number>): number {
  if (typeof value === 'string') return 1 + value.length / TEXT_PER_WEIGHT;
  if (typeof value !== 'object' || value === null) return 1;
  if (value instanceof Uint8Array) return 1 + value.length / TEXT_PER_WEIGHT;
  const known = large.get(value);
  if (known !== undefined) return known;
  let weight = 1;
  for (const each of Object.values(value) as unknown[]) weight += weigh(each, large);
  if (weight > PIECE_WEIGHT) large.set(value, weight);
  return weight;
}
