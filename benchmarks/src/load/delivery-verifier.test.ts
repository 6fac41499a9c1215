import { encode, encodeRecord } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { DeliveryVerifier } from './delivery-verifier.ts';
import { serverFrame } from './frames.ts';
import { createRecordRing } from './record-ring.ts';

const ring = createRecordRing('test', 100, 512);

/** The frame a broker passes record `sequence` on with. */
function frame(sequence: number): Buffer {
  return Buffer.from(ring.frames.slice(sequence, 1));
}

/** One frame with a list of these records. */
function listFrame(sequences: readonly number[]): Buffer {
  const elements = Buffer.concat(sequences.map((sequence) => ring.elements.slice(sequence, 1)));
  const { length } = elements;
  const header = length < 128 ? [0x1a, length] : [0x1a, (length & 0x7f) | 0x80, length >> 7];
  return serverFrame(Buffer.concat([Buffer.from(header), elements]));
}

function verify(chunks: readonly Buffer[], published?: number) {
  let pings = 0;
  const verifier = new DeliveryVerifier(ring);
  verifier.onPing = () => (pings += 1);
  for (const chunk of chunks) verifier.push(chunk);
  verifier.finish(published ?? verifier.next);
  return { next: verifier.next, pings, faults: verifier.faults };
}

const NO_FAULTS = { lost: 0, altered: 0, repeated: 0, unexpected: [] };
const PING = Buffer.concat([Buffer.from([0x81, 4]), Buffer.from('PING')]);

describe('DeliveryVerifier', () => {
  it('accepts single records, in whatever chunks they come', () => {
    const stream = Buffer.concat([0, 1, 2, 3].map(frame));
    for (let cut = 1; cut < stream.length; cut += 7) {
      const chunks = [stream.subarray(0, cut), stream.subarray(cut)];
      expect(verify(chunks)).toEqual({ next: 4, pings: 0, faults: NO_FAULTS });
    }
  });

  it('accepts record lists and single records mixed', () => {
    const chunks = [listFrame([0]), listFrame([1, 2, 3]), frame(4), listFrame([5, 6])];
    expect(verify(chunks)).toEqual({ next: 7, pings: 0, faults: NO_FAULTS });
    expect(verify([Buffer.concat(chunks)]).faults).toEqual(NO_FAULTS);
  });

  it('goes on where the ring begins again', () => {
    const sequences = Array.from({ length: 1200 }, (_, sequence) => sequence);
    expect(verify(sequences.map(frame))).toEqual({ next: 1200, pings: 0, faults: NO_FAULTS });
    const lists = Array.from({ length: 20 }, (_, i) =>
      listFrame(sequences.slice(i * 60, i * 60 + 60)),
    );
    expect(verify(lists)).toEqual({ next: 1200, pings: 0, faults: NO_FAULTS });
  });

  it('passes a PING on, also between two halves of a record', () => {
    const half = frame(1);
    const chunks = [frame(0), PING, half.subarray(0, 40), half.subarray(40), PING, frame(2)];
    expect(verify(chunks)).toEqual({ next: 3, pings: 2, faults: NO_FAULTS });
    expect(verify([Buffer.concat([frame(0), half.subarray(0, 9)]), half.subarray(9)]).next).toBe(2);
  });

  it('counts a lost record, single or in a list', () => {
    expect(verify([frame(0), frame(2)])).toMatchObject({
      next: 3,
      faults: { ...NO_FAULTS, lost: 1 },
    });
    expect(verify([listFrame([0, 1, 4])])).toMatchObject({
      next: 5,
      faults: { ...NO_FAULTS, lost: 2 },
    });
  });

  it('counts what never came as lost', () => {
    expect(verify([frame(0)], 3).faults).toEqual({ ...NO_FAULTS, lost: 2 });
  });

  it('counts one changed bit as an altered record', () => {
    const altered = frame(1);
    altered[altered.length - 3]! ^= 1;
    const chunks = [frame(0), altered, frame(2)];
    expect(verify(chunks)).toMatchObject({ next: 3, faults: { ...NO_FAULTS, altered: 1 } });
    expect(verify([Buffer.concat(chunks)]).faults).toEqual({ ...NO_FAULTS, altered: 1 });
    const list = listFrame([0, 1, 2]);
    list[list.length - 3]! ^= 1;
    expect(verify([list]).faults).toEqual({ ...NO_FAULTS, altered: 1 });
  });

  it('counts repeated records and records out of order', () => {
    expect(verify([frame(0), frame(0), frame(1)]).faults).toEqual({ ...NO_FAULTS, repeated: 1 });
    expect(verify([frame(1), frame(0)]).faults).toEqual({ ...NO_FAULTS, lost: 1, repeated: 1 });
  });

  it('notices a record nobody published', () => {
    const record = encodeRecord({ topic: ring.topic, format: 'double', value: 1 });
    const stranger = Buffer.concat([Buffer.from([0x12, record.length]), record]);
    expect(verify([serverFrame(stranger)]).faults.altered).toBe(1);
    expect(verify([frame(0), frame(1)], 1).faults.unexpected).toHaveLength(1);
  });

  it('says what an error of the broker is about', () => {
    const error = encode('ubii.topicData.TopicData', {
      error: { title: 'refused', message: 'No room for /a.' },
    });
    expect(verify([serverFrame(error)]).faults.unexpected[0]).toContain('No room for /a.');
  });
});
