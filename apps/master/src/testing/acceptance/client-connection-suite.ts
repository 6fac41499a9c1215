import { encodeRecord, ServiceError } from '@ubii/proto';
import { encodeNodeMessageFrame } from '@ubii/proto/wire';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import { BatchNode } from '../../core/topics/batch-node.ts';
import { TopicEntry } from '../../core/topics/topic-entry.ts';
import type { ClientConnection } from '../../core/ports/client-connection.ts';
import { CLOSE_REASONS } from '../../core/ports/close-reason.ts';
import type { RecordBatch } from '../../core/ports/record-batch.ts';
import { SuiteHost, type Opened } from './suite-host.ts';
import type { ClientEnd, ConnectionBench, OpenBench, Seen } from './connection-bench.ts';

/** Most that is sent to a client that reads nothing: more than any system keeps for one connection. */
const MAX_SENT_BYTES = 64 * 1024 * 1024;

const UNREAD_MESSAGES = 5;

/** Acceptance tests of transports for topic data: of both directions, from opening to the end. */
export function clientConnectionSuite(name: string, openBench: OpenBench): void {
  describe(`${name}, a transport of client connections`, () => {
    let host: SuiteHost;
    let bench: ConnectionBench;
    beforeEach(async () => {
      host = new SuiteHost();
      bench = await openBench(host);
    });
    afterEach(() => bench.close());

    /** A client and its connection. */
    async function dial(): Promise<{ client: ClientEnd; connection: ClientConnection } & Opened> {
      const client = bench.dial({ clientId: 'ada', token: 'secret' });
      const opened = await host.nextOpened();
      return { client, ...opened };
    }

    describe('to the client', () => {
      it('sends a batch as one message a record where lists are off [TD-3]', async () => {
        const { client, connection } = await dial();
        const records = [record('/a', 1), record('/b', 2), record('/a', 3)];
        connection.send(batchOf(records));
        for (const expected of records) expectRecord(await client.next(), expected);
      });

      it('sends a batch as one message where lists are on [TD-4]', async () => {
        const { client, connection } = await dial();
        const records = [record('/a', 1), record('/b', 2), record('/a', 3)];
        connection.setRecordLists(true);
        connection.send(batchOf(records));
        const seen = await client.next();
        expect(seen.kind === 'list' && seen.records.map((bytes) => [...bytes])).toEqual(
          records.map((bytes) => [...bytes]),
        );
      });

      it('may turn lists on and off between batches', async () => {
        const { client, connection } = await dial();
        const records = [record('/a', 1), record('/b', 2)];
        connection.setRecordLists(true);
        connection.send(batchOf(records));
        connection.setRecordLists(false);
        connection.send(batchOf(records));
        expect((await client.next()).kind).toBe('list');
        expect((await client.next()).kind).toBe('record');
        expect((await client.next()).kind).toBe('record');
      });

      it('sends every byte of a large record, after and before small ones [TD-11]', async () => {
        const { client, connection } = await dial();
        const large = encodeRecord({
          topic: '/large',
          format: 'string',
          value: 'x'.repeat(300_000),
        });
        const records = [record('/a', 1), large, record('/a', 2)];
        connection.send(batchOf(records));
        for (const expected of records) expectRecord(await client.next(), expected);
      });

      it('sends one batch to several clients', async () => {
        const both = [await dial(), await dial()];
        const batch = batchOf([record('/a', 1), record('/b', 2)]);
        for (const { connection } of both) connection.send(batch);
        for (const { client } of both) {
          expectRecord(await client.next(), batch.records[0]!);
          expectRecord(await client.next(), batch.records[1]!);
        }
      });

      it('sends errors, PING and PONG in order with records [TD-5] [TD-17]', async () => {
        const { client, connection } = await dial();
        const error = new ServiceError('permission_denied', 'Not there.').toWire();
        connection.sendPing();
        connection.send(batchOf([record('/a', 1)]));
        connection.sendError(error);
        connection.sendPong();
        expect(await client.next()).toEqual({ kind: 'PING' });
        expectRecord(await client.next(), record('/a', 1));
        expect(await client.next()).toEqual({ kind: 'error', error });
        expect(await client.next()).toEqual({ kind: 'PONG' });
      });

      it('sends a PONG with the time of the master [TS-2]', async () => {
        const { client, connection } = await dial();
        const timed = { number: '7', receivedMs: 1.25, sentMs: 2 };
        connection.sendPong(timed);
        expect(await client.next()).toEqual({ kind: 'PONG', timed });
      });

      it('sends a frame as it is', async () => {
        const { client, connection } = await dial();
        const frame = encodeNodeMessageFrame({ moduleReports: { statistics: [], events: [] } });
        connection.sendFrame(frame);
        const seen = await client.next();
        expect(seen.kind === 'frame' && [...seen.frame]).toEqual([...frame]);
      });

      it('has nothing queued before it was used', async () => {
        const { connection } = await dial();
        expect(connection.queuedBytes).toBe(0);
      });

      it('says how much a client has not taken, and when it took all [TD-35]', async () => {
        const { client, connection, heard } = await dial();
        client.pause();
        const batch = batchOf([record('/large', 'x'.repeat(1_000_000))]);
        let sentBytes = 0;
        while (connection.queuedBytes < 2_000_000 && sentBytes < MAX_SENT_BYTES) {
          connection.send(batch);
          sentBytes += batch.byteLength;
          await bench.settle();
        }
        expect(connection.queuedBytes).toBeGreaterThanOrEqual(2_000_000);
        heard.waiting.length = 0;
        client.resume();
        expect(await heard.next()).toEqual({ kind: 'drain' });
        expect(connection.queuedBytes).toBe(0);
      });
    });

    describe('from the client', () => {
      it('hands over topic data byte for byte, in order, in memory of its own', async () => {
        const { client, heard } = await dial();
        const messages = [bytesOf(2, 10), bytesOf(1, 0), bytesOf(3, 300_000)];
        const sent = messages.map((message) => message.slice());
        for (const message of messages) client.sendTopicData(message);
        const seen = [await heard.next(), await heard.next(), await heard.next()];
        for (const message of messages) message.fill(0xff);
        for (const [i, one] of seen.entries()) {
          expect(one.kind === 'topic data' && areSame(one.bytes, sent[i]!)).toBe(true);
        }
      });

      it('hands over PING, with a question for the time as well, and PONG [TD-2] [TS-2]', async () => {
        const { client, heard } = await dial();
        const clock = { offsetMs: -2.5, errorMs: 0.25, driftPpm: 1 };
        client.sendPing();
        client.sendPing({ number: '17', clock: undefined });
        client.sendPing({ number: '18', clock });
        client.sendPong();
        expect(await heard.next()).toEqual({ kind: 'ping' });
        expect(await heard.next()).toEqual({
          kind: 'ping',
          timed: { number: '17', clock: undefined },
        });
        expect(await heard.next()).toEqual({ kind: 'ping', timed: { number: '18', clock } });
        expect(await heard.next()).toEqual({ kind: 'pong' });
      });

      it('calls a message that is none of these a protocol error, and goes on [TD-2]', async () => {
        const { client, heard } = await dial();
        client.sendNonsense();
        client.sendTopicData(bytesOf(7, 3));
        const seen = await heard.next();
        expect(seen.kind === 'protocol error' && seen.reason).toMatch(/^[A-Z].*\.$/);
        expect((await heard.next()).kind).toBe('topic data');
      });
    });

    describe('that is not to be read', () => {
      it('leaves most messages with the client until it is read again [TD-71]', async () => {
        const { client, connection, heard } = await dial();
        if (connection.setReading === undefined) return;
        connection.setReading(false);
        for (let i = 0; i < UNREAD_MESSAGES; i++) client.sendTopicData(bytesOf(1, 100_000));
        await bench.settle();
        expect(heard.waiting.length).toBeLessThan(2);
        connection.setReading(true);
        for (let i = 0; i < UNREAD_MESSAGES; i++) {
          expect((await heard.next()).kind).toBe('topic data');
        }
      });

      it('can still be closed', async () => {
        const { client, connection } = await dial();
        connection.setReading?.(false);
        connection.close('superseded');
        connection.setReading?.(true);
        await client.ended();
      });
    });

    describe('at its beginning', () => {
      it('says who opens it: claim, caller and program', async () => {
        const { claim, caller, peer } = await dial();
        expect(claim).toEqual({ clientId: 'ada', token: bench.tells.token ? 'secret' : undefined });
        expect(caller).toEqual(bench.caller);
        expect(peer?.program).toBe(bench.tells.program);
      });

      it('claims no client where none is named [TD-6]', async () => {
        bench.dial({ clientId: undefined, token: undefined });
        const { claim } = await host.nextOpened();
        expect(claim).toEqual({ clientId: undefined, token: undefined });
      });

      it('is not opened where the master refuses it before [AC-27]', async () => {
        const refused = bench.dial({ clientId: SuiteHost.REFUSED, token: undefined });
        await refused.ended();
        expect(host.openedCount).toBe(0);
      });

      it('survives that the master closes it at once, with what still comes from it', async () => {
        const client = bench.dial({ clientId: SuiteHost.UNKNOWN, token: undefined });
        client.sendTopicData(bytesOf(1, 3));
        client.sendPing();
        await client.ended();
        const { client: other, heard } = await dial();
        other.sendPong();
        expect(await heard.next()).toEqual({ kind: 'pong' });
      });
    });

    describe('at its end', () => {
      it.each(CLOSE_REASONS)(
        'says that it is closed: %s, after what was sent [TD-8]',
        async (reason) => {
          const { client, connection } = await dial();
          connection.send(batchOf([record('/a', 1)]));
          connection.close(reason);
          expectRecord(await client.next(), record('/a', 1));
          if (bench.tells.reason) expect(await client.next()).toEqual({ kind: 'close', reason });
          await client.ended();
        },
      );

      it('explains to people why [EX-30]', async () => {
        const { client, connection } = await dial();
        connection.close('disconnected', 'by Mara: too loud');
        const explained = {
          kind: 'close',
          reason: 'disconnected',
          explanation: 'by Mara: too loud',
        };
        if (bench.tells.reason) expect(await client.next()).toEqual(explained);
        await client.ended();
      });

      it('bears every call after it was closed', async () => {
        const { connection } = await dial();
        connection.close('deregistered');
        connection.send(batchOf([record('/a', 1)]));
        connection.sendError(new ServiceError('internal', 'Late.').toWire());
        connection.sendPing();
        connection.sendPong();
        connection.setRecordLists(true);
        connection.close('superseded', 'again');
        expect(connection.queuedBytes).toBeGreaterThanOrEqual(0);
      });

      it('tells the master that the client left, after what it sent [EX-55]', async () => {
        const { client, heard } = await dial();
        client.sendPong();
        client.leave();
        expect(await heard.next()).toEqual({ kind: 'pong' });
        expect(await heard.next()).toEqual({
          kind: 'close',
          ending: bench.tells.leaving ? 'left' : 'lost',
        });
      });

      it('tells the master that the connection broke, once', async () => {
        const { client, heard, connection } = await dial();
        client.cut();
        // What finds out by sending has something to send.
        connection.sendPing();
        expect(await heard.next()).toEqual({ kind: 'close', ending: 'lost' });
        connection.sendPing();
        connection.close('too slow');
        await bench.settle();
        expect(heard.waiting).toEqual([]);
      });
    });
  });
}

function record(topic: string, value: number | string): Uint8Array {
  return typeof value === 'number'
    ? encodeRecord({ topic, format: 'double', value })
    : encodeRecord({ topic, format: 'string', value });
}

/** A message of topic data that is not looked into here. */
function bytesOf(fill: number, length: number): Uint8Array {
  return new Uint8Array(length).fill(fill);
}

/** Compares byte by byte itself: the comparison of the framework takes seconds for a picture. */
function areSame(one: Uint8Array, other: Uint8Array): boolean {
  return one.byteLength === other.byteLength && one.every((byte, i) => byte === other[i]);
}

function expectRecord(seen: Seen, bytes: Uint8Array): void {
  if (seen.kind !== 'record') throw new Error(`a record was expected, ${seen.kind} came`);
  expect(areSame(seen.record, bytes)).toBe(true);
}

function batchOf(records: readonly Uint8Array[]): RecordBatch {
  const entry = new TopicEntry('/any');
  return records.reduce((batch, bytes) => batch.append(entry, bytes, false), BatchNode.empty());
}
