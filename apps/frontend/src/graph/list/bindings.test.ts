import { describe, expect, it } from 'vitest';
import { applyCommand } from '../model/commands/apply-command.ts';
import { perform, startEditing, undo } from '../model/commands/edit-state.ts';
import { aGraphOf, aModule, ref, wiresIn } from '../model/testing/small-graph.ts';
import { bindings } from './bindings.ts';

const pick = aModule('pick-field', { value: 'object2D', path: 'string' }, { number: 'double' });
const graph = aGraphOf(
  [
    aModule('source', {}, { out: 'double', point: 'vector2' }),
    aModule('sink', { in: 'double', many: 'double[]' }, { done: 'bool' }),
  ],
  { 'source.out': '/n', 'sink.in': '/n' },
);
const sources = {
  modules: [pick],
  topics: [
    { topic: '/live/number', format: 'double' },
    { topic: '/live/point', format: 'vector2' },
    { topic: '/n', format: 'double' },
    { topic: '/info/session/new', format: 'session' },
  ],
};
const uuid = (): string => 'uuid';
const of = (port: string, typed = '') => bindings(graph, ref(graph, port), sources, typed, uuid);
const found = (port: string, text: string) => {
  const binding = of(port).find((one) => one.text === text);
  if (binding === undefined) throw new Error(`no binding ${text}`);
  return binding;
};

describe('what an input can read', () => {
  it('is outputs of the session and live topics that fit; topics between modules are their outputs', () => {
    const texts = of('sink.in')
      .filter(({ command }) => command !== undefined)
      .map(({ text }) => text);
    expect(texts).toEqual(['source · out', '/live/number']);
  });

  it('is wired in one step, which undo takes back', () => {
    const { command } = found('sink.in', '/live/number');
    const done = perform(startEditing(graph), command!);
    expect(wiresIn(done.graph)).toContain('topic:/live/number > sink.in');
    expect(done.past).toHaveLength(1);
    expect(undo(done).graph).toEqual(graph);
  });

  it('tells topics from ports and from topics that are not there yet', () => {
    expect(found('sink.in', '/live/number').topic).toBe('/live/number');
    expect(found('sink.in', 'source · out').topic).toBeUndefined();
    expect(of('sink.in', 'later')[0]?.topic).toBeUndefined();
  });

  it('says what does not fit, and makes it fit', () => {
    const point = found('sink.in', '/live/point');
    expect(point).toMatchObject({ group: 'misfits', command: undefined });
    expect(point.reason).toMatch(/outputs vector2.*expects double/);
    const [offer] = point.offers;
    expect(offer).toMatchObject({ kind: 'field' });
    const adapted = applyCommand(graph, point.adapt(offer!)).graph;
    expect(wiresIn(adapted).some((wire) => wire.includes('> sink.in'))).toBe(true);
    expect(adapted.nodes.has('topic:/live/point')).toBe(true);
  });

  it('is found by words, and may be a topic that is not there yet', () => {
    expect(of('sink.in', 'live num').map(({ text }) => text)).toEqual(['/live/number']);
    expect(of('sink.in', 'later')[0]).toMatchObject({ text: 'New topic /later', group: 'topics' });
    // Existing topics come first: Enter takes the first.
    expect(of('sink.in', 'number').map(({ text }) => text)).toEqual([
      '/live/number',
      'New topic /number',
    ]);
    expect(of('source.out', 'number').map(({ text }) => text)[0]).toBe('/live/number');
    expect(of('sink.in', '/n').map(({ text }) => text)).not.toContain('New topic /n');
  });
});

it('lists topics without data after those that are known to fit', () => {
  const topics = [{ topic: '/a/silent', format: '' }, ...sources.topics];
  const silent = bindings(graph, ref(graph, 'sink.in'), { ...sources, topics }, '', uuid);
  expect(silent.map(({ text, group }) => [text, group]).slice(0, 3)).toEqual([
    ['source · out', 'session'],
    ['/live/number', 'topics'],
    ['/a/silent', 'unknown'],
  ]);
});

it('is found by the name of the client that publishes it', () => {
  const named = { ...sources, nameTopic: (topic: string) => `${topic} · Ines` };
  const texts = bindings(graph, ref(graph, 'sink.in'), named, 'ines num', uuid);
  expect(texts[0]).toMatchObject({ text: '/live/number' });
});

describe('where an output can lead', () => {
  it('is inputs that fit, and a topic of its own', () => {
    const texts = of('source.out').map(({ text }) => text);
    expect(texts[0]).toMatch(/^New topic /);
    expect(texts).toContain('sink · in');
    expect(texts).toContain('/live/number');
    const { command } = of('source.out')[0]!;
    expect(applyCommand(graph, command!).graph.nodes.size).toBe(graph.nodes.size + 1);
  });
});

it('is nothing for a port that is gone', () => {
  expect(bindings(graph, { node: 'module:x', port: 'in' }, sources, '')).toEqual([]);
});
