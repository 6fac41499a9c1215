import { moduleLibrary } from '@ubii/modules';
import { describe, expect, it } from 'vitest';
import { applyCommand } from '../commands/apply-command.ts';
import type { Graph, PortRef } from '../graph.ts';
import { aGraphOf, aModule, ref, wiresIn } from '../testing/small-graph.ts';
import { adaptCommand } from './adapt.ts';
import { fitOf } from './fit-of.ts';
import { fittingNodes, fittingPorts, offerCommand } from './fitting.ts';

const library = moduleLibrary();
const uuids = (): (() => string) => {
  let count = 0;
  return () => `new${(count += 1)}`;
};
const graph = aGraphOf([
  aModule('pose', { p: 'pose3D' }, { pose: 'pose3D', points: 'vector2[]' }),
  aModule('size', { size: 'int32' }, { s: 'double' }),
  aModule('all', { points: 'vector2[]', one: 'vector2' }),
]);

/** Returns the graph with the first adapter applied. */
function adapted(from: PortRef, to: PortRef): Graph {
  const fit = fitOf(graph, from, to, library);
  if (fit.fits) throw new Error('it fits as it is');
  const command = adaptCommand(graph, from, to, fit.offers[0]!, { uuid: uuids() });
  const after = applyCommand(graph, command).graph;
  for (const wire of after.wires.values()) {
    expect(fitOf(after, wire.from, wire.to)).toEqual({ fits: true });
  }
  return after;
}

describe('what is offered for a misfit', () => {
  it('picks a part of the value', () => {
    const after = adapted(ref(graph, 'pose.pose'), ref(graph, 'size.size'));
    expect(wiresIn(after)).toEqual([
      'new1.number > size.size (/Test/pick-field/number)',
      'pose.pose > new1.value (/Test/pose/pose)',
    ]);
    const node = after.nodes.get('module:new1');
    expect(node?.kind === 'module' && [...node.constants]).toEqual([
      ['path', '{"string":"position.x"}'],
    ]);
  });

  it('gathers what a module puts out', () => {
    const one = aGraphOf([
      aModule('a', {}, { v: 'vector2' }),
      aModule('all', { points: 'vector2[]' }),
    ]);
    const [from, to] = [ref(one, 'a.v'), ref(one, 'all.points')];
    const fit = fitOf(one, from, to);
    const offer = fit.fits ? undefined : fit.offers[0];
    const { graph: after } = applyCommand(
      one,
      adaptCommand(one, from, to, offer!, { uuid: uuids() }),
    );
    expect(wiresIn(after)).toEqual(['a.v > topic:/Test/a/v', 'muxer:new1 > all.points']);
    expect(after.nodes.get('muxer:new1')).toMatchObject({ mux: { topicGlob: '/Test/a/v' } });
  });

  it('spreads a list from module to module', () => {
    const after = adapted(ref(graph, 'pose.points'), ref(graph, 'all.points'));
    expect(wiresIn(after)).toEqual(['muxer:new2 > all.points', 'pose.points > demuxer:new1']);
  });
});

describe('a wire in the hand', () => {
  it('lights what it fits', () => {
    expect(fittingPorts(graph, ref(graph, 'pose.pose'))).toEqual([ref(graph, 'pose.p')]);
    expect(fittingPorts(graph, ref(graph, 'size.size'))).toEqual([ref(graph, 'size.s')]);
  });

  it('dropped on nothing is offered what fits', () => {
    const topics = [
      { topic: '/number', format: 'double' },
      { topic: '/point', format: 'ubii.dataStructure.Vector2' },
      { topic: '/unknown', format: '' },
    ];
    const offers = fittingNodes(graph, ref(graph, 'all.one'), library, topics);
    expect(offers.map(({ kind, label }) => `${kind} ${label}`)).toEqual([
      'topic /point',
      'constant Constant',
      'module average-positions',
      'module low-pass-vector2',
      'module merge-vector2',
      'module mirror-pointer',
      'module one-euro-filter-vector2',
      'module speed-vector2',
      'module pick-field',
      'topic /unknown',
    ]);
    for (const offer of offers) {
      const command = offerCommand(graph, ref(graph, 'all.one'), offer, { uuid: uuids() });
      expect(applyCommand(graph, command).graph.wires.size, offer.label).toBe(1);
    }
  });

  it('from a list is offered a demuxer', () => {
    const offers = fittingNodes(graph, ref(graph, 'pose.points'), [], []);
    expect(offers).toEqual([{ kind: 'demuxer', label: 'Demuxer', dataType: 'vector2' }]);
  });
});
