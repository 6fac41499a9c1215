import {
  ClientState,
  StatusEventKind,
  StatusProblemSeverity,
  type Client,
  type StatusEvent,
} from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { awaySinceMs, clientKind, clientNote, clientSockets } from './client-facts.ts';

describe('client facts', () => {
  const component = (messageFormat: string, ioType: 0 | 1 = 0) => ({ messageFormat, ioType });
  const withComponents = (...components: object[]) =>
    ({ devices: [{ components }] }) as unknown as Client;

  it('one socket for formats that look alike, publishers first', () => {
    expect(
      clientSockets(
        withComponents(
          component('bool', 1),
          component('vector2'),
          component('ubii.dataStructure.Vector3'),
          component('vector2List'),
          component(''),
        ),
      ),
    ).toEqual([
      { format: 'vector2', names: 'vector2, vector3' },
      { format: 'vector2List', names: 'vector2List' },
      { format: 'bool', names: 'bool' },
    ]);
  });

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

  it.each([
    [ClientState.ACTIVE, true, 0, 'this browser'],
    [ClientState.ACTIVE, false, 0, 'publishes nothing'],
    [ClientState.ACTIVE, false, 1, '1 topic'],
    [ClientState.INACTIVE, false, 3, 'no response, 6 s'],
    [ClientState.UNAVAILABLE, false, 3, 'connection lost, 6 s'],
  ])('state %d, self %s, %d topics: %s', (state, isSelf, topics, text) => {
    expect(clientNote(state, isSelf, topics, '6 s').text).toBe(text);
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
