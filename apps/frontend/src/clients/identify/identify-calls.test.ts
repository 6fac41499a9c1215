import { describe, expect, it } from 'vitest';
import { readCall, type SeenCall } from './identify-calls.ts';

function memory(): SeenCall {
  let call: string | null = null;
  return { load: () => call, save: (next) => (call = next) };
}
const record = (value: string, timestampMs?: number) => ({
  value,
  clientId: 'mara',
  timestampMs,
});

describe('readCall', () => {
  it('names the asking client in one short line', () => {
    expect(readCall(record(' Mara\n’s  desk ', 1), memory())).toEqual({ byName: 'Mara ’s desk' });
    expect(readCall(record('x'.repeat(100)), memory())?.byName).toHaveLength(61);
  });

  it('does not take a value that comes again for a new call [EX-34]', () => {
    const seen = memory();
    expect(readCall(record('Mara', 1), seen)).toBeDefined();
    expect(readCall(record('Mara', 1), seen)).toBeUndefined();
    expect(readCall(record('Mara', 2), seen)).toBeDefined();
  });

  it('takes a record without a time for a new call', () => {
    const seen = memory();
    expect(readCall(record('Mara', undefined), seen)).toBeDefined();
    expect(readCall(record('Mara', undefined), seen)).toBeDefined();
  });
});
