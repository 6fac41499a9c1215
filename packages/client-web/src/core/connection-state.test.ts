import { describe, expect, it } from 'vitest';
import { next } from './connection-state.ts';
import type { ConnectionEvent, ConnectionStatus } from './connection-state.ts';

const STATUSES: ConnectionStatus[] = ['idle', 'connecting', 'connected', 'reconnecting', 'closed'];
const EVENTS: ConnectionEvent[] = ['connect', 'established', 'failed', 'ended', 'close'];

describe('next()', () => {
  it('has exactly these moves', () => {
    const moves = STATUSES.flatMap((status) =>
      EVENTS.map((event) => `${status} + ${event} = ${next(status, event) ?? '-'}`),
    );
    expect(moves.filter((move) => !move.endsWith('-'))).toEqual([
      'idle + connect = connecting',
      'idle + close = closed',
      'connecting + established = connected',
      'connecting + failed = reconnecting',
      'connecting + ended = closed',
      'connecting + close = closed',
      'connected + failed = reconnecting',
      'connected + ended = closed',
      'connected + close = closed',
      'reconnecting + established = connected',
      'reconnecting + failed = reconnecting',
      'reconnecting + ended = closed',
      'reconnecting + close = closed',
      'closed + connect = connecting',
      'closed + close = closed',
    ]);
  });

  it('can be closed from every status', () => {
    for (const status of STATUSES) expect(next(status, 'close')).toBe('closed');
  });
});
