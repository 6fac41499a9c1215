import { expect, it } from 'vitest';
import { applyCommand } from '../model/commands/apply-command.ts';
import { aGraphOf, aModule, ref, wiresIn } from '../model/testing/small-graph.ts';
import { inputOffers } from './input-offers.ts';

const OPTIONS = { uuid: () => 'new', place: { x: 400, y: 0 }, waits: () => false };
const statistic = (topic: string, dataFormat: string) => ({ topic, dataFormat, publishedMs: 1 });

it('offers the outputs of the graph that fit, the same format first, then live topics', () => {
  const graph = aGraphOf([
    aModule('count', {}, { n: 'int32' }),
    aModule('pose', {}, { at: 'vector2' }),
    aModule('gesture', {}, { confidence: 'double' }),
    aModule('map', { value: 'double' }, { mapped: 'double' }),
  ]);
  const known = [statistic('/phone/level', 'double'), statistic('/phone/touch', 'vector2')];
  const offers = inputOffers(graph, ref(graph, 'map.value'), known, OPTIONS);
  expect(offers.map(({ name, format }) => `${name} ${format}`)).toEqual([
    'gesture · confidence double',
    'count · n int32',
    '/phone/level double',
  ]);
  const waits = (node: string): boolean => node === 'module:gesture';
  const [first] = inputOffers(graph, ref(graph, 'map.value'), known, { ...OPTIONS, waits });
  expect(first?.name).toBe('count · n');
  const connected = applyCommand(graph, offers[0]!.command).graph;
  expect(wiresIn(connected)).toEqual(['gesture.confidence > map.value (/Test/gesture/confidence)']);
  const read = applyCommand(graph, offers[2]!.command).graph;
  expect(wiresIn(read)).toEqual(['topic:/phone/level > map.value']);
});

it('offers no topic of the master and none without a value', () => {
  const graph = aGraphOf([aModule('map', { value: 'double' })]);
  const known = [
    { ...statistic('/later', 'double'), publishedMs: 0 },
    statistic('/info/processing_module/x', 'double'),
  ];
  expect(inputOffers(graph, ref(graph, 'map.value'), known, OPTIONS)).toEqual([]);
});
