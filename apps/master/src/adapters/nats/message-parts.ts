/** One part of a message that is larger than NATS takes at once. [CU-52] */
export interface PartFacts {
  /** Number of the message among those of its sender. */
  readonly message: number;
  /** Position of this part in the message, bytes. */
  readonly offset: number;
  /** Bytes of the whole message. */
  readonly totalBytes: number;
}

/** Messages that may be incomplete at once, over all senders, as a multiple of the largest message. */
const MAX_JOINED = 4;

export function formatPart({ message, offset, totalBytes }: PartFacts): string {
  return `${message} ${offset} ${totalBytes}`;
}

/** @returns undefined for a text that no master writes */
export function parsePart(text: string): PartFacts | undefined {
  const match = /^(\d{1,15}) (\d{1,10}) (\d{1,10})$/.exec(text);
  if (match === null) return undefined;
  return { message: Number(match[1]), offset: Number(match[2]), totalBytes: Number(match[3]) };
}

interface Incomplete {
  readonly message: number;
  readonly bytes: Uint8Array;
  /** Bytes that have come. */
  length: number;
}

/** Joins the parts of messages. The parts of one sender come in order; one that is missing costs its message only. */
export class PartJoiner {
  readonly #maxBytes: number;
  /** The one message of each sender that is incomplete, oldest first. */
  readonly #incomplete = new Map<string, Incomplete>();
  #heldBytes = 0;

  /** @param maxBytes of one message; larger ones are dropped */
  constructor(maxBytes: number) {
    this.#maxBytes = maxBytes;
  }

  /** Bytes that are held for incomplete messages. */
  get heldBytes(): number {
    return this.#heldBytes;
  }

  /** @returns the whole message with its last part, else undefined */
  add(sender: string, facts: PartFacts, part: Uint8Array): Uint8Array | undefined {
    const message = facts.offset === 0 ? this.#begin(sender, facts) : this.#incomplete.get(sender);
    if (message === undefined) return undefined;
    const isNext =
      message.message === facts.message &&
      message.length === facts.offset &&
      message.bytes.byteLength === facts.totalBytes &&
      part.byteLength <= facts.totalBytes - facts.offset;
    if (!isNext) {
      this.drop(sender);
      return undefined;
    }
    message.bytes.set(part, facts.offset);
    message.length += part.byteLength;
    if (message.length < facts.totalBytes) return undefined;
    this.drop(sender);
    return message.bytes;
  }

  /** Forgets what has come of an incomplete message: the sender has begun another one, or is gone. */
  drop(sender: string): void {
    const message = this.#incomplete.get(sender);
    if (message === undefined) return;
    this.#incomplete.delete(sender);
    this.#heldBytes -= message.bytes.byteLength;
  }

  #begin(sender: string, { message, totalBytes }: PartFacts): Incomplete | undefined {
    this.drop(sender);
    if (totalBytes > this.#maxBytes) return undefined;
    for (const oldest of this.#incomplete.keys()) {
      if (this.#heldBytes + totalBytes <= this.#maxBytes * MAX_JOINED) break;
      this.drop(oldest);
    }
    // Every byte is written before the message is handed on.
    const begun = { message, bytes: Buffer.allocUnsafeSlow(totalBytes), length: 0 };
    this.#incomplete.set(sender, begun);
    this.#heldBytes += totalBytes;
    return begun;
  }
}
