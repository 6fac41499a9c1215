import { describe, expect, it } from 'vitest';

import { formatPong, isBinaryPong, readHeartbeat } from './heartbeat.ts';

describe('a heartbeat', () => {
  it('asks with PING and answers with PONG [TD-2] [EX-6]', () => {
    expect(readHeartbeat('PING')).toEqual({ kind: 'ping', timed: undefined });
    expect(readHeartbeat('PONG')).toEqual({ kind: 'pong' });
    expect(formatPong()).toBe('PONG');
  });

  it('asks for the time with a number, and may say how the clock is [TS-2] [TS-10]', () => {
    expect(readHeartbeat('PING 17')).toEqual({
      kind: 'ping',
      timed: { number: '17', clock: undefined },
    });
    const longest = 'PING 1234567890 -1700000000000.125456 1700000000000.250456 -1700000000000.5';
    expect(readHeartbeat(longest)).toMatchObject({
      timed: { number: '1234567890', clock: { driftPpm: -1_700_000_000_000.5 } },
    });
    expect(formatPong({ number: '17', receivedMs: 1.0004, sentMs: 2 })).toBe('PONG 17 1.000 2.000');
  });

  it.each([
    ...['ping', 'PONG ', '', '{"topic":"/a"}', 'x'.repeat(100_000)],
    ...['PING ', 'PING x', 'PING 1 2', 'PING 1 2 3 4 5', 'PING 1 NaN 1 1', 'PING 12345678901'],
  ])('is not %.20j [TD-2]', (other) => {
    expect(readHeartbeat(other)).toBeUndefined();
  });

  it('answers in bytes too, from some existing clients [TD-2]', () => {
    const bytes = (text: string): Uint8Array => new TextEncoder().encode(text);
    expect(isBinaryPong(bytes('PONG'))).toBe(true);
    for (const other of ['PING', 'PONG ', 'PON', '']) {
      expect(isBinaryPong(bytes(other))).toBe(false);
    }
  });
});
