import { StatusEventKind, StatusProblemSeverity, type Client, type StatusEvent } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { awaySinceMs, clientKind } from './client-facts.ts';

describe('client facts', () => {
  it('says what a client is by its own words, else by what can be seen', () => {
    const client = (changes: Partial<Client>) =>
      ({
        description: '',
        tags: [],
        isDedicatedProcessingNode: false,
        ...changes,
      }) as unknown as Client;
    expect(clientKind(client({ description: 'Pixel 9' }))).toBe('Pixel 9');
    expect(clientKind(client({ tags: ['a', 'b'] }))).toBe('a, b');
    expect(clientKind(client({ isDedicatedProcessingNode: true }))).toBe('runs modules');
    expect(clientKind(client({}))).toBe('');
  });

  it('knows since when a client is away from the problem, else from the last event', () => {
    const event = (kind: StatusEvent['kind'], timeMs: number): StatusEvent => ({
      kind,
      timeMs,
      text: '',
      clientId: 'c',
    });
    const lost = event(StatusEventKind.CLIENT_LOST, 20);
    const problem = {
      code: 'client_silent',
      severity: StatusProblemSeverity.WARNING,
      text: '',
      clientId: 'c',
      sinceMs: 5,
      remedy: '',
      sessionId: '',
      moduleId: '',
    };
    expect(awaySinceMs('c', [problem], [lost])).toBe(5);
    expect(awaySinceMs('c', [], [lost])).toBe(20);
    expect(
      awaySinceMs('c', [], [lost, event(StatusEventKind.CLIENT_RETURNED, 30)]),
    ).toBeUndefined();
    expect(awaySinceMs('other', [], [lost])).toBeUndefined();
  });
});
