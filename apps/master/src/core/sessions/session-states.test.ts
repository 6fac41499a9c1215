import { SessionState, SessionStatus } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import {
  canHappen,
  isLive,
  nextLife,
  SESSION_LIVES,
  wireState,
  wireStatus,
  type SessionEvent,
  type SessionLife,
} from './session-states.ts';

const MOVES: readonly [SessionLife, SessionEvent, SessionLife][] = [
  ['created', 'start', 'starting'],
  ['starting', 'all run', 'running'],
  ['starting', 'some run', 'degraded'],
  ['running', 'some run', 'degraded'],
  ['degraded', 'all run', 'running'],
  ['running', 'pause', 'paused'],
  ['degraded', 'pause', 'paused'],
  ['paused', 'resume', 'running'],
  ['starting', 'stop', 'stopping'],
  ['running', 'stop', 'stopping'],
  ['degraded', 'stop', 'stopping'],
  ['paused', 'stop', 'stopping'],
  ['stopping', 'all ended', 'stopped'],
  ['stopped', 'start', 'starting'],
];

describe('a session', () => {
  it.each(MOVES)('that is %s becomes, by "%s", %s [SE-10]', (life, event, next) => {
    expect(nextLife(life, event)).toBe(next);
    expect(canHappen(life, event)).toBe(true);
  });

  it('is not moved by anything else [SE-10]', () => {
    const events = new Set(MOVES.map(([, event]) => event));
    for (const life of SESSION_LIVES) {
      for (const event of events) {
        const isLegal = MOVES.some(([from, by]) => from === life && by === event);
        expect(canHappen(life, event)).toBe(isLegal);
        if (!isLegal) expect(nextLife(life, event)).toBe(life);
      }
    }
  });

  it('shows existing clients a coarser status [SE-10]', () => {
    expect(SESSION_LIVES.map((life) => [life, wireStatus(life)])).toEqual([
      ['created', SessionStatus.CREATED],
      ['starting', SessionStatus.CREATED],
      ['running', SessionStatus.RUNNING],
      ['degraded', SessionStatus.RUNNING],
      ['paused', SessionStatus.PAUSED],
      ['stopping', SessionStatus.RUNNING],
      ['stopped', SessionStatus.STOPPED],
    ]);
    expect(new Set(SESSION_LIVES.map(wireState))).toEqual(new Set(Object.values(SessionState)));
  });

  it('lives from its start to its stop', () => {
    expect(SESSION_LIVES.filter(isLive)).toEqual(['starting', 'running', 'degraded', 'paused']);
  });
});
