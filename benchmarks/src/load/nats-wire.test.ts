import { describe, expect, it } from 'vitest';
import { DeliveryVerifier } from './delivery-verifier.ts';
import { NATS } from './nats-wire.ts';
import { createRecordRing } from './record-ring.ts';

const ring = createRecordRing('nats', 100, 512);
const NO_FAULTS = { lost: 0, altered: 0, repeated: 0, unexpected: [] };

function message(sequence: number): Buffer {
  return Buffer.from(NATS.delivered(ring).slice(sequence, 1));
}

function verify(chunks: readonly Buffer[]) {
  let pings = 0;
  const verifier = new DeliveryVerifier(ring, NATS);
  verifier.onPing = () => (pings += 1);
  for (const chunk of chunks) verifier.push(chunk);
  verifier.finish(verifier.next);
  return { next: verifier.next, pings, faults: verifier.faults };
}

describe('records over NATS', () => {
  it('are published and delivered with the same content', () => {
    const lineOf = (tape: Buffer): string => tape.toString('latin1').split('\r\n')[0]!;
    const published = NATS.published(ring).slice(3, 1);
    const content = ring.messages.slice(3, 1);
    expect(lineOf(published)).toBe(`PUB ${ring.topic} ${content.length}`);
    expect(lineOf(message(3))).toBe(`MSG ${ring.topic} 1 ${content.length}`);
    for (const bytes of [published, message(3)]) expect(bytes.includes(content)).toBe(true);
  });

  it('are accepted in whatever chunks they come, with a PING between them', () => {
    const stream = Buffer.concat([
      message(0),
      Buffer.from('PING\r\n'),
      ...[1, 2, 3].map(message),
      Buffer.from('INFO {}\r\n'),
    ]);
    for (let cut = 1; cut < stream.length; cut += 7) {
      const chunks = [stream.subarray(0, cut), stream.subarray(cut)];
      expect(verify(chunks)).toEqual({ next: 4, pings: 1, faults: NO_FAULTS });
    }
  });

  it('that are lost, repeated or altered are counted', () => {
    const altered = message(5);
    altered[altered.length - 4]! ^= 1;
    const { faults } = verify([
      message(0),
      message(2),
      message(2),
      message(3),
      message(4),
      altered,
    ]);
    expect(faults).toEqual({ lost: 1, repeated: 1, altered: 1, unexpected: [] });
  });

  it('do not hide an error of the server', () => {
    const { faults } = verify([message(0), Buffer.from("-ERR 'Slow Consumer'\r\n")]);
    expect(faults.unexpected).toEqual([`the line "-ERR 'Slow Consumer'"`]);
  });
});
