import { expect, it } from 'vitest';
import { moduleWords, watcherSentence } from './watcher-words.ts';

const NAMES: Record<string, string> = { a: 'Anna', b: 'Ben', c: 'Cleo', d: 'Dora' };
const names = {
  selfId: 'self',
  masterId: 'master',
  tabIds: ['self', 't', 'u'],
  nameOf: (id: string) => NAMES[id] ?? id,
};
const sentence = (clientIds: string[], count = clientIds.length): string =>
  watcherSentence({ topic: '/t', count, clientIds, modules: [] }, names);

it.each([
  [[], 'No other client receives these pictures.'],
  [['self'], 'No other client receives these pictures.'],
  [['a', 'self'], 'Anna receives these pictures.'],
  [['master', 'a'], 'The master and Anna receive these pictures.'],
  [['t'], 'Another tab of this browser receives these pictures.'],
  [['t', 'u'], '2 other tabs of this browser receive these pictures.'],
  [['t', 'a', 'u'], 'Anna and 2 other tabs of this browser receive these pictures.'],
  [['a', 'b', 'c', 'd', 't', 'u'], 'Anna, Ben and 4 other clients receive these pictures.'],
  [['a', 'master'], 'Anna and the master receive these pictures.'],
  [['a', 'b', 'c'], 'Anna, Ben and Cleo receive these pictures.'],
  [['a', 'b', 'c', 'd'], 'Anna, Ben and 2 other clients receive these pictures.'],
])('names the receivers of pictures: %j', (ids, expected) => {
  expect(sentence(ids)).toBe(expected);
});

it('says a number where names are not told [EX-96]', () => {
  expect(sentence([], 1)).toBe('1 client receives these pictures.');
  expect(sentence([], 3)).toBe('3 clients receive these pictures.');
});

it('names modules with their session and place', () => {
  const module = { name: 'hand-pose', sessionId: 's', sessionName: 'Hands', nodeId: 'self' };
  expect(moduleWords(module, names)).toBe('hand-pose of “Hands”, in this tab');
  expect(moduleWords({ ...module, nodeId: 'master' }, names)).toBe(
    'hand-pose of “Hands”, on the master',
  );
  expect(moduleWords({ ...module, sessionName: '', nodeId: 'a' }, names)).toBe(
    'hand-pose of a session without a name, on Anna',
  );
});
