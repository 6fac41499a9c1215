import type { Readable } from 'node:stream';
import { JsonScan, ServiceError } from '@ubii/proto';
import { scanServiceRequest } from '@ubii/proto/wire';
import type { Clock } from '@ubii/timing';
import type { BodyLimits } from '../../../core/services/body-limits.ts';
import type { IncomingRequest } from '../../../core/services/incoming-request.ts';

/** Properties of a body that are known before decoding. */
interface BodyScan {
  /** Topic of the request; undefined while it was not found. */
  readonly topic: string | undefined;
  /** Values found so far, never less than decoding makes of them. */
  readonly values: number;
  /** Number of bytes scanned. */
  readonly pos: number;
  /**
   * Looks at what has come.
   *
   * @param bytes the body from its beginning
   * @param end first byte that has not come yet
   * @returns what there is too much of
   * @throws DecodeError when it is no request
   */
  scan(
    bytes: Uint8Array,
    end: number,
    limits: BodyLimits,
    isComplete: boolean,
  ): 'depth' | 'values' | undefined;
}

/** Scans JSON as it comes. [SV-43] */
export class JsonBodyScan implements BodyScan {
  readonly #scan = new JsonScan('topic');
  readonly #maxDepth: number;

  constructor(maxDepth: number) {
    this.#maxDepth = maxDepth;
  }

  get topic(): string | undefined {
    return this.#scan.text;
  }

  get values(): number {
    return this.#scan.values;
  }

  get pos(): number {
    return this.#scan.pos;
  }

  scan(bytes: Uint8Array, end: number, { values }: BodyLimits): 'depth' | 'values' | undefined {
    return this.#scan.scan(bytes, end, { depth: this.#maxDepth, values });
  }
}

/** Scans protobuf once it is complete: that costs by value, not by byte. [SV-43] */
export class BinaryBodyScan implements BodyScan {
  topic: string | undefined;
  values = 0;
  pos = 0;

  scan(
    bytes: Uint8Array,
    end: number,
    limits: BodyLimits,
    isComplete: boolean,
  ): 'values' | undefined {
    if (!isComplete) return undefined;
    const { topic, values, excessAt } = scanServiceRequest(bytes.subarray(0, end), limits.values);
    this.topic = topic === '' ? undefined : topic;
    this.values = values;
    this.pos = excessAt ?? end;
    return excessAt === undefined ? undefined : 'values';
  }
}

/** Bytes charged for any request: a request without a body takes memory, too. */
const MIN_BYTES = 512;
/** Room that a body of unknown length begins with, bytes. */
const FIRST_BYTES = 4 * 1024;

/** A body without topic is decoded up to this size, bytes: it may be broken, and the error says where. */
const SMALL_BYTES = 64 * 1024;

/** So much of one body is scanned before others get their turn, bytes. */
const TURN_BYTES = 256 * 1024;

/** Minimum transfer rate of bodies. [SV-47] */
interface BodyPace {
  readonly clock: Clock;
  readonly bodyGraceMs: number;
  readonly bodyBytesPerSecond: number;
}

/** A body that is about to come. */
interface ComingBody {
  readonly stream: Readable;
  /** Its length as its sender says it; undefined when it does not. */
  readonly declaredBytes: number | undefined;
}

/** A body that has come. */
export interface ReceivedBody {
  readonly bytes: Uint8Array<ArrayBuffer>;
  readonly topic: string;
  /** Never less than the values that decoding makes. */
  readonly values: number;
}

/** A request that is refused whatever its payload is, of which no more was read than its topic. */
interface RefusedBody {
  readonly bytes: undefined;
  readonly topic: string;
}

/**
 * Reads the body of a request within the limits of its caller and service. Room is taken before bytes
 * are kept: for the declared length at once, for an unknown one as it grows. Each chunk is scanned as
 * it comes, and others get their turn in between, so that nothing waits for the scan of a whole body.
 * [SV-40, SV-42, SV-43, SV-46, SV-47]
 *
 * @throws ServiceError when it is too much, too slow, or when the sender breaks off; what has not
 *   been read is left in the stream
 */
export function receiveBody(
  { stream, declaredBytes: declared }: ComingBody,
  incoming: IncomingRequest,
  scan: BodyScan,
  pace: BodyPace,
): Promise<ReceivedBody | RefusedBody> {
  const { largest } = incoming;
  if (declared !== undefined && declared > largest.bytes) {
    throw incoming.tooManyBytes(largest, `${declared}`);
  }
  incoming.reserve(Math.max(MIN_BYTES, declared ?? FIRST_BYTES));
  return new Promise((resolve, reject) => {
    // Memory of its own, which a worker may be given.
    let bytes = new Uint8Array(declared ?? FIRST_BYTES);
    let size = 0;
    let turnEnd = TURN_BYTES;
    let nextTurn: NodeJS.Immediate | undefined;
    let topic: string | undefined;
    let limits: BodyLimits = largest;
    const stopWatching = watchPace(pace, incoming, () => size, end);

    function end(error?: ServiceError, body?: ReceivedBody | RefusedBody): void {
      stopWatching();
      clearImmediate(nextTurn);
      stream.off('data', handleData).off('end', handleEnd);
      stream.off('error', breakOff).off('close', breakOff);
      // Without a listener, an error would be thrown.
      stream.on('error', () => undefined);
      stream.pause();
      if (body === undefined) reject(error ?? brokenOff());
      else resolve(body);
    }

    /** Looks up the limits of the service as soon as its topic was found. @returns the request is refused anyway */
    function isRefused(isComplete: boolean): boolean {
      if (scan.topic === topic && !isComplete) return false;
      topic = scan.topic;
      // Small enough to say what else is wrong with it.
      if (topic === undefined) return isComplete && size > SMALL_BYTES;
      const ofService = incoming.limitsOf(topic);
      if (ofService === undefined) return true;
      limits = ofService;
      return false;
    }

    function check(isComplete: boolean): boolean {
      const excess = scan.scan(bytes, size, limits, isComplete);
      if (isRefused(isComplete)) {
        end(undefined, { bytes: undefined, topic: topic ?? '' });
        return false;
      }
      const least = Math.max(size, declared ?? 0);
      if (least > limits.bytes) end(incoming.tooManyBytes(limits, `${least}`));
      else if (excess === 'depth') end(incoming.tooDeep(scan.pos));
      else if (excess === 'values' || scan.values > limits.values) {
        end(incoming.tooManyValues(limits, scan.pos));
      } else return true;
      return false;
    }

    function handleData(chunk: Buffer): void {
      try {
        if (size + chunk.length > bytes.length) grow(size + chunk.length);
        bytes.set(chunk, size);
        size += chunk.length;
        if (check(false) && size >= turnEnd) giveWay();
      } catch (error) {
        end(ServiceError.from(error));
      }
    }

    function giveWay(): void {
      turnEnd = size + TURN_BYTES;
      stream.pause();
      nextTurn = setImmediate(() => stream.resume());
    }

    function grow(least: number): void {
      if (least > limits.bytes) throw incoming.tooManyBytes(limits, `more`);
      const length = Math.min(limits.bytes, Math.max(least, 2 * bytes.length));
      incoming.reserve(length);
      const larger = new Uint8Array(length);
      larger.set(bytes.subarray(0, size));
      bytes = larger;
    }

    function handleEnd(): void {
      try {
        if (!check(true)) return;
        const whole = size === bytes.length ? bytes : bytes.slice(0, size);
        end(undefined, { bytes: whole, topic: topic ?? '', values: scan.values });
      } catch (error) {
        end(ServiceError.from(error));
      }
    }

    function breakOff(): void {
      end(brokenOff());
    }

    stream.on('data', handleData).on('end', handleEnd);
    stream.on('error', breakOff).on('close', breakOff);
  });
}

/** Ends a body that comes too slowly. @returns ends the watch */
function watchPace(
  { clock, bodyGraceMs, bodyBytesPerSecond }: BodyPace,
  incoming: IncomingRequest,
  size: () => number,
  end: (error: ServiceError) => void,
): () => void {
  const startMs = clock.monotonicMs();
  const look = (): void => {
    const pastMs = clock.monotonicMs() - startMs;
    if (size() < (bodyBytesPerSecond * (pastMs - bodyGraceMs)) / 1_000 + 1) {
      end(incoming.tooSlow(size(), Math.ceil(pastMs / 1_000)));
    } else cancel = clock.after(bodyGraceMs, look);
  };
  let cancel = clock.after(bodyGraceMs, look);
  return () => cancel();
}

function brokenOff(): ServiceError {
  return new ServiceError('invalid_argument', 'The request ended before its body was complete.');
}
