import {
  DiscardPolicy,
  JetStreamApiCodes,
  JetStreamApiError,
  jetstream,
  RetentionPolicy,
  StorageType,
  type JetStreamClient,
  type JetStreamManager,
} from '@nats-io/jetstream';
import { Empty, errors, headers } from '@nats-io/transport-node';
import { ServiceError } from '@ubii/proto';

import { isConflict, isNotFound } from './explain-nats-error.ts';
import type { NatsLink } from './nats-link.ts';

/** NATS answers within milliseconds, or is busy with itself, milliseconds. */
const ANSWER_MS = 3_000;
/** Bytes that NATS needs besides a value. */
const ENVELOPE_BYTES = 512;
/** Newest value only, as documents have no history of their own. */
const HISTORY = 1;

/** The value of a key, or that it was deleted. */
export interface KvEntry {
  /** Grows with each change of the bucket. */
  readonly revision: number;
  /** undefined: the key was deleted. */
  readonly value: Uint8Array | undefined;
}

/**
 * A bucket of NATS: a stream with one message for each key, as `nats kv` and every library of NATS know it (ADR-8 of
 * NATS). Each call rejects at once while no server is connected.
 */
export class KvBucket {
  readonly name: string;
  readonly #link: NatsLink;
  readonly #client: JetStreamClient;

  constructor(link: NatsLink, name: string) {
    this.name = name;
    this.#link = link;
    this.#client = jetstream(link.connection, { timeout: ANSWER_MS });
  }

  manager(): Promise<JetStreamManager> {
    return this.#client.jetstreamManager(false);
  }

  /** Creates the bucket if it is missing. @returns when it was created, as NATS writes it: another bucket has another */
  async ensure(): Promise<string> {
    const manager = await this.manager();
    const stream = `KV_${this.name}`;
    try {
      return (await manager.streams.info(stream)).created;
    } catch (error) {
      if (!isMissing(error)) throw error;
    }
    const { created } = await manager.streams.add({
      name: stream,
      subjects: [`$KV.${this.name}.>`],
      retention: RetentionPolicy.Limits,
      storage: StorageType.File,
      discard: DiscardPolicy.New,
      max_msgs_per_subject: HISTORY,
      num_replicas: 1,
      allow_rollup_hdrs: true,
      allow_direct: true,
      deny_delete: true,
    });
    return created;
  }

  /** Reads a key where it was written, not from what is known here. */
  async read(rawKey: string): Promise<KvEntry | undefined> {
    this.#requireLink();
    const manager = await this.manager();
    try {
      const found = await manager.streams.getMessage(`KV_${this.name}`, {
        last_by_subj: this.#subject(rawKey),
      });
      if (found === null) return undefined;
      const isRemoved = found.header?.has('KV-Operation') === true;
      return { revision: found.seq, value: isRemoved ? undefined : found.data };
    } catch (error) {
      if (isNotFound(error)) return undefined;
      throw unanswered(error);
    }
  }

  /**
   * Writes a key; undefined deletes it.
   *
   * @param revision the key must have it; 0: none. Default: any
   * @returns the new revision; undefined when the key has another one than `revision`
   * @throws ServiceError `unavailable`, or `resource_exhausted` for a value that NATS does not take
   */
  async write(
    rawKey: string,
    value: Uint8Array | undefined,
    revision?: number,
  ): Promise<number | undefined> {
    this.#requireLink();
    this.#requireRoom(value?.byteLength ?? 0);
    const operation = headers();
    if (value === undefined) operation.set('KV-Operation', 'DEL');
    try {
      const { seq } = await this.#client.publish(this.#subject(rawKey), value ?? Empty, {
        headers: operation,
        ...(revision !== undefined && { expect: { lastSubjectSequence: revision } }),
      });
      return seq;
    } catch (error) {
      if (isConflict(error)) return undefined;
      throw unanswered(error);
    }
  }

  /** Removes what is left of a deleted key, unless it was written again. */
  async forget(rawKey: string, revision: number): Promise<void> {
    const manager = await this.manager();
    const filter = this.#subject(rawKey);
    await manager.streams.purge(`KV_${this.name}`, { filter, seq: revision + 1 });
  }

  #subject(rawKey: string): string {
    return `$KV.${this.name}.${rawKey}`;
  }

  #requireLink(): void {
    if (!this.#link.isConnected) {
      throw new ServiceError(
        'unavailable',
        'NATS cannot be reached, so nothing can be stored. Try again later.',
      );
    }
  }

  #requireRoom(sizeBytes: number): void {
    const most = this.#link.maxPayloadBytes - ENVELOPE_BYTES;
    if (sizeBytes > most) {
      throw new ServiceError(
        'resource_exhausted',
        `NATS stores at most ${most} bytes, and this takes ${sizeBytes}, compressed. Raise max_payload of the NATS servers.`,
      );
    }
  }
}

/** NATS may have taken a change although its answer did not come. */
function unanswered(cause: unknown): unknown {
  const isLate = cause instanceof errors.TimeoutError || cause instanceof errors.RequestError;
  if (!isLate) return cause;
  const text =
    'NATS did not answer, so it is not known whether the change was stored. Check it and try again.';
  return new ServiceError('unavailable', text, { cause });
}

function isMissing(error: unknown): boolean {
  return error instanceof JetStreamApiError && error.code === JetStreamApiCodes.StreamNotFound;
}
