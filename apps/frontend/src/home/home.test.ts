import {
  ClientState,
  StatusEventKind,
  StatusProblemSeverity,
  type Client,
  type StatusEvent,
} from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import type { TopicRate } from '../connection/topic-rates.ts';
import { awaySinceMs, clientKind, clientNote, clientSockets } from './client-facts.ts';
import { homeSentence } from './home-sentence.ts';
import { problemParts } from './problem-parts.ts';
import { publisherRates } from './publisher-rates.ts';

describe('homeSentence', () => {
  const calm = {
    active: 5,
    silent: 0,
    errors: 0,
    warnings: 0,
    running: 0,
    troubledModules: 0,
    recordsPerSecond: 1842,
  };

  it.each([
    [calm, 'Five clients are here and data is flowing.'],
    [{ ...calm, recordsPerSecond: 0 }, 'Five clients are here, nobody is publishing.'],
    [{ ...calm, recordsPerSecond: undefined }, 'Five clients are here.'],
    [{ ...calm, active: 1 }, 'Only this browser is here. Connect a phone or open an example.'],
    [
      { ...calm, running: 2, troubledModules: 1 },
      'Two sessions are running for five clients. One module needs you.',
    ],
    [{ ...calm, active: 1, running: 1 }, 'One session is running for this browser alone.'],
    [{ ...calm, active: 13 }, '13 clients are here and data is flowing.'],
    [{ ...calm, errors: 1 }, 'Five clients are here and data is flowing. One problem needs you.'],
    [{ ...calm, errors: 2 }, 'Five clients are here and data is flowing. Two problems need you.'],
    [{ ...calm, silent: 1 }, 'Five clients are here and data is flowing. One went silent.'],
    [
      { ...calm, warnings: 3 },
      'Five clients are here and data is flowing. Three warnings need you.',
    ],
  ])('%o', (facts, expected) => {
    const { is, asks } = homeSentence(facts);
    expect([is, asks].filter(Boolean).join(' ')).toBe(expected);
  });
});

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
    [ClientState.ACTIVE, false, 0, 'listens'],
    [ClientState.ACTIVE, false, 1, '1 topic'],
    [ClientState.INACTIVE, false, 3, 'silent, 6 s'],
    [ClientState.UNAVAILABLE, false, 3, 'away, 6 s'],
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

it('a problem’s sentence is set with the name apart', () => {
  expect(problemParts('Mara went silent.', 'Mara')).toEqual({
    subject: 'Mara',
    text: 'went silent.',
  });
  expect(problemParts('Too many topics.', undefined)).toEqual({
    subject: undefined,
    text: 'Too many topics.',
  });
});

it('rates are summed by publisher, without the master’s own topics', () => {
  const rate = (publisherId: string, hz: number | undefined, dataFormat = 'double') =>
    ({ statistic: { publisherId, dataFormat }, hz }) as unknown as TopicRate;
  const sums = publisherRates([
    rate('a', 60),
    rate('a', undefined),
    rate('b', undefined),
    rate('', 5),
    rate('a', 1, ''),
  ]);
  expect(Object.fromEntries(sums)).toEqual({
    a: { hz: 60, topics: 2 },
    b: { hz: undefined, topics: 1 },
  });
});
