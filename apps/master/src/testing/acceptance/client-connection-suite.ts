import { encodeRecord, ServiceError, type ErrorMessage } from '@ubii/proto';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import { BatchNode } from '../../core/topics/batch-node.ts';
import { encodeNodeMessageFrame } from '@ubii/proto/wire';
import { TopicEntry } from '../../core/topics/topic-entry.ts';
import type { ClientConnection } from '../../core/ports/client-connection.ts';
import type { RecordBatch } from '../../core/ports/record-batch.ts';

/** Message received at the other end of a connection. */
export type Seen =
  | { readonly kind: 'record'; readonly record: Uint8Array }
  | { readonly kind: 'list'; readonly records: readonly Uint8Array[] }
  | { readonly kind: 'error'; readonly error: ErrorMessage }
  | { readonly kind: 'frame'; readonly frame: Uint8Array }
  | { readonly kind: 'PING' }
  | { readonly kind: 'PONG'; readonly text?: string }
  | { readonly kind: 'close'; readonly code: number; readonly reason: string };

/** A connection with its other end. */
export interface ConnectionPair {
  readonly connection: ClientConnection;
  /** The next message at the other end. */
  readonly next: () => Promise<Seen>;
  readonly dispose: () => Promise<void> | void;
}

/** Acceptance tests of client connections. */
export function clientConnectionSuite(
  name: string,
  openPair: () => Promise<ConnectionPair> | ConnectionPair,
): void {
  describe(`${name}, a ClientConnection`, () => {
    let pair: ConnectionPair;
    beforeEach(async () => {
      pair = await openPair();
    });
    afterEach(() => pair.dispose());

    it('sends a batch as one frame a record to a client that knows no lists [TD-3]', async () => {
      const records = [record('/a', 1), record('/b', 2), record('/a', 3)];
      pair.connection.send(batchOf(records));
      for (const expected of records) {
        expectRecord(await pair.next(), expected);
      }
    });

    it('sends a batch as one frame where lists are on [TD-4]', async () => {
      const records = [record('/a', 1), record('/b', 2), record('/a', 3)];
      pair.connection.setRecordLists(true);
      pair.connection.send(batchOf(records));
      const seen = await pair.next();
      expect(seen.kind).toBe('list');
      expect(seen.kind === 'list' && seen.records.map((bytes) => [...bytes])).toEqual(
        records.map((bytes) => [...bytes]),
      );
    });

    it('may turn lists on and off between batches', async () => {
      const records = [record('/a', 1), record('/b', 2)];
      pair.connection.setRecordLists(true);
      pair.connection.send(batchOf(records));
      pair.connection.setRecordLists(false);
      pair.connection.send(batchOf(records));
      expect((await pair.next()).kind).toBe('list');
      expect((await pair.next()).kind).toBe('record');
      expect((await pair.next()).kind).toBe('record');
    });

    it('sends every byte of a large record, after and before small ones [TD-11]', async () => {
      const large = encodeRecord({ topic: '/large', format: 'string', value: 'x'.repeat(300_000) });
      const records = [record('/a', 1), large, record('/a', 2)];
      pair.connection.send(batchOf(records));
      for (const expected of records) expectRecord(await pair.next(), expected);
    });

    it('shares what it makes of a batch', async () => {
      const batch = batchOf([record('/a', 1), record('/b', 2)]);
      const other = await openPair();
      pair.connection.send(batch);
      other.connection.send(batch);
      for (const { next } of [pair, other]) {
        expectRecord(await next(), batch.records[0]!);
        expectRecord(await next(), batch.records[1]!);
      }
      await other.dispose();
    });

    it('sends errors, PING and PONG in order with records [TD-5] [TD-17]', async () => {
      const error = new ServiceError('permission_denied', 'Not there.').toWire();
      pair.connection.sendPing();
      pair.connection.send(batchOf([record('/a', 1)]));
      pair.connection.sendError(error);
      pair.connection.sendPong();
      expect(await pair.next()).toEqual({ kind: 'PING' });
      expectRecord(await pair.next(), record('/a', 1));
      expect(await pair.next()).toEqual({ kind: 'error', error });
      expect(await pair.next()).toEqual({ kind: 'PONG' });
    });

    it('sends a PONG that says more [TS-2]', async () => {
      pair.connection.sendPong('PONG 7 1.000 2.000');
      expect(await pair.next()).toEqual({ kind: 'PONG', text: 'PONG 7 1.000 2.000' });
    });

    it('closes with code and reason, after what was sent', async () => {
      pair.connection.send(batchOf([record('/a', 1)]));
      pair.connection.close(4001, 'superseded');
      expectRecord(await pair.next(), record('/a', 1));
      expect(await pair.next()).toEqual({ kind: 'close', code: 4001, reason: 'superseded' });
    });

    it('bears every call after it was closed', () => {
      const { connection } = pair;
      connection.close(1000, 'deregistered');
      connection.send(batchOf([record('/a', 1)]));
      connection.sendError(new ServiceError('internal', 'Late.').toWire());
      connection.sendPing();
      connection.sendPong();
      connection.setRecordLists(true);
      connection.close(1000, 'again');
      expect(connection.queuedBytes).toBeGreaterThanOrEqual(0);
    });

    it('has nothing queued before it was used', () => {
      expect(pair.connection.queuedBytes).toBe(0);
    });

    it('sends a frame as it is', async () => {
      const frame = encodeNodeMessageFrame({ moduleReports: { statistics: [], events: [] } });
      pair.connection.sendFrame(frame);
      const seen = await pair.next();
      expect(seen.kind).toBe('frame');
      if (seen.kind === 'frame') expect([...seen.frame]).toEqual([...frame]);
    });
  });
}

function record(topic: string, value: number): Uint8Array {
  return encodeRecord({ topic, format: 'double', value });
}

/** Compares byte by byte itself: the comparison of the framework takes seconds for a picture. */
function expectRecord(seen: Seen, bytes: Uint8Array): void {
  if (seen.kind !== 'record') throw new Error(`a record was expected, ${seen.kind} came`);
  expect(seen.record.byteLength).toBe(bytes.byteLength);
  expect(seen.record.every((byte, i) => byte === bytes[i])).toBe(true);
}

function batchOf(records: readonly Uint8Array[]): RecordBatch {
  const entry = new TopicEntry('/any');
  return records.reduce((batch, bytes) => batch.append(entry, bytes, false), BatchNode.empty());
}
