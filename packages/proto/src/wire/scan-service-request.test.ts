import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { decode, encode } from '../codec.ts';
import { DecodeError } from '../decode-error.ts';
import { arbitraryMessage } from '../testing/arbitrary-message.ts';
import { scanServiceRequest } from './scan-service-request.ts';

const REQUEST = 'ubii.services.ServiceRequest';

function count(value: unknown): number {
  if (value instanceof Uint8Array || typeof value !== 'object' || value === null) return 1;
  return Object.values(value).reduce<number>((sum, each) => sum + count(each), 1);
}

describe('scanServiceRequest [SV-43]', () => {
  it('finds the topic, of several the last, wherever it is', () => {
    const a = encode(REQUEST, { client: { id: 'x' } });
    const b = encode(REQUEST, { topic: '/a' });
    const c = encode(REQUEST, { topic: '/b', session: { name: 'n' } });
    const bytes = Uint8Array.from([...a, ...b, ...c]);
    expect(scanServiceRequest(bytes, 100).topic).toBe(decode(REQUEST, bytes).topic);
    expect(scanServiceRequest(a, 100).topic).toBe('');
  });

  it('counts every value that was written', () => {
    fc.assert(
      fc.property(arbitraryMessage(REQUEST), (message) => {
        const bytes = encode(REQUEST, message as never);
        const given = JSON.parse(
          JSON.stringify(message),
          (_key, value: unknown) => value,
        ) as object;
        const { topic, values } = scanServiceRequest(bytes, Infinity);
        expect(topic).toBe(decode(REQUEST, bytes).topic);
        // Lists are no values on the wire, and defaults may be left out: what is there is counted.
        expect(values).toBeLessThanOrEqual(count(given) + bytes.length);
        expect(values).toBeGreaterThanOrEqual(1);
      }),
      { numRuns: 50 },
    );
    const modules = encode(REQUEST, { session: { processingModules: Array(500).fill({}) } });
    expect(scanServiceRequest(modules, Infinity).values).toBeGreaterThan(500);
    const numbers = { record: { int32List: { elements: Array(300).fill(1) } } };
    const packed = encode(REQUEST, {
      lockstepProcessingRequest: { records: [numbers.record] },
    } as never);
    expect(scanServiceRequest(packed, Infinity).values).toBeGreaterThan(300);
  });

  it('ends at the limit, and says where', () => {
    const bytes = encode(REQUEST, { session: { processingModules: Array(5000).fill({}) } });
    const { excessAt, values } = scanServiceRequest(bytes, 100);
    expect(values).toBe(101);
    expect(excessAt).toBeGreaterThan(0);
    expect(excessAt).toBeLessThan(bytes.length / 10);
  });

  it('fails as a DecodeError when the structure is broken', () => {
    expect(() => scanServiceRequest(Uint8Array.of(0x0a, 0x7f), 100)).toThrow(DecodeError);
    expect(() => scanServiceRequest(Uint8Array.of(0xff, 0xff), 100)).toThrow(DecodeError);
  });
});
