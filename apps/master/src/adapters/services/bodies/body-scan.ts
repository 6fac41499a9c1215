import { JsonScan } from '@ubii/proto';
import { scanServiceRequest } from '@ubii/proto/wire';

import type { BodyLimits } from '../../../core/services/body-limits.ts';

/** Properties of a body that are known before decoding. */
export interface BodyScan {
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
